#include "tests/planner/sweep/sweep_table.h"

#include <algorithm>
#include <charconv>
#include <format>

namespace furrow::test {

namespace {

constexpr std::size_t kParts = 14;
// A path that leaves more of the field is no quicker one.
constexpr double kAsMuch = 1e-3;

std::string plain(std::string text) {
    std::ranges::replace_if(
        text, [](char letter) { return letter == '\t' || letter == '\n' || letter == '\r'; }, ' ');
    return text;
}

double numberOf(const std::string& text) {
    double value = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

std::vector<std::string> rowsOf(const SweepChange& change) {
    if (change.changed.size() < 2) {
        return {change.name()};
    }
    std::vector<std::string> rows;
    std::ranges::transform(change.changed, std::back_inserter(rows), &SweepSetting::told);
    return rows;
}

}  // namespace

void SweepTable::merge(Row& row, const std::string& at, const SweepOutcome& outcome) {
    ++row.counts[outcome.verdict];
    row.blockedMore +=
        outcome.verdict == SweepVerdict::DefaultToo && outcome.blocking > outcome.standardBlocking ? 1 : 0;
    row.changesNothing += outcome.changesNothing ? 1 : 0;
    if (outcome.timeRatio > row.slowest) {
        row.slowest = outcome.timeRatio;
        row.slowestAt = at;
    }
    const bool asGood = outcome.verdict == SweepVerdict::Drivable && outcome.moreCovered > -kAsMuch;
    if (asGood && outcome.timeRatio > 0.0 && outcome.timeRatio < row.quickest) {
        row.quickest = outcome.timeRatio;
        row.quickestAt = at;
    }
    if (outcome.timeRatio > 0.0 && outcome.moreCovered < row.leastCovered) {
        row.leastCovered = outcome.moreCovered;
        row.leastCoveredAt = at;
    }
}

void SweepTable::add(const SweepCase& each, const SweepOutcome& outcome, const std::string& command) {
    const std::string at = each.shape + " " + each.machine;
    for (const std::string& name : rowsOf(each.change)) {
        if (!rows_.contains(name)) {
            order_.push_back(name);
        }
        merge(rows_[name], at, outcome);
    }
    merge(all_, at, outcome);
    Failures& failures = failed_[each.change.name()];
    ++failures.of;
    if (outcome.verdict == SweepVerdict::Failed) {
        ++failures_;
        if (++failures.count == 1) {
            failures.first = std::format("    {}\n    {}\n", outcome.reason, command);
        }
    }
}

std::string SweepTable::lineOf(const std::string& name, const Row& row) const {
    const auto count = [&row](SweepVerdict verdict) {
        const auto found = row.counts.find(verdict);
        return found == row.counts.end() ? 0 : found->second;
    };
    return std::format(
        "{:<64} {:>8} {:>8} {:>5} {:>8} {:>5} {:>7} {:>5}  {:>6} {:<30} {:>7} {:<30} {:>7} {}\n", name,
        count(SweepVerdict::Drivable), count(SweepVerdict::Refused), count(SweepVerdict::Told),
        count(SweepVerdict::DefaultToo), row.blockedMore, count(SweepVerdict::Failed), row.changesNothing,
        row.slowest > 0.0 ? std::format("{:+.0f} %", 100.0 * (row.slowest - 1.0)) : "", row.slowestAt,
        row.quickest < 1.0 ? std::format("{:+.1f} %", 100.0 * (row.quickest - 1.0)) : "", row.quickestAt,
        row.leastCovered < 0.0 ? std::format("{:+.1f} %", 100.0 * row.leastCovered) : "", row.leastCoveredAt);
}

std::string SweepTable::text() const {
    std::string text = std::format("{:<64} {:>8} {:>8} {:>5} {:>8} {:>5} {:>7} {:>5}  {:<37} {:<38} {}\n",
                                   "setting", "drivable", "refused", "told", "default", "more", "failed",
                                   "same", "slowest path", "quickest path", "least covered");
    for (const std::string& name : order_) {
        text += lineOf(name, rows_.at(name));
    }
    return text + lineOf("all", all_);
}

std::string SweepTable::failuresText() const {
    std::string text;
    for (const auto& [name, failures] : failed_) {
        if (failures.count > 0) {
            text += std::format("{} ({} of {})\n{}", name, failures.count, failures.of, failures.first);
        }
    }
    return text;
}

std::string recordHeader() {
    return "verdict\tshape\tmachine\tchange\tblocking\tblocking_by_default\tcovered\tcovered_more\ttime_"
           "s\ttime_ratio\tplanning_s\t"
           "same\tsettings\treason";
}

std::string recordOf(const SweepCase& each, const SweepOutcome& outcome) {
    return std::format("{}\t{}\t{}\t{}\t{}\t{}\t{:.6f}\t{:.6f}\t{:.1f}\t{:.4f}\t{:.3f}\t{:d}\t{}\t{}",
                       verdictName(outcome.verdict), each.shape, each.machine, each.change.name(),
                       outcome.blocking, outcome.standardBlocking, outcome.coveredShare, outcome.moreCovered,
                       outcome.timeS, outcome.timeRatio, outcome.planningS, outcome.changesNothing,
                       plain(outcome.settings), plain(outcome.reason));
}

std::optional<SweepOutcome> outcomeOf(const std::string& record) {
    std::vector<std::string> parts(1);
    for (const char letter : record) {
        if (letter == '\t') {
            parts.emplace_back();
        } else {
            parts.back() += letter;
        }
    }
    const auto verdict = verdictFrom(parts.front());
    if (parts.size() != kParts || !verdict) {
        return std::nullopt;
    }
    return SweepOutcome{.verdict = *verdict,
                        .reason = parts[13],
                        .settings = parts[12],
                        .blocking = static_cast<int>(numberOf(parts[4])),
                        .standardBlocking = static_cast<int>(numberOf(parts[5])),
                        .coveredShare = numberOf(parts[6]),
                        .moreCovered = numberOf(parts[7]),
                        .timeS = numberOf(parts[8]),
                        .timeRatio = numberOf(parts[9]),
                        .planningS = numberOf(parts[10]),
                        .changesNothing = parts[11] == "1"};
}

}  // namespace furrow::test
