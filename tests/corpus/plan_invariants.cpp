#include "tests/corpus/plan_invariants.h"

#include "planner/geometry/boundary_distance.h"
#include "planner/io/formats/geojson/plan_geojson.h"
#include "planner/io/plan_files/plan_summary.h"
#include "planner/plan/general_parameters.h"
#include "planner/swaths/methods.h"

#include <QJsonDocument>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <format>
#include <stop_token>
#include <thread>

namespace furrow::test {

namespace {

using Clock = std::chrono::steady_clock;
// Nobody waits longer than this for Ctrl+C, on a machine that does other things meanwhile.
constexpr double kMostStopS = 10.0;
// Swaths end on the mainland's edge, which is drawn to a centimetre.
constexpr double kBesideM = 0.02;
// Between the places of a swath that are looked at, and as far as distances are worked out.
constexpr double kLookM = 0.5;
constexpr double kReachM = 1.0;

double since(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

std::string faultOf(const Error& error) {
    if (error.code == ErrorCode::Cancelled) {
        return "nobody stopped it: " + error.line();
    }
    return error.what.empty() || error.remedy.empty() ? "an error without a remedy: " + error.line() : "";
}

bool isFinite(const PathSample& sample) {
    return std::isfinite(sample.position.x + sample.position.y + sample.headingRad + sample.curvature1pm +
                         sample.speedMps + sample.sM + sample.tS + sample.level.value_or(0.0));
}

/// How far the nearest of some places along a swath is inside of the mainland, or the farthest.
double insideAlong(const Swath& swath, const BoundaryDistance& mainland, bool farthest) {
    const int places = std::max(40, static_cast<int>(swath.length().si() / kLookM));
    double best = farthest ? -kReachM : kReachM;
    for (int i = 0; i <= places; ++i) {
        const double share = static_cast<double>(i) / places;
        const Point place = (1.0 - share) * swath.start + share * swath.end;
        const double insideM = mainland.insideM(place).value_or(kReachM);
        best = farthest ? std::max(best, insideM) : std::min(best, insideM);
    }
    return best;
}

std::string faultInSwaths(const Plan& plan) {
    // Drawn out to the full width, a swath begins or ends beyond the mainland, but some of it lies there.
    const bool areDrawnOut = plan.request.settings.choice(kEnds) != "centre";
    const BoundaryDistance mainland{plan.headland.mainland, metres(kReachM)};
    for (const Swath& swath : plan.swaths.swaths) {
        if (!std::isfinite(swath.start.x + swath.start.y + swath.end.x + swath.end.y + swath.length().si())) {
            return std::format("swath {} is nowhere", swath.number);
        }
        if (!swath.isCurved() && insideAlong(swath, mainland, areDrawnOut) < -kBesideM) {
            return std::format("swath {} lies beside the mainland", swath.number);
        }
    }
    return {};
}

std::string faultIn(const Plan& plan) {
    for (const PathSegment& segment : plan.path.segments) {
        for (const PathSample& sample : segment.samples) {
            if (!isFinite(sample)) {
                return "a place of the path is no number";
            }
        }
    }
    if (auto fault = faultInSwaths(plan); !fault.empty()) {
        return fault;
    }
    if (plan.route.steps.size() != plan.swaths.swaths.size()) {
        return std::format("{} of {} swaths are driven", plan.route.steps.size(), plan.swaths.swaths.size());
    }
    for (const std::string& json : {planGeoJson(plan), planSummaryJson(plan)}) {
        QJsonParseError error;
        QJsonDocument::fromJson(QByteArray::fromStdString(json), &error);
        if (error.error != QJsonParseError::NoError) {
            return "JSON that cannot be read: " + error.errorString().toStdString();
        }
    }
    return {};
}

bool areSame(const Plan& a, const Plan& b) {
    return a.swaths.swaths == b.swaths.swaths && a.route == b.route && a.path == b.path &&
           a.audit == b.audit && a.findings == b.findings && a.instead == b.instead &&
           a.headland.mainland == b.headland.mainland;
}

std::string faultOfThreads(const PlanRequest& request, const Result<std::shared_ptr<const Plan>>& byOne) {
    const auto byTwo = makePlan(request, {.threads = 2});
    if (byOne.has_value() != byTwo.has_value()) {
        return "only one of one thread and two comes to a plan";
    }
    if (!byOne) {
        return byOne.error() == byTwo.error() ? "" : "one thread and two are refused differently";
    }
    return areSame(**byOne, **byTwo) ? "" : "two threads make another plan than one";
}

/// Stops a job some time after it began, and waits for its end.
double stoppedAfter(const PlanRequest& request, std::chrono::milliseconds delay) {
    std::stop_source stop;
    std::atomic<double> stoppedS{0.0};
    const auto begun = Clock::now();
    {
        const std::jthread stopper{[&] {
            std::this_thread::sleep_for(delay);
            stoppedS = since(begun);
            stop.request_stop();
        }};
        [[maybe_unused]] const auto stopped = makePlan(request, {.stop = stop.get_token()});
        const double endedS = since(begun);
        stoppedS = stoppedS == 0.0 ? endedS : stoppedS.load();
        return std::max(0.0, endedS - stoppedS);
    }
}

}  // namespace

DrawnVerdict verdictOn(const DrawnRequest& drawn, DrawnTrial trial, std::chrono::milliseconds stopAfter) {
    DrawnVerdict verdict;
    const std::clock_t begun = std::clock();
    for (const Error& error : drawn.refused) {
        verdict.fault = verdict.fault.empty() ? faultOf(error) : verdict.fault;
    }
    auto field = Field::create(drawn.field);
    const auto machine = Machine::create(drawn.machine);
    if (!verdict.fault.empty() || !field || !machine) {
        verdict.fault =
            !verdict.fault.empty() ? verdict.fault : faultOf(field ? machine.error() : field.error());
        return verdict;
    }
    const PlanRequest request{.field = std::make_shared<const Field>(*std::move(field)),
                              .machine = *machine,
                              .settings = drawn.settings};
    if (trial == DrawnTrial::Stop) {
        verdict.stopSeconds = stoppedAfter(request, stopAfter);
        verdict.fault = verdict.stopSeconds > kMostStopS
                            ? std::format("it stopped after {:.1f} s", verdict.stopSeconds)
                            : "";
    }
    const auto plan = makePlan(request, {.threads = 1});
    verdict.seconds = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
    if (verdict.fault.empty()) {
        verdict.fault = plan ? faultIn(**plan) : faultOf(plan.error());
    }
    if (verdict.fault.empty() && trial == DrawnTrial::OneThreadAndTwo) {
        verdict.fault = faultOfThreads(request, plan);
    }
    if (plan) {
        verdict.outcome = (*plan)->drivable() ? DrawnOutcome::Drivable : DrawnOutcome::Planned;
    }
    return verdict;
}

DrawnVerdict verdictOn(std::uint64_t seed, DrawnSize size) {
    constexpr std::array kTrials{DrawnTrial::OneThreadAndTwo, DrawnTrial::Stop, DrawnTrial::PlanOnly};
    return verdictOn(drawnRequest(seed, size), kTrials[seed % kTrials.size()],
                     std::chrono::milliseconds{seed / 3 % 400});
}

}  // namespace furrow::test
