#include "planner/project/plan_results.h"

#include "planner/core/json_text.h"
#include "planner/project/json_members.h"
#include "planner/version.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace furrow {

PlanResult resultOf(const Plan& plan) {
    return {.area = plan.field().area(),
            .duration = plan.path.duration(),
            .length = plan.path.length(),
            .blocking = static_cast<int>(plan.blockingCount())};
}

const PlanResult* PlanResults::find(const std::string& planKey) const {
    const auto found = results_.find(planKey);
    return found == results_.end() ? nullptr : &found->second.result;
}

void PlanResults::keep(const std::string& planKey, const PlanResult& result, const std::string& place) {
    results_[planKey] = {.result = result, .place = place, .age = next_++};
    if (results_.size() > kMost) {
        results_.erase(
            std::ranges::min_element(results_, {}, [](const auto& entry) { return entry.second.age; }));
    }
}

std::set<std::string> PlanResults::places() const {
    std::set<std::string> places;
    for (const auto& [key, kept] : results_) {
        if (!kept.place.empty()) {
            places.insert(kept.place);
        }
    }
    return places;
}

std::string PlanResults::json() const {
    std::vector<std::pair<std::size_t, const std::string*>> byAge;
    for (const auto& [key, kept] : results_) {
        byAge.emplace_back(kept.age, &key);
    }
    std::ranges::sort(byAge);
    OrderedJson list = OrderedJson::array();
    for (const auto& [age, key] : byAge) {
        const auto& [result, place, number] = results_.find(*key)->second;
        list.push_back({{"plan_key", *key},
                        {"area_m2", result.area.si()},
                        {"duration_s", result.duration.si()},
                        {"length_m", result.length.si()},
                        {"blocking", result.blocking},
                        {"place", place}});
    }
    return textOf({{"version", kVersion}, {"results", list}});
}

PlanResults PlanResults::fromJson(std::string_view text) {
    PlanResults results;
    const OrderedJson json = jsonOrDiscarded<OrderedJson>(text);
    try {
        if (json.at("version").get<std::string>() != kVersion) {
            return results;
        }
        for (const OrderedJson& entry : json.at("results")) {
            results.keep(entry.at("plan_key").get<std::string>(),
                         {.area = squareMetres(entry.at("area_m2").get<double>()),
                          .duration = seconds(entry.at("duration_s").get<double>()),
                          .length = metres(entry.at("length_m").get<double>()),
                          .blocking = entry.at("blocking").get<int>()},
                         entry.value("place", std::string{}));
        }
    } catch (const OrderedJson::exception&) {
        return {};
    }
    return results;
}

}  // namespace furrow
