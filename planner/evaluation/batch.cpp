#include "planner/evaluation/batch.h"

#include "planner/core/json_text.h"
#include "planner/evaluation/batch_key.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/io/delivery/plan_folder.h"
#include "planner/io/import/boundary_import.h"
#include "planner/jobs/parallel.h"
#include "planner/plan/plan.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <format>
#include <fstream>
#include <memory>
#include <mutex>
#include <ranges>
#include <set>
#include <system_error>
#include <utility>

namespace furrow {

namespace {

using Json = nlohmann::ordered_json;

// Narrower fields, in operating widths, are counted separately.
constexpr double kNarrowWidths = 5.0;

constexpr std::array<std::pair<BatchOutcome, std::string_view>, 4> kOutcomes{{
    {BatchOutcome::Drivable, "drivable"},
    {BatchOutcome::Blocked, "blocked"},
    {BatchOutcome::Refused, "refused"},
    {BatchOutcome::Failed, "failed"},
}};

std::string_view idOf(BatchOutcome outcome) {
    return std::ranges::find(kOutcomes, outcome, &std::pair<BatchOutcome, std::string_view>::first)->second;
}

template <class Value>
Json orNull(const std::optional<Value>& value) {
    if constexpr (std::is_same_v<Value, double>) {
        return value ? Json(*value) : Json(nullptr);
    } else {
        return value ? Json(value->si()) : Json(nullptr);
    }
}

Json jsonOf(const BatchRecord& record) {
    return {{"key", record.key},
            {"run", record.run},
            {"file", record.file},
            {"number", record.number},
            {"id", record.id},
            {"folder", record.folder},
            {"outcome", idOf(record.outcome)},
            {"error", record.error},
            {"area_m2", record.area.si()},
            {"vertices", record.vertices},
            {"breadth_m", record.breadth.si()},
            {"machine", record.machine},
            {"width_m", record.width.si()},
            {"covered", orNull(record.covered)},
            {"covered_of_reachable", orNull(record.coveredOfReachable)},
            {"missed_m2", orNull(record.missed)},
            {"outside_m2", orNull(record.outside)},
            {"min_clearance_m", orNull(record.clearance)},
            {"swaths", record.swaths},
            {"turns", record.turns},
            {"undrivable_turns", record.undrivableTurns},
            {"blocking", record.blocking},
            {"time_ms", record.time.si() * 1e3}};
}

std::optional<double> numberIn(const Json& json, const char* key) {
    return json.contains(key) && json[key].is_number() ? std::optional{json[key].get<double>()}
                                                       : std::nullopt;
}

/// A line of an earlier run. Empty for a line that was cut short.
std::optional<BatchRecord> recordFrom(const std::string& line) {
    const Json json = jsonOrDiscarded<Json>(line);
    if (!json.is_object() || !json.contains("time_ms")) {
        return std::nullopt;
    }
    const std::string outcome = json.value("outcome", "");
    const auto known = std::ranges::find(kOutcomes, std::string_view{outcome},
                                         &std::pair<BatchOutcome, std::string_view>::second);
    if (known == kOutcomes.end()) {
        return std::nullopt;
    }
    BatchRecord record{.key = json.value("key", ""),
                       .run = json.value("run", ""),
                       .file = json.value("file", ""),
                       .number = json.value("number", std::size_t{0}),
                       .id = json.value("id", ""),
                       .folder = json.value("folder", ""),
                       .outcome = known->first,
                       .error = json.value("error", ""),
                       .area = squareMetres(numberIn(json, "area_m2").value_or(0.0)),
                       .vertices = json.value("vertices", std::size_t{0}),
                       .breadth = metres(numberIn(json, "breadth_m").value_or(0.0)),
                       .machine = json.value("machine", ""),
                       .width = metres(numberIn(json, "width_m").value_or(0.0)),
                       .covered = numberIn(json, "covered"),
                       .coveredOfReachable = numberIn(json, "covered_of_reachable"),
                       .missed = numberIn(json, "missed_m2").transform(squareMetres),
                       .outside = numberIn(json, "outside_m2").transform(squareMetres),
                       .clearance = numberIn(json, "min_clearance_m").transform(metres),
                       .swaths = json.value("swaths", 0),
                       .turns = json.value("turns", 0),
                       .undrivableTurns = json.value("undrivable_turns", 0),
                       .blocking = json.value("blocking", std::map<std::string, int>{}),
                       .time = seconds(numberIn(json, "time_ms").value_or(0.0) / 1e3)};
    return record;
}

std::vector<BatchRecord> recordsIn(const std::filesystem::path& path) {
    std::vector<BatchRecord> records;
    std::ifstream file{path};
    for (std::string line; std::getline(file, line);) {
        if (auto record = recordFrom(line)) {
            records.push_back(std::move(*record));
        }
    }
    return records;
}

/// The record on disk, one line at a time.
class RecordFile {
public:
    /// Begins with these lines.
    Result<void> open(const std::filesystem::path& path, const std::vector<BatchRecord>& known) {
        path_ = path;
        file_.open(path, std::ios::trunc);
        for (const BatchRecord& record : known) {
            file_ << jsonOf(record).dump() << '\n';
        }
        file_.flush();
        return written();
    }

