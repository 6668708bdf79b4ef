#pragma once

#include "planner/core/result.h"

#include <span>
#include <string_view>

namespace furrow {

/// One file format: what Furrow does with it.
struct FormatInfo {
    std::string_view id;          ///< as in `--format`
    std::string_view name;        ///< "GeoJSON"
    std::string_view extensions;  ///< "geojson json"
    bool read = false;            ///< boundaries can be read from it
    bool write = false;           ///< plans can be written to it
    std::string_view carries;     ///< one sentence: what a reader finds in it
};

std::span<const FormatInfo> formats();

/// A format that plans can be written to. Usage: there is none of that name; the message lists them.
Result<const FormatInfo*> findPlanFormat(std::string_view id);

}  // namespace furrow
