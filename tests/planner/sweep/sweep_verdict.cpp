#include "tests/planner/sweep/sweep_verdict.h"

#include "planner/io/import/guide_import.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/advice.h"
#include "planner/plan/method_registry.h"
#include "planner/settings/operation.h"
#include "tests/planner/sweep/sweep_shapes.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <format>
#include <map>
#include <set>

namespace furrow::test {

namespace {

// A finding that is still there is one of its kind no farther from its place than this, or two operating
// widths.
constexpr double kNearM = 10.0;
// A setting that makes more of what blocks with default settings than so many times as much is at fault
// itself.
constexpr int kAsMany = 2;

constexpr std::array<std::pair<SweepVerdict, std::string_view>, 6> kNames{
    {{SweepVerdict::Drivable, "drivable"},
     {SweepVerdict::Refused, "refused"},
     {SweepVerdict::Told, "told"},
     {SweepVerdict::DefaultToo, "default-too"},
     {SweepVerdict::Failed, "FAILED"},
     {SweepVerdict::LeftOut, "left-out"}}};

std::string lower(std::string_view text) {
    std::string result{text};
    std::ranges::transform(result, result.begin(),
                           [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return result;
}

/// Whether a name of several words is in a text, or one in quotation marks: single words mean other things,
/// too.
bool namesIt(std::string_view text, std::string_view name) {
    const std::string words = lower(text);
    const std::string wanted = lower(name);
    return words.contains("\"" + wanted + "\"") || (wanted.contains(' ') && words.contains(wanted));
}

/// Whether what is advised for one setting is an answer to a change of another: the same one, the method that
/// reads it, what a chosen method reads, what an operation sets.
bool dependsOn(std::string_view key, std::string_view changed) {
    if (key == changed || (changed == "operation.kind" && isSetByOperation(key))) {
        return true;
    }
    const auto readBy = [](const StageInfo& stage, std::string_view parameter) {
        return std::ranges::any_of(stage.methods, [&](const MethodInfo& method) {
            return std::ranges::contains(method.parameters, parameter, &Parameter::key);
        });
    };
    return std::ranges::any_of(stages(), [&](const StageInfo& stage) {
        return (stage.method->key == changed && readBy(stage, key)) ||
               (stage.method->key == key && readBy(stage, changed));
    });
}

std::vector<const SweepSetting*> allOf(const SweepChange& change) {
    std::vector<const SweepSetting*> all;
    for (const auto* settings : {&change.changed, &change.partners}) {
        for (const SweepSetting& setting : *settings) {
            all.push_back(&setting);
        }
    }
    return all;
}

/// Whether a text names one of the settings that were changed: by key, by name, or by what was chosen.
/// @param advice  names the choice that may be taken instead
bool namesChange(const SweepChange& change, const Message& text, const Message& advice) {
    for (const SweepSetting* setting : allOf(change)) {
        const Parameter& parameter = **findParameter(setting->key);
        const std::string whole = text.text() + " " + advice.text();
        if (namesIt(whole, parameter.name)) {
            return true;
        }
        for (const Choice& choice : parameter.choices) {
            if (whole.contains(std::format("\"{}\"", choice.name)) ||
                (choice.id == setting->value.label && namesIt(text.text(), choice.name))) {
                return true;
            }
        }
        for (const Parameter* other : allParameters()) {
            if (whole.contains(other->key) && dependsOn(other->key, setting->key)) {
                return true;
            }
        }
    }
    return false;
}

std::map<std::string, int> blockingKinds(const Plan* plan) {
    std::map<std::string, int> kinds;
    if (plan != nullptr) {
        for (const Finding& finding : plan->findings) {
            if (finding.severity == Severity::Blocking) {
                ++kinds[std::string{kindId(finding)}];
            }
        }
    }
    return kinds;
}

int countOf(const std::map<std::string, int>& kinds) {
    int count = 0;
    for (const auto& [kind, number] : kinds) {
        count += number;
    }
    return count;
}

std::string told(const Finding& finding) {
    return std::format("[{}] {} {}", kindId(finding), finding.text.text(), finding.suggestion.text());
}

}  // namespace

std::string_view verdictName(SweepVerdict verdict) {
    return std::ranges::find(kNames, verdict, [](const auto& each) { return each.first; })->second;
}

std::optional<SweepVerdict> verdictFrom(std::string_view name) {
    const auto found = std::ranges::find(kNames, name, [](const auto& each) { return each.second; });
    return found == kNames.end() ? std::nullopt : std::optional{found->first};
}

bool tells(const Finding& finding, const SweepChange& change) {
    const auto isMeant = [&](const SweepSetting* setting) {
        return dependsOn(finding.change->key, setting->key);
    };
    return (finding.change && std::ranges::any_of(allOf(change), isMeant)) ||
           namesChange(change, finding.text, finding.suggestion);
}

SweepBench::SweepBench(const std::string& shape, const std::string& machine, std::filesystem::path folder,
                       std::function<void()> planned)
    : site_{.field = {},
            .machine = findMachine(machine).value(),
            .standard = {},
            .folder = std::move(folder)},
      planned_{std::move(planned)} {
    site_.field = std::make_shared<const Field>(Field::create(sweepField(shape, site_.machine)).value());
    auto standard = plan({});
    if (standard) {
        site_.standard = std::move(*standard);
    } else {
        refused_ = standard.error();
    }
}

Result<std::shared_ptr<const Plan>> SweepBench::plan(const Settings& settings) const {
    const JobContext job{.threads = 1};
    auto made =
        readGuides(settings, *site_.field, job).and_then([&](const std::shared_ptr<const GuideData>& guides) {
            return makePlan(
                {.field = site_.field, .machine = site_.machine, .settings = settings, .guides = guides},
                job);
        });
    if (planned_) {
        planned_();
    }
    return made;
}

SweepOutcome SweepBench::run(const SweepChange& change) const {
    SweepOutcome outcome;
    Settings settings;
    for (const SweepSetting* setting : allOf(change)) {
        const auto text = setting->value.text(site_);
        if (!text) {
            return {.verdict = SweepVerdict::LeftOut};
        }
        outcome.settings +=
            std::format("{}--set '{}={}'", outcome.settings.empty() ? "" : " ", setting->key, *text);
        if (const auto set = applySetting(settings, setting->key, *text); !set) {
            outcome.verdict = SweepVerdict::Refused;
            outcome.reason = set.error().line();
            return outcome;
        }
    }
    SweepOutcome result = judged(change, settings);
    result.settings = std::move(outcome.settings);
    return result;
}

SweepOutcome SweepBench::judged(const SweepChange& change, const Settings& settings) const {
    SweepOutcome outcome;
    const auto made = change.changed.empty() && site_.standard
                          ? Result<std::shared_ptr<const Plan>>{site_.standard}
                          : plan(settings);
    if (!made) {
        const Error& error = made.error();
        const bool isTold = namesChange(change, error.what, error.where.text() + " " + error.remedy.text());
        outcome.verdict = isTold || (refused_ && refused_->what.key() == error.what.key())
                              ? SweepVerdict::Refused
                              : SweepVerdict::Failed;
        outcome.reason = error.line();
        return outcome;
    }
    measure(outcome, **made);
    // What the program shows: with advice that was planned.
    const auto advised = withAdvice(*made, {.threads = 1});
    if (!advised) {
        outcome.reason = advised.error().line();
        return outcome;
    }
    const auto standardKinds = blockingKinds(site_.standard.get());
    outcome.standardBlocking = countOf(standardKinds);
    outcome.verdict = SweepVerdict::Drivable;
    std::map<std::string, int> untold;
    for (const Finding& finding : (*advised)->findings) {
        if (finding.severity == Severity::Blocking && !tells(finding, change)) {
            ++untold[std::string{kindId(finding)}];
        }
    }
    for (const Finding& finding : (*advised)->findings) {
        if (finding.severity != Severity::Blocking) {
            continue;
        }
        ++outcome.blocking;
        if (tells(finding, change)) {
            outcome.verdict = std::max(outcome.verdict, SweepVerdict::Told);
        } else if (const auto had = standardKinds.find(std::string{kindId(finding)});
                   had != standardKinds.end() &&
                   untold.at(std::string{kindId(finding)}) <= kAsMany * had->second) {
            outcome.verdict = std::max(outcome.verdict, SweepVerdict::DefaultToo);
        } else if (outcome.verdict != SweepVerdict::Failed) {
            outcome.verdict = SweepVerdict::Failed;
            outcome.reason = told(finding);
        }
    }
    const bool mustBeTold = std::ranges::any_of(
        change.changed, [](const SweepSetting& setting) { return setting.value.mustBeTold; });
    if (mustBeTold && std::ranges::none_of((*advised)->findings,
                                           [&](const Finding& finding) { return tells(finding, change); })) {
        outcome.verdict = SweepVerdict::Failed;
        outcome.reason = "nothing is said of a value that cannot be obeyed";
    }
    if (const std::string bad = badAdvice(**advised); !bad.empty()) {
        outcome.verdict = SweepVerdict::Failed;
        outcome.reason += (outcome.reason.empty() ? "" : " ") + bad;
    }
    return outcome;
}

void SweepBench::measure(SweepOutcome& outcome, const Plan& plan) const {
    outcome.coveredShare = plan.audit.coveredShare.value_or(0.0);
    outcome.timeS = plan.path.duration().si();
    outcome.planningS = plan.timings.total.si();
    if (site_.standard) {
        outcome.moreCovered = outcome.coveredShare - site_.standard->audit.coveredShare.value_or(0.0);
        outcome.timeRatio = outcome.timeS / site_.standard->path.duration().si();
        outcome.changesNothing = plan.path == site_.standard->path;
    }
}

std::string SweepBench::badAdvice(const Plan& plan) const {
    const double nearM = std::max(kNearM, 2.0 * site_.machine.operatingWidth().si());
    std::set<std::pair<std::string, std::string>> tried;
    for (const Finding& finding : plan.findings) {
        if (!finding.change || !tried.insert({finding.change->key, finding.change->value}).second) {
            continue;
        }
        const std::string advice =
            std::format("bad advice {}={}: ", finding.change->key, finding.change->value);
        Settings settings = plan.request.settings;
        if (const auto set = applySetting(settings, finding.change->key, finding.change->value); !set) {
            return advice + set.error().line();
        }
        const auto mended = this->plan(settings);
        if (!mended) {
            return advice + mended.error().line();
        }
        for (const Finding& promised : plan.findings) {
            const auto same = std::ranges::find_if((*mended)->findings, [&](const Finding& other) {
                return other.kind == promised.kind && other.severity == promised.severity &&
                       distance(other.place, promised.place) < nearM;
            });
            if (promised.change == finding.change && same != (*mended)->findings.end()) {
                return advice + "still there: " + told(*same);
            }
        }
        const auto before = blockingKinds(&plan);
        for (const auto& [kind, count] : blockingKinds(mended->get())) {
            if (const auto had = before.find(kind); had == before.end() || had->second < count) {
                const auto added = std::ranges::find_if((*mended)->findings, [&](const Finding& other) {
                    return kindId(other) == kind && other.severity == Severity::Blocking;
                });
                return advice + "now blocked by " + told(*added);
            }
        }
    }
    return {};
}

}  // namespace furrow::test
