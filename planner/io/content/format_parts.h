#pragma once

#include "planner/core/file_in_memory.h"
#include "planner/core/result.h"
#include "planner/io/content/export_job.h"
#include "planner/io/content/imported_fields.h"
#include "planner/io/content/received_content.h"
#include "planner/io/files/chosen_file.h"
#include "planner/jobs/job.h"
#include "planner/track/recorded_track.h"

#include <span>
#include <vector>

namespace furrow {

// What a format is made of: the common signatures behind the rows of the registry (io/formats/registry.cpp).

/// How sure a format is that what was chosen is its own. The surest reads it, of equals the first of the
/// registry.
enum class Recognition {
    No,
    Perhaps,  ///< nothing speaks against it: reading it will tell
    Likely,   ///< by its content or its names
    Certain,  ///< whatever else lies in it, or it may look like
};

/// Cost: a look into the beginning of a file, or into the names of a folder or zip.
using FormatRecogniser = Recognition(const ChosenFile& chosen);

/// Fields with everything that belongs to them, of what was recognised. Errors as readFields.
using FieldReader = Result<ImportedFields>(const ChosenFile& chosen, const JobContext& job);

/// What a machine drove, of what was recognised. Errors as readTracks.
using TrackReader = Result<TrackFile>(const ChosenFile& chosen, const JobContext& job);

/// @return InputRefused: the format cannot hold this plan or these fields, and why. WriteFailed: a library
///         refused. Cancelled.
using FormatWriter = Result<FormatFiles>(const ExportJob& job);

/// What a receiver finds in written files: taken apart by code that shares nothing with the writer and judges
/// nothing. Whatever the bytes are: what cannot be read is a fault.
using ContentFinder = std::vector<ReceivedContent>(std::span<const FileInMemory> files, const ExportJob& job);

}  // namespace furrow
