#include "planner/io/formats/agopengps/agopengps.h"

#include "planner/geodesy/local_frame.h"
#include "planner/io/content/geo_ring.h"
#include "planner/io/files/file_names.h"
#include "planner/io/formats/agopengps/agopengps_plane.h"
#include "planner/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <format>
#include <numbers>
#include <utility>

namespace furrow {

namespace {

// The program drops recorded paths with fewer points.
constexpr std::size_t kFewestPathPoints = 5;
constexpr double kPathSpacingM = 1.0;
constexpr double kCurveSpacingM = 1.5;
constexpr Length kAPlusReach = metres(100.0);

enum TrackMode { kAbMode = 2, kCurveMode = 4 };

/// A text file with the line ends that the program writes.
class TextLines {
public:
    template <class... Values>
    void add(std::format_string<Values...> text, Values&&... values) {
        std::format_to(std::back_inserter(text_), text, std::forward<Values>(values)...);
        text_ += "\r\n";
    }
    FileToWrite asFile(std::filesystem::path path) && {
        return {std::move(path), [text = std::move(text_)] { return text; }};
    }

private:
    std::string text_;
};

/// A millimetre, without zeros at the end and without "-0".
std::string shortMetres(double value) {
    const double rounded = std::round(value * 1000.0) / 1000.0;
    return std::format("{}", rounded == 0.0 ? 0.0 : rounded);
}

/// Clockwise from north, in [0, 2 pi).
double bearingRad(Point from, Point to) {
    const double bearing = std::atan2(to.x - from.x, to.y - from.y);
    return bearing < 0.0 ? bearing + 2.0 * std::numbers::pi : bearing;
}

/// The distance between boundary points that the program itself would choose for a field of this size.
double boundarySpacingM(Area area) {
    return area < squareMetres(200'000.0) ? 1.1 : area < squareMetres(400'000.0) ? 2.2 : 3.3;
}

/// Points at most `spacing` apart, the given ones among them.
std::vector<Point> densified(const std::vector<Point>& line, double spacingM, bool closed) {
    std::vector<Point> dense;
    for (std::size_t i = 0; i < line.size(); ++i) {
        dense.push_back(line[i]);
        if (i + 1 == line.size() && !closed) {
            break;
        }
        const Point next = line[(i + 1) % line.size()];
        const double pieces = std::ceil(distance(line[i], next) / spacingM);
        for (double piece = 1.0; piece < pieces; ++piece) {
            dense.push_back(line[i] + (piece / pieces) * (next - line[i]));
        }
    }
    return dense;
}

class FieldFolder {
public:
    FieldFolder(const FieldContent& content, std::size_t part, const std::string& folder)
        : content_{content},
          outline_{content.field.parts[part]},
          folder_{folder},
          plane_{middleOf({&outline_, 1})},
          spacingM_{boundarySpacingM(geodesicArea(outline_))} {}

    void write(const ExportJob& job, bool withPath, FormatFiles& made) {
        addField(made);
        addBoundary(made);
        addHeadland(made);
        addTracks(made);
        addFlags(made);
        if (withPath) {
            addPaths(*job.plan, made);
        } else {
            addPath({}, "RecPath.txt", made);
        }
        for (const auto& [name, text] :
             {std::pair{"Headlines.txt", "$HeadLines\r\n"}, std::pair{"Contour.txt", "$Contour\r\n"},
              std::pair{"Sections.txt", ""}, std::pair{"Tram.txt", "$Tram\r\n0\r\n0\r\n"}}) {
            made.files.push_back(
                {std::filesystem::path{folder_} / name, [text] { return std::string{text}; }});
        }
    }

private:
    struct PathPoint {
        Point place;
        double speedMps = 0.0;
        bool working = false;
    };

    void put(TextLines&& lines, const char* name, FormatFiles& made) const {
        made.files.push_back(std::move(lines).asFile(std::filesystem::path{folder_} / name));
    }

    std::vector<Point> local(const GeoRing& line) const {
        std::vector<Point> points;
        for (const GeoPoint& point : line) {
            points.push_back(plane_.toLocal(point));
        }
        return points;
    }

    void addField(FormatFiles& made) const {
        TextLines lines;
        // Read over by everybody. The same plan gives the same bytes.
        lines.add("2000-January-01 12:00:00 AM");
        lines.add("$FieldDir");
        lines.add("FieldNew");
        lines.add("$Offsets");
        lines.add("0,0");
        lines.add("Convergence");
        lines.add("0");
        lines.add("StartFix");
        lines.add("{},{}", plane_.origin().latDeg, plane_.origin().lonDeg);
        put(std::move(lines), "Field.txt", made);
    }

    /// Each with the heading from the point before to the point after: the program judges from these what is
    /// inside.
    static void addRing(TextLines& lines, const std::vector<Point>& ring) {
        lines.add("{}", ring.size());
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point before = ring[(i + ring.size() - 1) % ring.size()];
            const Point after = ring[(i + 1) % ring.size()];
            lines.add("{},{},{:.5f}", shortMetres(ring[i].x), shortMetres(ring[i].y),
                      bearingRad(before, after));
        }
    }

