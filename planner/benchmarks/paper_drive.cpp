#include "planner/benchmarks/paper.h"
#include "planner/benchmarks/paper_settings.h"
#include "planner/evaluation/comparison_report.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>
#include <format>
#include <random>

namespace furrow {

namespace {

// Narrow and long, no side parallel to another.
Polygon narrowField() {
    return {.outer = {{0.0, 0.0}, {210.0, 6.0}, {208.0, 38.0}, {3.0, 31.0}}, .holes = {}};
}

// Along the field, a degree off its sides: a direction given by the user.
constexpr std::string_view kHeadingDeg = "3";

// The real machine drives wider turns than planned: 2.1 m were planned.
constexpr double kDrivenRadiusM = 2.8;
constexpr double kCurvatureRate1pms = 0.35;  ///< rate at which it turns its wheels, 1/m per second
// Distance of looking ahead: the way needed to turn the wheels. With less it would swing from side to side.
constexpr double kLookAheadM = 1.0;
constexpr double kLookAheadS = 0.9;
constexpr double kStepS = 0.02;
constexpr double kRecordEveryS = 0.2;
constexpr double kReceiverNoiseM = 0.02;

/// The path as one line to follow.
class Line {
public:
    explicit Line(const Path& path) {
        for (const PathSegment& segment : path.segments) {
            for (const PathSample& sample : segment.samples) {
                if (samples_.empty() || sample.sM > samples_.back().sM) {
                    samples_.push_back(sample);
                }
            }
        }
    }

    double length() const { return samples_.back().sM; }
    PathSample at(double sM) const {
        const auto after = std::ranges::lower_bound(samples_, sM, {}, &PathSample::sM);
        if (after == samples_.begin() || after == samples_.end()) {
            return after == samples_.end() ? samples_.back() : samples_.front();
        }
        const PathSample& before = *(after - 1);
        const double share = (sM - before.sM) / (after->sM - before.sM);
        PathSample found = before;
        found.sM = sM;
        found.position = before.position + share * (after->position - before.position);
        return found;
    }
    /// The nearest place along the line, slightly ahead of the last one.
    double nearest(Point place, double fromM) const {
        constexpr double kWindowM = 3.0;
        constexpr double kFineM = 0.05;
        double best = fromM;
        double bestOff = 1e300;
        for (double s = fromM; s <= std::min(length(), fromM + kWindowM); s += kFineM) {
            const double off = distance(at(s).position, place);
            if (off < bestOff) {
                bestOff = off;
                best = s;
            }
        }
        return best;
    }

private:
    std::vector<PathSample> samples_;
};

/// Approximately normal: the sum of twelve uniform numbers has variance 1.
double noise(std::mt19937& random) {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) {
        sum += static_cast<double>(random()) / 4294967296.0;
    }
    return sum;
}

/// A steered axle that follows the line by pure pursuit, within its steering limits.
RecordedTrack simulatedDrive(const Path& path) {
    const Line line{path};
    std::mt19937 random{1};
    RecordedTrack track{.source = "simulated drive", .places = TrackPlaces::Local, .samples = {}};
    const PathSample start = line.at(0.0);
    Point place = start.position;
    double heading = start.headingRad;
    double curvature = 0.0;
    double wayM = 0.0;
    double nextRecordS = 0.0;
    const double latestS = 3.0 * path.duration().si();
    for (double timeS = 0.0; wayM < line.length() - 0.2 && timeS < latestS; timeS += kStepS) {
        if (timeS >= nextRecordS) {
            const Point seen =
                place + Point{kReceiverNoiseM * noise(random), kReceiverNoiseM * noise(random)};
            track.samples.push_back({.local = seen, .timeS = timeS});
            nextRecordS += kRecordEveryS;
        }
        wayM = line.nearest(place, wayM);
        const double speedMps = std::max(0.3, line.at(wayM).speedMps);
        const double aheadM = kLookAheadM + kLookAheadS * speedMps;
        const Point toTarget = line.at(std::min(line.length(), wayM + aheadM)).position - place;
        const double angle = wrappedAngle(radians(std::atan2(toTarget.y, toTarget.x) - heading)).si();
        const double wanted = 2.0 * std::sin(angle) / std::max(0.5, norm(toTarget));
        const double allowed = std::clamp(wanted, -1.0 / kDrivenRadiusM, 1.0 / kDrivenRadiusM);
        curvature +=
            std::clamp(allowed - curvature, -kCurvatureRate1pms * kStepS, kCurvatureRate1pms * kStepS);
        const double stepM = speedMps * kStepS;
        heading += 0.5 * curvature * stepM;
        place = place + stepM * direction(heading);
        heading += 0.5 * curvature * stepM;
    }
    return track;
}

std::string figuresCsv(const TrackComparison& comparison) {
    std::string text = "kind,samples,median_m,p95_m,largest_m,mean_signed_m\n";
    const auto row = [&text](std::string_view kind, const CrossTrackFigures& figures) {
        text += std::format("{},{},{:.4f},{:.4f},{:.4f},{:.4f}\n", kind, figures.samples, figures.median.si(),
                            figures.p95.si(), figures.largest.si(), figures.mean.si());
    };
    for (const KindFigures& kind : comparison.kinds) {
        row(segmentKindId(kind.kind), kind.figures);
    }
    row("all", comparison.overall);
    return text;
}

std::string words(const CrossTrackFigures& figures) {
    return std::format("median {:.2f} m, 95 % {:.2f} m, largest {:.2f} m", figures.median.si(),
                       figures.p95.si(), figures.largest.si());
}

}  // namespace

