#pragma once

#include "tests/planner/sweep/sweep_cases.h"

#include <optional>
#include <string>
#include <vector>

namespace furrow::test {

enum class SweepVerdict {
    Drivable,
    Refused,     ///< with the setting, or as it is with default settings
    Told,        ///< blocked by findings that name the setting
    DefaultToo,  ///< blocked by findings of kinds that block it with default settings, too, about as often
    Failed,
    LeftOut,  ///< there is no such value at this site
};

std::string_view verdictName(SweepVerdict verdict);
std::optional<SweepVerdict> verdictFrom(std::string_view name);

/// What came of one case.
struct SweepOutcome {
    SweepVerdict verdict = SweepVerdict::Failed;
    std::string reason;    ///< of what failed; of what is refused, the error
    std::string settings;  ///< "--set a=1 --set b=2"
    int blocking = 0;      ///< findings
    int standardBlocking = 0;
    double coveredShare = 0.0;
    double moreCovered = 0.0;  ///< than with default settings, of the area to be worked
    double timeS = 0.0;        ///< of the driven path
    double timeRatio = 0.0;    ///< to that with default settings; 0 where there is none
    double planningS = 0.0;
    bool changesNothing = false;  ///< the path is that with default settings
};

/// Whether a finding says that it comes of this change: it carries the change of one of its settings, or
/// names one by key, by name or by what was chosen.
bool tells(const Finding& finding, const SweepChange& change);

/// One shape with one machine: planned with default settings once, then with any.
class SweepBench {
public:
    /// @param folder   for the files that settings name; there already
    /// @param planned  called after each plan
    SweepBench(const std::string& shape, const std::string& machine, std::filesystem::path folder,
               std::function<void()> planned = {});

    SweepOutcome run(const SweepChange& change) const;
    Result<std::shared_ptr<const Plan>> plan(const Settings& settings) const;
    /// Plans once more with each change that a finding carries, and says what is wrong with the first that is
    /// refused, or after which that finding is still near its place or more findings of some kind block;
    /// empty where all help.
    std::string badAdvice(const Plan& plan) const;
    const SweepSite& site() const { return site_; }

private:
    SweepOutcome judged(const SweepChange& change, const Settings& settings) const;
    void measure(SweepOutcome& outcome, const Plan& plan) const;

    SweepSite site_;
    std::function<void()> planned_;
    std::optional<Error> refused_;  ///< with default settings
};

}  // namespace furrow::test
