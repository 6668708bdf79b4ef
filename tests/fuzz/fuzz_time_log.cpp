#include "planner/io/formats/isoxml/isoxml.h"
#include "tests/fuzz/joined_files.h"

#include <cstdint>

using namespace furrow;

/// Whatever the bytes are: no crash, no bad address, no memory without bounds. A task, the header of its log,
/// and the log itself.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::filesystem::path folder = fuzz::ownFolder();
    fuzz::writeDivided({reinterpret_cast<const char*>(data), size}, folder,
                       {"TASKDATA.XML", "TLG00001.XML", "TLG00001.BIN"});
    if (const auto opened = FileFolder::open(folder)) {
        (void)isoxmlTracks(*opened, "fuzz", {});
    }
    return 0;
}