    /// Outer rings counter-clockwise, inner ones clockwise.
    std::vector<Point> ringOf(GeoRing ring, bool outer) const {
        if (isCounterClockwise(ring) != outer) {
            std::ranges::reverse(ring);
        }
        return densified(local(ring), outer ? spacingM_ : spacingM_ / 2.0, true);
    }

    struct InnerRing {
        GeoRing ring;
        bool passable = false;
    };
    std::vector<InnerRing> innerRings() const {
        std::vector<InnerRing> rings;
        for (const GeoRing& hole : outline_.holes) {
            rings.push_back({hole});
        }
        for (const Obstacle& obstacle : content_.field.obstacles) {
            if (contains(outline_.outer, obstacle.outline.outer.front())) {
                rings.push_back({obstacle.outline.outer, obstacle.passable});
            }
        }
        return rings;
    }

    void addBoundary(FormatFiles& made) const {
        TextLines lines;
        lines.add("$Boundary");
        lines.add("False");
        addRing(lines, ringOf(outline_.outer, true));
        for (const InnerRing& inner : innerRings()) {
            lines.add("{}", inner.passable ? "True" : "False");
            addRing(lines, ringOf(inner.ring, false));
        }
        put(std::move(lines), "Boundary.txt", made);
    }

    /// For each ring of the boundary, in its order, the mainland's ring that goes with it.
    void addHeadland(FormatFiles& made) const {
        TextLines lines;
        lines.add("$Headland");
        const GeoPolygon* largest = nullptr;
        for (const GeoPolygon& polygon : content_.mainland) {
            if (contains(outline_.outer, polygon.outer.front()) &&
                (largest == nullptr || geodesicArea(*largest) < geodesicArea(polygon))) {
                largest = &polygon;
            }
        }
        if (largest != nullptr) {
            addRing(lines, ringOf(largest->outer, true));
            for (const InnerRing& inner : innerRings()) {
                const auto around = std::ranges::find_if(largest->holes, [&inner](const GeoRing& hole) {
                    return contains(hole, inner.ring.front());
                });
                if (around == largest->holes.end()) {
                    lines.add("0");
                } else {
                    addRing(lines, ringOf(*around, false));
                }
            }
        }
        put(std::move(lines), "Headland.txt", made);
    }

    void addTracks(FormatFiles& made) const {
        TextLines lines;
        lines.add("$TrackLines");
        UniqueNames names{60, false};
        for (const GuidanceLine& line : content_.lines) {
            const std::vector<Point> points = local(drawn(line, kAPlusReach));
            if (points.size() < 2) {
                continue;
            }
            const bool straight = points.size() == 2;
            const std::vector<Point> curve =
                straight ? std::vector<Point>{} : densified(points, kCurveSpacingM, false);
            Point sum{};
            for (std::size_t i = 1; i < curve.size(); ++i) {
                const Point step = curve[i] - curve[i - 1];
                sum = sum + (norm(step) > 0.0 ? 1.0 / norm(step) : 0.0) * step;
            }
            lines.add("{}", names.unique(line.name, "Line"));
            lines.add("{:.10f}", straight ? bearingRad(points[0], points[1]) : bearingRad({}, sum));
            lines.add("{},{}", shortMetres(points.front().x), shortMetres(points.front().y));
            lines.add("{},{}", shortMetres(points.back().x), shortMetres(points.back().y));
            lines.add("0");
            lines.add("{}", static_cast<int>(straight ? kAbMode : kCurveMode));
            lines.add("True");
            lines.add("{}", curve.size());
            for (std::size_t i = 0; i < curve.size(); ++i) {
                const std::size_t from = std::min(i, curve.size() - 2);
                lines.add("{},{},{:.5f}", shortMetres(curve[i].x), shortMetres(curve[i].y),
                          bearingRad(curve[from], curve[from + 1]));
            }
        }
        put(std::move(lines), "TrackLines.txt", made);
    }

    void addFlags(FormatFiles& made) const {
        TextLines lines;
        const auto& gates = content_.field.gates;
        lines.add("$Flags");
        lines.add("{}", gates.size());
        constexpr int kGreen = 1;
        UniqueNames names{60, false};
        for (std::size_t i = 0; i < gates.size(); ++i) {
            const Point place = plane_.toLocal(gates[i].position);
            std::string name = names.unique(gates[i].name, "Gate");
            std::ranges::replace(name, ',', ' ');
            lines.add("{},{},{},{},0,{},{},{}", gates[i].position.latDeg, gates[i].position.lonDeg,
                      shortMetres(place.x), shortMetres(place.y), kGreen, i + 1, name);
        }
        put(std::move(lines), "Flags.txt", made);
    }

