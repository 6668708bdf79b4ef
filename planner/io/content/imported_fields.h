#pragma once

#include "planner/core/result.h"
#include "planner/io/content/field_content.h"

#include <optional>
#include <string>
#include <vector>

namespace furrow {

/// What a file or folder holds of fields.
struct ImportedFields {
    std::vector<FieldContent> fields;      ///< each with at least one part, not checked yet
    std::vector<GuidanceLine> looseLines;  ///< that belong to none of them
    std::vector<Note> notes;               ///< what was passed over or could not be read, and why
};

/// The fields alone; the notes go to the first of them.
///
/// @param name  of the file, for messages
/// @return InputRefused: no field, only lines.
Result<std::vector<FieldSource>> boundariesOf(ImportedFields imported, const std::string& name);

/// The fields of several sources, as long as one of them can be read; what cannot is left out with a note.
class GatheredFields {
public:
    void take(Result<ImportedFields>&& read, const std::string& where);
    /// The first error where none could be read.
    Result<ImportedFields> result() &&;

private:
    ImportedFields all_;
    bool any_ = false;
    std::optional<Error> first_;
};

}  // namespace furrow
