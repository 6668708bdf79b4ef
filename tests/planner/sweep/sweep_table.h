#pragma once

#include "tests/planner/sweep/sweep_verdict.h"

#include <map>
#include <string>

namespace furrow::test {

/// What became of all cases, by what was changed; of pairs each setting has its row.
class SweepTable {
public:
    /// @param command  with which a person plans the case again
    void add(const SweepCase& each, const SweepOutcome& outcome, const std::string& command);

    int failures() const { return failures_; }
    /// A line for each change and one for all.
    std::string text() const;
    /// What failed, by change: how often, and of the first case the reason and the command that plans it
    /// again.
    std::string failuresText() const;

private:
    struct Row {
        std::map<SweepVerdict, int> counts;
        double slowest = 0.0;  ///< time over that with default settings
        std::string slowestAt;
        double quickest = 1.0;  ///< likewise, of what is drivable and covers as much
        std::string quickestAt;
        double leastCovered = 0.0;  ///< of the area, against default settings
        std::string leastCoveredAt;
        int blockedMore = 0;     ///< of those that are blocked by default, too: by more findings than that
        int changesNothing = 0;  ///< of those that are planned
    };
    struct Failures {
        int count = 0;
        int of = 0;
        std::string first;
    };
    std::string lineOf(const std::string& name, const Row& row) const;
    static void merge(Row& row, const std::string& at, const SweepOutcome& outcome);

    std::vector<std::string> order_;
    std::map<std::string, Row> rows_;
    std::map<std::string, Failures> failed_;  ///< by the whole change
    Row all_;
    int failures_ = 0;
};

/// One line for one case, its parts divided by tabs, without its end.
std::string recordOf(const SweepCase& each, const SweepOutcome& outcome);
/// The names of these parts, in a line of its own.
std::string recordHeader();
/// Reads such a line; nothing where it is none.
std::optional<SweepOutcome> outcomeOf(const std::string& record);

}  // namespace furrow::test
