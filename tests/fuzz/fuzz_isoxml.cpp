#include "planner/io/formats/isoxml/isoxml_links.h"
#include "planner/io/formats/isoxml/isoxml_reader.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

using namespace furrow;

/// Whatever the bytes are: no crash, no bad address, no memory without bounds.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text{reinterpret_cast<const char*>(data), size};
    const auto part = [text](const std::string&) -> Result<std::string> { return std::string{text}; };
    (void)readIsoxml(text, "fuzz", part, {});
    (void)isoxmlLinks(text);
    return 0;
}
