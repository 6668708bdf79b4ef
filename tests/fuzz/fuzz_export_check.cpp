#include "planner/io/check/export_check.h"
#include "planner/io/formats/registry.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

using namespace furrow;

/// Whatever the bytes are: no crash, no bad address, no memory without bounds. The first byte chooses the
/// format.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text{reinterpret_cast<const char*>(data), size};
    if (text.empty()) {
        return 0;
    }
    static const std::vector<FieldContent> meant{
        {.field = {.id = "a",
                   .name = "a",
                   .parts = {{.outer = {{9.0, 52.0}, {9.003, 52.0}, {9.003, 52.002}}, .holes = {}}}}}};
    const Format& format = formats()[static_cast<unsigned char>(text.front()) % formats().size()];
    const ExportJob job{.fields = meant, .plan = nullptr, .options = {}, .job = {}};
    // The name says what is in it.
    const char* const names[] = {"TASKDATA/TASKDATA.XML",
                                 "a/Boundary.txt",
                                 "boundary.shp",
                                 "a.kmz",
                                 "a_EPSG32632.dxf",
                                 "a.mcap",
                                 "a.db3",
                                 "a.rec",
                                 "a/Field.txt"};
    std::vector<FileToWrite> files;
    for (const char* name : names) {
        files.push_back({name, [text] { return std::string{text.substr(1)}; }});
    }
    (void)checkExport(format, job, files);
    return 0;
}
