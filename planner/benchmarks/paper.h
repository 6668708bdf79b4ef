#pragma once

#include "planner/core/result.h"
#include "planner/field/field.h"
#include "planner/jobs/job.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace furrow {

// The experiments of Mier, Valente and de Bruin, "Fields2Cover: an open-source coverage path planning library
// for unmanned agricultural vehicles", IEEE Robotics and Automation Letters 2023,
// doi 10.1109/LRA.2023.3248439, for anyone to run again.

/// A statement of the paper, and the result here.
struct PaperStatement {
    std::string paper;
    std::string found;
    std::optional<bool> agrees;  ///< empty if it cannot be decided
};

struct PaperFile {
    std::string name;  ///< "experiment1_headings.csv"
    std::string text;
};

struct PaperExperiment {
    int number = 0;
    std::string title;
    std::vector<PaperStatement> statements;
    std::vector<std::string> notes;  ///< differences from the paper, parts that could not be run
    std::vector<PaperFile> files;    ///< CSV and SVG
};

/// The best heading by each objective, without headland, for a rectangle, a circle-like and a slanted field
/// of 100 m². The paper's own outlines are not public. These are similar, and long enough for its numbers of
/// turns with swaths of 2.5 m. Deterministic. Cost: milliseconds. Cancelled.
Result<PaperExperiment> paperHeadings(const JobContext& job);

/// Convex fields scaled to 1 ha: three objectives, three patterns, two curves. Compares the length with turns
/// and the length with turns in place.
/// @param fields  at least one; each is scaled about its middle
/// @return the files, and notes of fields that could not be planned. Cancelled. Errors of the settings if the
/// planner lacks a pattern.
/// Deterministic. Cost: 18 plans for each field.
Result<PaperExperiment> paperTurning(std::span<const FieldSource> fields, const JobContext& job);

/// Time against area for each objective, with both laws of the paper fitted. Figures depend on the machine
/// and its other load. Cost: seconds. Cancelled.
Result<PaperExperiment> paperTiming(const JobContext& job);

/// The field experiment: a narrow field in its own direction, curves tighter than the machine can drive, and
/// a drive laid over the plan. The drive is simulated, and the output says so. `furrow-cli compare` lays
/// recorded drives over a plan. Deterministic. Cancelled.
Result<PaperExperiment> paperDrive(const JobContext& job);

/// The 38 fields that are part of the program (resources/paper_fields).
std::vector<FieldSource> paperFields();

}  // namespace furrow
