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

/// One of several runs that share the fields.
struct Shard {
    std::size_t number = 1;  ///< from 1
    std::size_t count = 1;
};

/// Every field of some files. Fields of projects have the machine and settings of their plans. Others have
/// the library's first machine and the standard settings. Values given here override both.
struct BatchTask {
    std::vector<std::filesystem::path> files;
    std::optional<Machine> machine;
    Settings settings;
    std::filesystem::path out;
    std::vector<std::string_view> formats;  ///< of the plan folders, in addition to summary.json
    Shard shard;
    bool resume = false;  ///< skip fields that an earlier run has finished
    /// Fields outside this range are neither planned nor counted.
    Area smallest;
    std::optional<Area> largest;
};

/// The result of one field.
enum class BatchOutcome { Drivable, Blocked, Refused, Failed };

/// One field of a batch, and one line of its record.
struct BatchRecord {
    std::string key;         ///< of all inputs of the result
    std::string run;         ///< of the common inputs of the batch
    std::string file;        ///< absolute
    std::size_t number = 0;  ///< of the field in its file, from 1
    std::string id;
    std::string folder;  ///< of its plan, below the batch's; empty without a plan
    BatchOutcome outcome = BatchOutcome::Failed;
    std::string error;  ///< if it was refused or failed
    Area area;
    std::size_t vertices = 0;
    Length breadth;       ///< of the widest circle inside the field
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
    std::map<std::string, int> blocking;  ///< blocking findings, by their kind
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
    /// The number of fields with at least one blocking finding, by its kind.
    std::map<std::string, std::size_t> fieldsBlocked;
};

struct BatchReport {
    std::vector<BatchRecord> records;  ///< by file and number; with those of earlier runs when resumed
    BatchTotals wide;                  ///< fields at least five operating widths broad
    BatchTotals narrow;                ///< the others
};

/// The record file of a shard: "batch.jsonl", "batch-2-of-8.jsonl".
std::filesystem::path batchRecordPath(const std::filesystem::path& out, const Shard& shard);

/// Plans every field of the task, several at a time, and writes a folder for each. As soon as a field is
/// done, a line of the record is appended and flushed. So an interrupted run can be resumed.
///
/// A folder holds one batch. A run is refused, with or without `resume`, if it would mix its results with
/// those of other fields, another machine or other settings. A field's folder is named after its file, its
/// number and its key, so files of the same name do not collide.
///
/// @return the result of each field. A refused field does not end the batch. Usage: the folder holds the
/// results of other inputs. ReadFailed, InputRefused: a file that cannot be read. WriteFailed. Cancelled: the
/// record keeps the finished fields.
Result<BatchReport> runBatch(const BatchTask& task, const JobContext& job);

/// The report as one JSON object: {"wide": totals, "narrow": totals}.
std::string batchJson(const BatchReport& report);

}  // namespace furrow
