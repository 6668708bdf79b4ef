#pragma once

#include "planner/core/result.h"
#include "planner/io/content/export_job.h"

#include <span>
#include <string_view>

namespace furrow {

/// One file format: what Furrow does with it.
struct FormatInfo {
    std::string_view id;          ///< as in `--format`
    std::string_view name;        ///< "GeoJSON"
    std::string_view extensions;  ///< "geojson json"
    bool read = false;            ///< fields can be read from it
    std::string_view carries;     ///< one sentence: what a reader finds in it
    FormatWriter* writer = nullptr;     ///< of plans; null where none are written
    bool writesFields = false;          ///< also of fields without a plan
    std::string_view folder = {};       ///< of a plan's folder, where it goes; empty for its top
    bool readsTracks = false;           ///< what a machine drove can be read from it, to compare with a plan

    bool writes() const { return writer != nullptr; }
};

/// Every format, in the order in which people see them.
std::span<const FormatInfo> formats();

/// A format that plans can be written to. Usage: there is none of that name; the message lists them.
Result<const FormatInfo*> findPlanFormat(std::string_view id);

}  // namespace furrow
