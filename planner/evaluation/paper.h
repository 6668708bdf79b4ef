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

/// Something the paper says, and what came out here.
struct PaperStatement {
    std::string paper;
    std::string found;
    std::optional<bool> agrees;  ///< nothing where it cannot be told
};

struct PaperFile {
    std::string name;  ///< "experiment1_headings.csv"
    std::string text;
};

struct PaperExperiment {
    int number = 0;
    std::string title;
    std::vector<PaperStatement> statements;
    std::vector<std::string> notes;  ///< what differs from the paper, what could not be run
    std::vector<PaperFile> files;    ///< CSV and SVG
};

/// The best heading by each objective, without headland, for a rectangle, a circle-like and a slanted field
/// of 100 m². The paper's own outlines are not public: these are like them, long enough for its numbers of
/// turns with swaths of 2.5 m. Deterministic. Cost: milliseconds. Cancelled.
Result<PaperExperiment> paperHeadings(const JobContext& job);

/// Convex fields scaled to 1 ha: three objectives, three patterns, two curves; length with turns against
/// length with turns in place.
/// @param fields  at least one; each is scaled about its middle
/// @return the files, notes of fields that could not be planned. Cancelled. Errors of the settings where the
///         planner lacks a pattern.
/// Deterministic. Cost: 18 plans for each field.
Result<PaperExperiment> paperTurning(std::span<const FieldSource> fields, const JobContext& job);

/// Time against area for each objective, with both laws of the paper fitted. Figures depend on the machine
/// and on what else it does. Cost: seconds. Cancelled.
Result<PaperExperiment> paperTiming(const JobContext& job);

/// The field experiment: a narrow field in a direction of its own, curves tighter than the machine can
/// drive, and a drive laid over the plan. The drive is simulated, and says so; `furrow-cli compare` lays
/// recorded ones over a plan. Deterministic. Cancelled.
Result<PaperExperiment> paperDrive(const JobContext& job);

/// The 38 fields that are part of the program (resources/paper_fields).
std::vector<FieldSource> paperFields();

}  // namespace furrow
