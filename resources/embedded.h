#pragma once

#include <span>
#include <string_view>

namespace furrow {

/// A file of resources/ that is part of the program, so that it is there wherever the program is.
struct EmbeddedFile {
    std::string_view name;  ///< without folder and extension: "agbot"
    std::string_view text;  ///< UTF-8
};

/// resources/machines/*.json in the order people see them.
std::span<const EmbeddedFile> embeddedMachines();

/// resources/paper_fields/paper_fields.geojson.
std::string_view embeddedPaperFields();

}  // namespace furrow
