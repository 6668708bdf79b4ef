#include "planner/swaths/curved_swaths.h"
#include "planner/swaths/guide_curve.h"
#include "planner/swaths/guide_data.h"
#include "planner/swaths/heading_search.h"
#include "planner/swaths/left_on_purpose.h"
#include "planner/swaths/methods.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace furrow {

namespace {

// Distance along the first row at which middles between two rows are computed.
constexpr double kRowLookM = 2.0;
// Two rows this many times farther apart than most are not neighbours: a track or a ditch lies between.
constexpr double kNeighbours = 1.8;

struct Row {
    int number = 0;  ///< in the file, from 1
    Polyline line;   ///< along the common direction
};

/// The common direction of all rows, weighted by length. Opposite directions are equal.
Point commonDirection(const std::vector<Polyline>& rows) {
    Point sum;
    for (const Polyline& row : rows) {
        for (std::size_t i = 0; i + 1 < row.size(); ++i) {
            const Point way = row[i + 1] - row[i];
            sum = sum + norm(way) * direction(2.0 * std::atan2(way.y, way.x));
        }
    }
    return direction(0.5 * std::atan2(sum.y, sum.x));
}

/// All rows in the same direction, from right to left.
std::vector<Row> sortedRows(const std::vector<Polyline>& lines) {
    const Point along = commonDirection(lines);
    std::vector<Row> rows;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        rows.push_back({static_cast<int>(i) + 1, lines[i]});
        Polyline& line = rows.back().line;
        if (dot(along, line.back() - line.front()) < 0.0) {
            std::ranges::reverse(line);
        }
    }
    std::ranges::stable_sort(
        rows, {}, [along](const Row& row) { return cross(along, row.line.front() + row.line.back()); });
    return rows;
}

/// The nearest point of a line. Empty if it is beyond an end of the line.
std::optional<Point> footOn(const Polyline& line, Point point) {
    double nearestM = std::numeric_limits<double>::infinity();
    std::optional<Point> foot;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Point way = line[i + 1] - line[i];
        const double share = dot(point - line[i], way) / std::max(dot(way, way), 1e-12);
        const Point at = line[i] + std::clamp(share, 0.0, 1.0) * way;
        if (const double hereM = distance(point, at); hereM < nearestM) {
            nearestM = hereM;
            const bool isBeyond = (i == 0 && share < 0.0) || (i + 2 == line.size() && share > 1.0);
            foot = isBeyond ? std::nullopt : std::optional{at};
        }
    }
    return foot;
}

Polyline densified(const Polyline& line) {
    Polyline dense;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const auto steps =
            std::max(1, static_cast<int>(std::ceil(distance(line[i], line[i + 1]) / kRowLookM)));
        for (int k = 0; k < steps; ++k) {
            dense.push_back(line[i] + (static_cast<double>(k) / steps) * (line[i + 1] - line[i]));
        }
    }
    dense.push_back(line.back());
    return dense;
}

/// The lines half way between each row and the next to its left, numbered like the row on the right.
std::vector<Row> between(const std::vector<Row>& rows) {
    std::vector<Row> middles;
    std::vector<double> apartM;
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
        middles.push_back({rows[i].number, {}});
        double sumM = 0.0;
        for (const Point& point : densified(rows[i].line)) {
            if (const auto foot = footOn(rows[i + 1].line, point)) {
                middles.back().line.push_back(0.5 * (point + *foot));
                sumM += distance(point, *foot);
            }
        }
        const auto count = static_cast<double>(middles.back().line.size());
        apartM.push_back(count > 1.0 ? sumM / count : std::numeric_limits<double>::infinity());
    }
    if (middles.empty()) {
        return middles;
    }
    std::vector<double> sorted = apartM;
    std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2));
    const double mostM = kNeighbours * sorted[sorted.size() / 2];
    std::vector<Row> kept;
    for (std::size_t i = 0; i < middles.size(); ++i) {
        if (apartM[i] <= mostM && middles[i].line.size() > 1) {
            kept.push_back(std::move(middles[i]));
        }
    }
    return kept;
}

Error noRowLeft(bool areSkipped) {
    if (areSkipped) {
        return {.code = ErrorCode::InputRefused,
                .what = "no row is left inside the headland",
                .where = std::string{kSkipRows.key},
                .remedy = "skip fewer rows"};
    }
    return {.code = ErrorCode::InputRefused,
            .what = "no row lies inside the headland",
            .where = std::string{kRows.key},
            .remedy = "check that the rows belong to this field, or choose a narrower headland"};
}

Result<SwathSet> alongRows(const SwathTask& task, const JobContext& job) {
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    if (task.guides == nullptr || task.guides->rows.empty()) {
        return std::unexpected(Error{.code = ErrorCode::Usage,
                                     .what = "rows needs a file of lines",
                                     .where = std::string{kRows.key},
                                     .remedy = "name one, such as GeoJSON with a LineString for each row"});
    }
    std::vector<Row> rows = sortedRows(task.guides->rows);
    if (task.settings.choice(kRowsAt) == "between") {
        rows = between(rows);
    }
    const std::vector<int> skipped = task.settings.numbers(kSkipRows);
    const auto skippedRows =
        std::erase_if(rows, [&](const Row& row) { return std::ranges::contains(skipped, row.number); });
    const MainlandEdges edges{task.mainland};
    const Length radius = swathRadius(task.machine);
    std::vector<SwathLine> lines;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        for (const GuideLine& line : followedLine(rows[i].line, radius)) {
            for (Curve& part : edges.partsInside(drivable(line))) {
                lines.push_back({static_cast<int>(i), std::move(part), rows[i].number - 1});
            }
        }
    }
    if (lines.empty()) {
        return std::unexpected(noRowLeft(skippedRows > 0));
    }
    auto set = swathsOnLines(lines, task, job);
    if (!set) {
        return set;
    }
    // With rows, only the rows are worked. Alleys, skipped rows and land without rows are left on purpose.
    return betweenLanes(*set, task.mainland, job).transform([&](MultiPolygon left) {
        set->leftOnPurpose = std::move(left);
        return std::move(*set);
    });
}

constexpr Choice kPlaces[] = {
    {"on", "On the rows", "The machine drives over them."},
    {"between", "Between the rows", "The machine drives half way between two neighbours."},
};

constexpr const Parameter* kRowsParameters[] = {&kRows, &kRowsAt, &kSkipRows};

}  // namespace

const Parameter kRows{.key = "swaths.rows",
                      .name = "Rows",
                      .description = "A file of lines: planted rows, or the tramlines of a plan.",
                      .kind = ParameterKind::File,
                      .standard = {},
                      .choices = {}};

const Parameter kRowsAt{.key = "swaths.rows_at",
                        .name = "Drive",
                        .description = "On the rows, or between them.",
                        .kind = ParameterKind::Choice,
                        .standard = 0.0,
                        .choices = kPlaces};

const Parameter kSkipRows{
    .key = "swaths.skip",
    .name = "Skip",
    .description = "Rows that are left out, numbered from 1 as in the file; between rows, that on the right.",
    .kind = ParameterKind::Numbers,
    .standard = {},
    .choices = {}};

const Method<SwathGenerator> kRowsMethod{
    .info = {.id = "rows",
             .name = "Rows",
             .description = "Along rows that are there already, or between them.",
             .parameters = kRowsParameters},
    .run = alongRows};

}  // namespace furrow
