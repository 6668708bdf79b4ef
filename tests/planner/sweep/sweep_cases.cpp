#include "tests/planner/sweep/sweep_cases.h"

#include "planner/plan/method_registry.h"

#include <algorithm>
#include <random>
#include <set>

namespace furrow::test {

namespace {

/// A stage with a method that reads a setting; without a method: every method of the stage does, or no stage.
struct Reader {
    const StageInfo* stage = nullptr;
    std::string_view method;
};

/// The methods that have to be chosen for a setting to be read: none where the default one reads it.
std::vector<Reader> readersOf(const Parameter& parameter) {
    std::vector<Reader> readers;
    for (const StageInfo& stage : stages()) {
        for (const MethodInfo& method : stage.methods) {
            if (std::ranges::contains(method.parameters, &parameter)) {
                if (&method == &stage.methods.front()) {
                    return {{}};
                }
                readers.push_back({&stage, method.id});
            }
        }
    }
    return readers.empty() ? std::vector<Reader>{{}} : readers;
}

bool needsValue(const Parameter& parameter) {
    // Rows that are left out may be none; swaths in an order of one's own are all.
    return parameter.kind == ParameterKind::Line || parameter.kind == ParameterKind::File ||
           parameter.key == "route.order";
}

/// The method and what it cannot do without, unless that is what is changed.
std::vector<SweepSetting> partnersOf(const Reader& reader, const Parameter& changed) {
    std::vector<SweepSetting> partners;
    if (reader.stage == nullptr) {
        return partners;
    }
    const auto method = std::ranges::find(reader.stage->methods, reader.method, &MethodInfo::id);
    if (&changed != reader.stage->method) {
        partners.push_back({std::string{reader.stage->method->key}, fixedValue(std::string{reader.method})});
    }
    // A curve follows the edge that is picked, or a line.
    const bool edgePicked = changed.key == "swaths.edge";
    for (const Parameter* parameter : method->parameters) {
        if (parameter != &changed && needsValue(*parameter) && !edgePicked) {
            partners.push_back({std::string{parameter->key}, sweepValues(*parameter, reader.method).front()});
        }
    }
    return partners;
}

/// Settings that say nothing without another one.
void addCompanions(SweepChange& change) {
    if (change.changed.front().key == "swaths.tramline_start") {
        change.partners.push_back({"swaths.tramline_every", fixedValue("3")});
    }
}

void addMethods(std::vector<SweepChange>& changes, const StageInfo& stage) {
    for (std::size_t i = 1; i < stage.methods.size(); ++i) {
        const Reader reader{&stage, stage.methods[i].id};
        changes.push_back(
            {.changed = {{std::string{stage.method->key}, fixedValue(std::string{reader.method})}},
             .partners = partnersOf(reader, *stage.method)});
    }
}

void addValues(std::vector<SweepChange>& changes, const Parameter& parameter) {
    for (const Reader& reader : readersOf(parameter)) {
        for (const SweepValue& value : sweepValues(parameter, reader.method)) {
            changes.push_back({.changed = {{std::string{parameter.key}, value}},
                               .partners = partnersOf(reader, parameter)});
            addCompanions(changes.back());
        }
    }
}

std::uint64_t hashOf(std::string_view text, std::uint64_t seed) {
    std::uint64_t hash = 14695981039346656037ULL ^ (seed * 0x9e3779b97f4a7c15ULL);
    for (const char letter : text) {
        hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211ULL;
    }
    return hash ^ (hash >> 29);
}

/// Both at once; nothing where they set one setting to two values.
std::optional<SweepChange> together(const SweepChange& a, const SweepChange& b) {
    SweepChange both = a;
    const auto find = [&both](const SweepSetting& setting) -> const SweepSetting* {
        for (const auto* settings : {&both.changed, &both.partners}) {
            if (const auto found = std::ranges::find(*settings, setting.key, &SweepSetting::key);
                found != settings->end()) {
                return &*found;
            }
        }
        return nullptr;
    };
    for (const auto& [from, to] :
         {std::pair{&b.changed, &both.changed}, std::pair{&b.partners, &both.partners}}) {
        for (const SweepSetting& setting : *from) {
            const SweepSetting* const other = find(setting);
            if (other == nullptr) {
                to->push_back(setting);
            } else if (other->value.label != setting.value.label || from == &b.changed) {
                return std::nullopt;
            }
        }
    }
    return both;
}

}  // namespace

std::string SweepChange::name() const {
    std::string text;
    for (const SweepSetting& setting : changed) {
        text += (text.empty() ? "" : " + ") + setting.told();
    }
    for (std::size_t i = 0; i < partners.size(); ++i) {
        text += (i == 0 ? " (" : ", ") + partners[i].told() + (i + 1 == partners.size() ? ")" : "");
    }
    return text.empty() ? "defaults" : text;
}

std::vector<SweepChange> everyChange() {
    std::vector<SweepChange> changes{{}};
    for (const Parameter* parameter : allParameters()) {
        const auto stage = std::ranges::find(stages(), parameter, &StageInfo::method);
        if (stage != stages().end()) {
            addMethods(changes, *stage);
        } else {
            addValues(changes, *parameter);
        }
    }
    return changes;
}

std::vector<SweepChange> drawnPairs(const std::vector<SweepChange>& changes, std::size_t count,
                                    std::uint64_t seed) {
    std::mt19937_64 random{seed};
    std::set<std::string> drawn;
    std::vector<SweepChange> pairs;
    for (std::size_t tries = 0; tries < 50 * count && pairs.size() < count; ++tries) {
        const SweepChange& a = changes[random() % changes.size()];
        const SweepChange& b = changes[random() % changes.size()];
        if (a.changed.empty() || b.changed.empty() || a.changed.front().key >= b.changed.front().key) {
            continue;
        }
        if (auto both = together(a, b); both && drawn.insert(both->name()).second) {
            pairs.push_back(std::move(*both));
        }
    }
    return pairs;
}

std::vector<SweepCase> drawnCases(const std::vector<SweepCase>& all, std::uint64_t oneIn,
                                  std::uint64_t seed) {
    std::vector<SweepCase> drawn;
    std::ranges::copy_if(all, std::back_inserter(drawn),
                         [&](const SweepCase& each) { return hashOf(each.name(), seed) % oneIn == 0; });
    return drawn;
}

std::vector<SweepCase> casesOf(const std::vector<SweepChange>& changes,
                               const std::vector<std::string>& shapes,
                               const std::vector<std::string>& machines) {
    std::vector<SweepCase> cases;
    for (const std::string& shape : shapes) {
        for (const std::string& machine : machines) {
            for (const SweepChange& change : changes) {
                cases.push_back({shape, machine, change});
            }
        }
    }
    return cases;
}

}  // namespace furrow::test
