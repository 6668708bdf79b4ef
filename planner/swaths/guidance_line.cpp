#include "planner/swaths/heading_search.h"
#include "planner/swaths/methods.h"

#include <cmath>

namespace furrow {

namespace {

// Two points that are closer give no direction.
constexpr double kShortestLineM = 1.0;

Error lineMissing(std::string_view method, const Message& wanted, std::string_view example) {
    return {.code = ErrorCode::Usage,
            .what = message("{} needs {}", method, wanted),
            .where = std::string{kLine.key},
            .remedy = message("give it as WKT in WGS84, {}", example)};
}

// A swath farther from its lane was moved to the edge, or spread.
constexpr double kLaneSlackM = 0.01;

Result<SwathSet> along(const SwathTask& task, Angle heading, Point anchor, const JobContext& job) {
    auto set = scanLineFor(task, anchor).and_then([&](const ScanLine& scanLine) {
        return swathsAlong(scanLine, task, heading, SwathObjective::Coverage, job);
    });
    if (set) {
        const double stepM = (task.machine.operatingWidth() - *task.settings.length(kOverlap)).si();
        for (Swath& swath : set->swaths) {
            const double lanes = cross(direction(heading.si()), swath.start - anchor) / stepM;
            if (std::abs(lanes - std::round(lanes)) * stepM < kLaneSlackM) {
                swath.lane = static_cast<int>(std::round(lanes));
            }
        }
    }
    return set;
}

Result<SwathSet> abLine(const SwathTask& task, const JobContext& job) {
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    const std::vector<GeoPoint> line = task.settings.line(kLine);
    if (line.size() != 2) {
        return std::unexpected(
            lineMissing("ab-line", "two points", "such as LINESTRING (4.1 52.0, 4.2 52.0)"));
    }
    const Point a = task.field.frame().toLocal(line[0]);
    const Point way = task.field.frame().toLocal(line[1]) - a;
    if (norm(way) < kShortestLineM) {
        return std::unexpected(Error{.code = ErrorCode::InputRefused,
                                     .what = message("A and B are {:.2f} m apart", norm(way)),
                                     .where = std::string{kLine.key},
                                     .remedy = "give two points at least 1 m apart",
                                     .place = line[0]});
    }
    return along(task, radians(std::atan2(way.y, way.x)), a, job);
}

Result<SwathSet> aPlus(const SwathTask& task, const JobContext& job) {
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    const std::vector<GeoPoint> line = task.settings.line(kLine);
    if (line.empty()) {
        return std::unexpected(lineMissing("a-plus", "a point", "such as POINT (4.1 52.0)"));
    }
    return along(task, *task.settings.angle(kAngle), task.field.frame().toLocal(line[0]), job);
}

constexpr const Parameter* kAbParameters[] = {&kLine};
constexpr const Parameter* kAPlusParameters[] = {&kLine, &kAngle};

}  // namespace

const Parameter kLine{
    .key = "swaths.line",
    .name = "Line",
    .description = "In WGS84: A and B of a line, a curve, A alone with a direction, or a pivot's centre.",
    .kind = ParameterKind::Line,
    .standard = {},
    .choices = {}};

const Method<SwathGenerator> kAbLineMethod{
    .info = {.id = "ab-line",
             .name = "AB line",
             .description = "Along the line from A to B; one swath lies on it.",
             .parameters = kAbParameters},
    .run = abLine};

const Method<SwathGenerator> kAPlusMethod{
    .info = {.id = "a-plus",
             .name = "A+",
             .description = "Through point A in the direction that you type.",
             .parameters = kAPlusParameters},
    .run = aPlus,
    .traits = {.isFromPoint = true}};

}  // namespace furrow