    Result<void> add(const BatchRecord& record) {
        const std::lock_guard lock{mutex_};
        file_ << jsonOf(record).dump() << '\n';
        file_.flush();
        return written();
    }

private:
    Result<void> written() const {
        if (file_) {
            return {};
        }
        return std::unexpected(
            Error{.code = ErrorCode::WriteFailed,
                  .what = std::format("could not write: {}", std::strerror(errno)),
                  .where = path_.string(),
                  .remedy = "make room or choose another folder; --resume goes on from here"});
    }

    std::filesystem::path path_;
    std::ofstream file_;
    std::mutex mutex_;
};

/// Held while a batch writes to its record. Two batches at once would overwrite each other's lines.
class RecordLock {
public:
    explicit RecordLock(const std::filesystem::path& path)
        : file_{::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)} {
        isTaken_ = file_ >= 0 && ::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    }
    ~RecordLock() {
        if (file_ >= 0) {
            ::close(file_);
        }
    }
    RecordLock(const RecordLock&) = delete;
    RecordLock& operator=(const RecordLock&) = delete;

    /// Whether another run holds it. If no file can be made here, writing reports that.
    bool isTaken() const { return isTaken_; }

private:
    int file_;
    bool isTaken_ = false;
};

struct BatchField {
    std::filesystem::path file;  ///< absolute
    std::size_t number = 0;
    std::string key;
    FieldTask task;
};

/// The same file under any of its names.
std::filesystem::path placeOf(const std::filesystem::path& file) {
    std::error_code failed;
    const std::filesystem::path place = std::filesystem::weakly_canonical(file, failed);
    return failed ? std::filesystem::absolute(file, failed) : place;
}

Result<std::vector<BatchField>> fieldsOf(const BatchTask& task, const std::string& run,
                                         const JobContext& job) {
    std::vector<BatchField> fields;
    std::set<std::filesystem::path> seen;
    std::size_t all = 0;
    for (const std::filesystem::path& named : task.files) {
        const std::filesystem::path file = placeOf(named);
        if (!seen.insert(file).second) {
            continue;
        }
        auto tasks =
            readFieldTasks(named, {.planName = {}, .machine = task.machine, .settings = task.settings},
                           {.stop = job.stop, .progress = {}, .threads = job.threads});
        if (!tasks) {
            return std::unexpected(tasks.error());
        }
        for (std::size_t i = 0; i < tasks->size(); ++i) {
            const Area area = areaOf((*tasks)[i].source);
            if (area < task.smallest || (task.largest && area > *task.largest)) {
                continue;
            }
            // Dealt out like cards, since large fields lie side by side in most files.
            if (all++ % task.shard.count == task.shard.number - 1) {
                fields.push_back({.file = file,
                                  .number = i + 1,
                                  .key = fieldKey(file, i + 1, (*tasks)[i], run),
                                  .task = std::move((*tasks)[i])});
            }
        }
    }
    return fields;
}

void fill(BatchRecord& record, const Plan& plan) {
    record.outcome = plan.drivable() ? BatchOutcome::Drivable : BatchOutcome::Blocked;
    record.covered = plan.audit.coveredShare;
    record.coveredOfReachable = plan.audit.coveredOfReachable;
    record.missed = plan.audit.missed;
    record.outside = plan.audit.outside;
    record.clearance = plan.audit.minClearance;
    record.swaths = static_cast<int>(plan.swaths.swaths.size());
    record.turns = plan.path.turnCount();
    record.undrivableTurns = plan.path.undrivableCount();
    record.time = plan.timings.total;
    for (const Finding& finding : plan.findings) {
        if (finding.severity == Severity::Blocking) {
            ++record.blocking[std::string{kindId(finding)}];
        }
    }
}

/// WriteFailed and Cancelled end the batch. Every other result becomes part of the record.
Result<BatchRecord> planned(const BatchField& each, const BatchTask& task, const std::string& run,
                            const JobContext& job) {
    BatchRecord record{.key = each.key,
                       .run = run,
                       .file = each.file.string(),
                       .number = each.number,
                       .id = each.task.source.id,
                       .folder = {},
                       .outcome = BatchOutcome::Failed,
                       .error = {},
                       .area = areaOf(each.task.source),
                       .machine = each.task.machine.name(),
                       .width = each.task.machine.operatingWidth()};
    const auto unplanned = [&record](const Error& error) -> Result<BatchRecord> {
        if (error.code == ErrorCode::Cancelled || error.code == ErrorCode::WriteFailed) {
            return std::unexpected(error);
        }
        record.outcome = error.code == ErrorCode::InputRefused ? BatchOutcome::Refused : BatchOutcome::Failed;
        record.error = error.line();
        return record;
    };
    auto field = Field::create(each.task.source, job);
    if (!field) {
        return unplanned(field.error());
    }
    record.vertices = field->vertexCount();
    const auto breadth = breadthOf(field->workable(), job);
    if (!breadth) {
        return unplanned(breadth.error());
    }
    record.breadth = *breadth;
    const auto plan = planRequest(std::make_shared<const Field>(std::move(*field)), each.task.machine,
                                  each.task.settings, job)
                          .and_then([&job](const PlanRequest& request) { return makePlan(request, job); });
    if (!plan) {
        return unplanned(plan.error());
    }
    fill(record, **plan);
    record.folder = std::format("{}-{:05}-{}", each.file.stem().string(), each.number, each.key.substr(0, 8));
    const auto written = writePlanFolder(**plan, task.out / record.folder, task.formats, job);
    if (!written) {
        return unplanned(written.error());
    }
    return record;
}

template <class Value>
Value percentile(std::vector<Value> values, double share) {
    if (values.empty()) {
        return Value{};
    }
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
    std::ranges::nth_element(values, values.begin() + at);
    return values[static_cast<std::size_t>(at)];
}

BatchTotals totalsOf(const std::vector<const BatchRecord*>& records) {
    BatchTotals totals{.fields = records.size()};
    std::vector<double> covered;
    std::vector<double> coveredOfReachable;
    std::vector<Duration> times;
    for (const BatchRecord* record : records) {
        if (record->outcome != BatchOutcome::Drivable && record->outcome != BatchOutcome::Blocked) {
            continue;
        }
        ++totals.planned;
        totals.drivable += record->outcome == BatchOutcome::Drivable ? 1 : 0;
        covered.push_back(record->covered.value_or(0.0));
        coveredOfReachable.push_back(record->coveredOfReachable.value_or(0.0));
        times.push_back(record->time);
        totals.turns += record->turns;
        totals.undrivableTurns += record->undrivableTurns;
        for (const auto& [kind, count] : record->blocking) {
            ++totals.fieldsBlocked[kind];
        }
    }
    totals.medianCovered = percentile(covered, 0.5);
    totals.tenthCovered = percentile(covered, 0.1);
    totals.medianCoveredOfReachable = percentile(coveredOfReachable, 0.5);
    totals.medianTime = percentile(times, 0.5);
    totals.slowTime = percentile(times, 0.95);
    return totals;
}

Json jsonOf(const BatchTotals& totals) {
    return {{"fields", totals.fields},
            {"planned", totals.planned},
            {"drivable", totals.drivable},
            {"covered_median", totals.medianCovered},
            {"covered_p10", totals.tenthCovered},
            {"covered_of_reachable_median", totals.medianCoveredOfReachable},
            {"time_ms_median", totals.medianTime.si() * 1e3},
            {"time_ms_p95", totals.slowTime.si() * 1e3},
            {"turns", totals.turns},
            {"undrivable_turns", totals.undrivableTurns},
            {"fields_blocked", totals.fieldsBlocked}};
}

BatchReport reportOf(std::vector<BatchRecord> records) {
    BatchReport report;
    std::ranges::sort(records, {},
                      [](const BatchRecord& record) { return std::pair{record.file, record.number}; });
    report.records = std::move(records);
    std::vector<const BatchRecord*> wide;
    std::vector<const BatchRecord*> narrow;
    for (const BatchRecord& record : report.records) {
        // A field that was refused before its breadth was known counts with the others.
        const bool isNarrow = record.breadth > metres(0.0) && record.breadth < kNarrowWidths * record.width;
        (isNarrow ? narrow : wide).push_back(&record);
    }
    report.wide = totalsOf(wide);
    report.narrow = totalsOf(narrow);
    return report;
}

}  // namespace

