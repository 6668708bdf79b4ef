#pragma once

#include "planner/core/result.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"
#include "planner/settings/settings.h"
#include "planner/units/quantity.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

/// One of several runs that share the fields among them.
struct Shard {
    std::size_t number = 1;  ///< from 1
    std::size_t count = 1;
};

/// Every field of some files: those of projects with the machine and settings of their plans, others with the
/// library's first machine and the standard settings; what is asked for here wins.
struct BatchTask {
    std::vector<std::filesystem::path> files;
    std::optional<Machine> machine;
    Settings settings;
    std::filesystem::path out;
    std::vector<std::string_view> formats;  ///< of the plan folders, besides summary.json
    Shard shard;
    bool resume = false;  ///< fields that an earlier run has finished are not planned again
    /// Fields outside of these are left out, unplanned and uncounted.
    Area smallest;
    std::optional<Area> largest;
};

/// What became of one field.
enum class BatchOutcome { Drivable, Blocked, Refused, Failed };

/// One field of a batch; one line of its record.
struct BatchRecord {
    std::string key;      ///< of everything that the result was made from
    std::string run;      ///< of what the whole batch has in common
    std::string file;     ///< absolute
    std::size_t number = 0;  ///< of the field in its file, from 1
    std::string id;
    std::string folder;  ///< of its plan, below the batch's; empty where there is none
    BatchOutcome outcome = BatchOutcome::Failed;
    std::string error;       ///< where it was refused or failed
    Area area;
    std::size_t vertices = 0;
    Length breadth;  ///< of the widest circle inside the field
    std::string machine;  ///< its name
    Length width;         ///< the machine's operating width
    std::optional<double> covered;
    std::optional<double> coveredOfReachable;
    std::optional<Area> missed;
    std::optional<Area> outside;
    std::optional<Length> clearance;
    int swaths = 0;
    int turns = 0;
    int undrivableTurns = 0;
    std::map<std::string, int> blocking;  ///< findings in the way, by their kind
    Duration time;                        ///< of planning and audit
};

/// Figures over many fields.
struct BatchTotals {
    std::size_t fields = 0;
    std::size_t planned = 0;
    std::size_t drivable = 0;
    double medianCovered = 0.0;
    double tenthCovered = 0.0;  ///< 10th percentile
    double medianCoveredOfReachable = 0.0;
    Duration medianTime;
    Duration slowTime;  ///< 95th percentile
    int turns = 0;
    int undrivableTurns = 0;
    /// Fields with at least one finding in the way, by its kind.
    std::map<std::string, std::size_t> fieldsBlocked;
};

struct BatchReport {
    std::vector<BatchRecord> records;  ///< by file and number, earlier runs' too when resumed
    BatchTotals wide;                  ///< fields at least five operating widths broad
    BatchTotals narrow;                ///< the others
};

/// Where a shard writes its record: "batch.jsonl", "batch-2-of-8.jsonl".
std::filesystem::path batchRecordPath(const std::filesystem::path& out, const Shard& shard);

/// Plans every field of the task, several at a time, and writes a folder for each; a line of the record is
/// appended and flushed as soon as a field is done, so that a run that ends half-way can be resumed.
///
/// A folder holds one batch: a run that would mix its results with those of other fields, another machine or other
/// settings is refused, with or without `resume`. A field's folder is called after its file, its number and its key, so
/// that files of the same name do not meet.
///
/// @return what became of each. A field that is refused does not end the batch. Usage: the folder holds the results
///         of other inputs. ReadFailed, InputRefused: a file that cannot be read. WriteFailed. Cancelled: the record keeps what was done.
Result<BatchReport> runBatch(const BatchTask& task, const JobContext& job);

/// The report as one JSON object: {"wide": totals, "narrow": totals}.
std::string batchJson(const BatchReport& report);

}  // namespace furrow