    /// A place on the way from one sample to the next.
    static PathPoint between(const PathSample& from, const PathSample& to, double share, bool working) {
        return {.place = from.position + share * (to.position - from.position),
                .speedMps = std::lerp(from.speedMps, to.speedMps, share),
                .working = working};
    }

    /// About a metre apart, also on straights, which a plan tells by their ends; the ends of every segment
    /// among them, cut where the gear changes.
    std::vector<std::vector<PathPoint>> forwardStretches(const Plan& plan, int& reversed) const {
        std::vector<std::vector<PathPoint>> stretches(1);
        for (const PathSegment& segment : plan.path.segments) {
            if (segment.gear == Gear::Reverse) {
                ++reversed;
                if (!stretches.back().empty()) {
                    stretches.emplace_back();
                }
                continue;
            }
            for (const PathPoint& point : spacedOut(segment)) {
                auto& stretch = stretches.back();
                const Point place = plane_.toLocal(plan.field().frame().toGeo(point.place));
                if (!stretch.empty() && distance(stretch.back().place, place) < 1e-3) {
                    stretch.back().working = point.working;
                } else {
                    stretch.push_back({place, point.speedMps, point.working});
                }
            }
        }
        return stretches;
    }

    /// In the plan's frame.
    static std::vector<PathPoint> spacedOut(const PathSegment& segment) {
        std::vector<PathPoint> points;
        double lastM = -kPathSpacingM;
        const std::vector<PathSample>& samples = segment.samples;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double gapM = i == 0 ? 0.0 : samples[i].sM - samples[i - 1].sM;
            const auto inserted = static_cast<int>(std::ceil(gapM / kPathSpacingM)) - 1;
            for (int k = 1; k <= inserted; ++k) {
                points.push_back(
                    between(samples[i - 1], samples[i], k / (inserted + 1.0), segment.implementDown));
                lastM = samples[i - 1].sM + gapM * k / (inserted + 1.0);
            }
            if (samples[i].sM - lastM >= kPathSpacingM || i + 1 == samples.size()) {
                points.push_back({samples[i].position, samples[i].speedMps, segment.implementDown});
                lastM = samples[i].sM;
            }
        }
        return points;
    }

    void addPath(const std::vector<PathPoint>& points, const std::string& name, FormatFiles& made) const {
        TextLines lines;
        lines.add("$RecPath");
        lines.add("{}", points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::size_t from = std::min(i, points.size() - 2);
            lines.add("{},{},{:.3f},{:.1f},{}", shortMetres(points[i].place.x),
                      shortMetres(points[i].place.y), bearingRad(points[from].place, points[from + 1].place),
                      points[i].speedMps * 3.6, points[i].working ? "True" : "False");
        }
        put(std::move(lines), name.c_str(), made);
    }

    void addPaths(const Plan& plan, FormatFiles& made) const {
        int reversed = 0;
        auto stretches = forwardStretches(plan, reversed);
        const auto all = stretches.size();
        std::erase_if(stretches, [](const auto& stretch) { return stretch.size() < kFewestPathPoints; });
        if (stretches.size() == 1) {
            addPath(stretches.front(), "RecPath.txt", made);
        } else {
            addPath(stretches.empty() ? std::vector<PathPoint>{} : stretches.front(), "RecPath.txt", made);
            for (std::size_t i = 0; i < stretches.size(); ++i) {
                addPath(stretches[i], std::format("Part {:02}.rec", i + 1), made);
            }
        }
        if (reversed > 0) {
            made.notes.push_back(message(
                "AgOpenGPS drives recorded paths forwards only, and this one reverses {} times: its {} forward "
                "stretches are 'Part 01.rec' and so on, RecPath.txt is the first; {} under 5 m are left out.",
                reversed, stretches.size(), all - stretches.size()));
        }
    }

    const FieldContent& content_;
    const GeoPolygon& outline_;
    std::string folder_;
    AgOpenGpsPlane plane_;
    double spacingM_;
};

}  // namespace

Result<FormatFiles> writeAgOpenGps(const ExportJob& job) {
    FormatFiles made;
    UniqueNames folders{56, job.options.asciiNames};
    for (const FieldContent& content : job.fields) {
        if (job.job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        for (std::size_t part = 0; part < content.field.parts.size(); ++part) {
            const std::string folder = folders.unique(safeFileName(content.field.name, "Field"), "Field");
            FieldFolder{content, part, folder}.write(job, job.plan != nullptr && part == 0, made);
        }
        if (content.field.parts.size() > 1) {
            made.notes.push_back(message(
                job.plan == nullptr
                    ? "AgOpenGPS keeps one outline to a field: the {} parts of '{}' are fields of their own."
                    : "AgOpenGPS keeps one outline to a field: the {} parts of '{}' are fields of their "
                      "own, and the whole path is in the first.",
                content.field.parts.size(), content.field.name));
        }
    }
    return made;
}

}  // namespace furrow
