#include "planner/io/content/imported_fields.h"

#include "planner/core/file_error.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace furrow {

Result<std::vector<FieldSource>> boundariesOf(ImportedFields imported, const std::string& name) {
    if (imported.fields.empty()) {
        return std::unexpected(
            inputRefused(name,
                         message("there is no field boundary in it, only {}",
                                 counted("{} open line", "{} open lines", imported.looseLines.size())),
                         "export the field with its boundary"));
    }
    std::vector<FieldSource> fields;
    for (FieldContent& content : imported.fields) {
        fields.push_back(std::move(content.field));
    }
    std::ranges::move(imported.notes, std::back_inserter(fields.front().repairs));
    return fields;
}

void GatheredFields::take(Result<ImportedFields>&& read, const std::string& where) {
    if (read) {
        std::ranges::move(read->fields, std::back_inserter(all_.fields));
        std::ranges::move(read->looseLines, std::back_inserter(all_.looseLines));
        std::ranges::move(read->notes, std::back_inserter(all_.notes));
        any_ = true;
        return;
    }
    if (!first_) {
        first_ = read.error();
    }
    all_.notes.push_back({message("left out: {}", read.error().what), where});
}

Result<ImportedFields> GatheredFields::result() && {
    return any_ ? Result<ImportedFields>{std::move(all_)} : std::unexpected(*first_);
}

}  // namespace furrow
