#pragma once

#include "planner/plan/plan.h"

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace furrow {

/// What a plan came to: what lists of many fields show of it when the plan itself is gone.
struct PlanResult {
    Area area;          ///< of the field
    Duration duration;  ///< of the whole drive
    Length length;      ///< of the path
    int blocking = 0;   ///< findings that block

    bool drivable() const { return blocking == 0; }
    friend bool operator==(const PlanResult&, const PlanResult&) = default;
};

PlanResult resultOf(const Plan& plan);

/// Results of plans by what they were planned from (planKey). A result can never be of something else than
/// what its key says, so nothing has to be thrown away when a field changes, and what is undone is known
/// again. Kept beside the projects and not in them: a result is no change that could be undone or saved.
class PlanResults {
public:
    /// Null where there is none.
    const PlanResult* find(const std::string& planKey) const;
    /// The latest `kMost` are kept.
    ///
    /// @param place  which plan of which field it is, whatever it was planned from; the same after a change
    /// of the inputs. Empty for none
    void keep(const std::string& planKey, const PlanResult& result, const std::string& place = {});
    /// The places of all that are kept.
    std::set<std::string> places() const;
    std::size_t size() const { return results_.size(); }

    std::string json() const;
    /// What json() wrote. Empty for any other text, and for results of another version of Furrow, whose plans
    /// may differ.
    static PlanResults fromJson(std::string_view text);

    static constexpr std::size_t kMost = 5000;

private:
    struct Kept {
        PlanResult result;
        std::string place;
        std::size_t age = 0;
    };
    std::map<std::string, Kept, std::less<>> results_;
    std::size_t next_ = 0;
};

}  // namespace furrow