std::filesystem::path batchRecordPath(const std::filesystem::path& out, const Shard& shard) {
    return out / (shard.count == 1 ? "batch.jsonl"
                                   : std::format("batch-{}-of-{}.jsonl", shard.number, shard.count));
}

namespace {

/// A folder holds one batch. For other shards, only the common inputs of all shards can be checked.
Result<void> checkFolder(const BatchTask& task, const std::vector<BatchField>& fields,
                         const std::string& run) {
    const auto other = [&task](const BatchRecord& record, Message what) {
        return std::unexpected(
            Error{.code = ErrorCode::Usage,
                  .what = std::move(what),
                  .where = message("{}, field {} of {}", task.out.string(), record.number, record.file),
                  .remedy = "choose another folder for --out, or remove this one"});
    };
    const std::filesystem::path own = batchRecordPath(task.out, task.shard);
    std::error_code failed;
    for (const auto& entry : std::filesystem::directory_iterator{task.out, failed}) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("batch") || !name.ends_with(".jsonl")) {
            continue;
        }
        for (const BatchRecord& record : recordsIn(entry.path())) {
            if (record.run != run) {
                return other(
                    record,
                    "the folder holds a batch of another machine, other settings, formats or an older version");
            }
            if (entry.path().filename() != own.filename()) {
                continue;
            }
            if (!std::ranges::contains(fields, record.key, &BatchField::key)) {
                return other(record,
                             "the folder holds a batch of other fields, or this one was changed since");
            }
            if (!task.resume) {
                return std::unexpected(
                    Error{.code = ErrorCode::Usage,
                          .what = "the folder holds this batch, or a part of it",
                          .where = task.out.string(),
                          .remedy = "go on with it by --resume, or choose another folder for --out"});
            }
        }
    }
    return {};
}

}  // namespace

