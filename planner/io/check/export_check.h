#pragma once

#include "planner/io/content/export_job.h"

#include <span>

namespace furrow {

struct Format;

/// What receivers would stumble over in files that are well-formed, and that no schema notices (DESIGN 31):
/// each file is taken apart again by code of its own and looked at for
/// - names of files that a FAT stick, Windows or a terminal refuses, files that belong to others and are not
/// there;
/// - coordinates that are no numbers, out of range, or far from the field (longitude and latitude exchanged);
/// - rings that are open or must not be closed, too short, the wrong way round, that cross themselves, holes
/// outside;
/// - areas, widths, counts and announced numbers that are not those meant; a coordinate system that is not
/// named;
/// - names twice, too long, or in letters that the receiver cannot show; lines without a direction;
/// - paths that leave the plan's, or go another way, times that fall, headings across the motion, speeds in
/// the
///   wrong unit; and the rules of each format (kinds of points of a guidance pattern, rows of a mission,
///   ...).
///
/// @param files  what `format` made of the job; nothing is looked at where it is not written
/// @return what was looked at, and one sentence for each kind of mistake and file, the worst first
/// Cost: O(n log n) for n points.
ExportChecks checkExport(const Format& format, const ExportJob& job, std::span<const FileToWrite> files);

}  // namespace furrow