Result<PaperExperiment> paperDrive(const JobContext& job) {
    PaperExperiment experiment{.number = 4, .title = "A drive laid over its plan"};
    auto settings = paperSettings({{"headland.width_m", "7.5"},
                                   {"swaths.method", "fixed"},
                                   {"swaths.angle_deg", kHeadingDeg},
                                   {"route.method", "snake"}});
    if (!settings) {
        experiment.notes.push_back("This planner has no snake order yet; boustrophedon stands in for it.");
        settings = paperSettings(
            {{"headland.width_m", "7.5"}, {"swaths.method", "fixed"}, {"swaths.angle_deg", kHeadingDeg}});
    }
    const auto field = fieldOf(narrowField(), "Narrow field");
    if (!settings || !field) {
        return std::unexpected(settings ? field.error() : settings.error());
    }
    const Machine machine = paperMachine();
    const auto plan = makePlan({.field = *field, .machine = machine, .settings = *settings}, job);
    if (!plan) {
        return std::unexpected(plan.error());
    }
    const RecordedTrack track = simulatedDrive((*plan)->path);
    const WrittenPath written{.name = "Narrow field",
                              .frame = (*field)->frame(),
                              .path = (*plan)->path,
                              .field = (*field)->boundary(),
                              .obstacles = {},
                              .operatingWidth = machine.operatingWidth()};
    const Length radius = 1.5 * machine.operatingWidth();
    const auto comparison = compareWithPath(written.path, written.frame, {&track, 1}, radius, job);
    if (!comparison) {
        return std::unexpected(comparison.error());
    }
    const ComparisonReport report{.plan = written,
                                  .format = "simulation",
                                  .tracks = {&track, 1},
                                  .comparison = *comparison,
                                  .notes = {},
                                  .radius = radius};
    const CrossTrackFigures* swaths = comparison->of(SegmentKind::Swath);
    const CrossTrackFigures* turns = comparison->of(SegmentKind::Turn);
    if (swaths != nullptr && turns != nullptr) {
        experiment.statements.push_back({.paper = "Swaths are followed closely",
                                         .found = words(*swaths),
                                         .agrees = swaths->median < metres(0.1)});
        experiment.statements.push_back(
            {.paper = "Turns are not, where the curves are tighter than the machine can drive",
             .found = words(*turns),
             .agrees = turns->median > swaths->median && turns->p95 > swaths->p95});
    }
    experiment.notes.push_back(
        std::format("The drive is simulated: a machine with a radius of {} m follows curves of {} m and is "
                    "seen by a receiver "
                    "with {} m of noise. furrow-cli compare lays recorded drives over a plan.",
                    kDrivenRadiusM, machine.minTurningRadius().si(), kReceiverNoiseM));
    experiment.files = {{"experiment4_figures.csv", figuresCsv(*comparison)},
                        {"experiment4_samples.csv", comparisonCsv(report)},
                        {"experiment4_drive.svg", comparisonSvg(report)}};
    return experiment;
}

}  // namespace furrow