Result<BatchReport> runBatch(const BatchTask& task, const JobContext& job) {
    const std::string run = runKey(task);
    const auto fields = fieldsOf(task, run, job);
    if (!fields) {
        return std::unexpected(fields.error());
    }
    if (const auto checked = checkFolder(task, *fields, run); !checked) {
        return std::unexpected(checked.error());
    }
    std::error_code failed;
    std::filesystem::create_directories(task.out, failed);
    const std::filesystem::path path = batchRecordPath(task.out, task.shard);
    const RecordLock held{path};
    if (held.isTaken()) {
        return std::unexpected(Error{.code = ErrorCode::Usage,
                                     .what = "another run is writing to this folder",
                                     .where = task.out.string(),
                                     .remedy = "wait for it, or choose another folder for --out"});
    }
    std::vector<BatchRecord> records = task.resume ? recordsIn(path) : std::vector<BatchRecord>{};
    RecordFile file;
    if (const auto opened = file.open(path, records); !opened) {
        return std::unexpected(opened.error());
    }
    std::set<std::string> done;
    for (const BatchRecord& record : records) {
        done.insert(record.key);
    }
    std::vector<const BatchField*> open;
    for (const BatchField& field : *fields) {
        if (!done.contains(field.key)) {
            open.push_back(&field);
        }
    }
    std::mutex mutex;
    std::optional<Error> error;
    // A full disk stops all fields, as a cancel does.
    std::stop_source stop;
    const std::stop_callback onCancel{job.stop, [&stop] { stop.request_stop(); }};
    const JobContext all{.stop = stop.get_token(), .progress = job.progress, .threads = job.threads};
    const auto ran = parallelFor(
        open.size(),
        [&](std::size_t i) {
            auto record = planned(*open[i], task, run, {.stop = all.stop, .progress = {}, .threads = 1});
            const Result<void> kept =
                record ? file.add(*record) : Result<void>{std::unexpected(record.error())};
            const std::lock_guard lock{mutex};
            if (!kept) {
                // Those that are stopped by the first one are only cancelled.
                error = error.value_or(kept.error());
                stop.request_stop();
            } else {
                records.push_back(std::move(*record));
            }
        },
        all);
    if (error || !ran) {
        return std::unexpected(error ? *error : ran.error());
    }
    return reportOf(std::move(records));
}

std::string batchJson(const BatchReport& report) {
    return Json{{"wide", jsonOf(report.wide)}, {"narrow", jsonOf(report.narrow)}}.dump(2) + "\n";
}

}  // namespace furrow
