#include "planner/evaluation/comparison_report.h"

#include "planner/report/map_picture.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <format>
#include <iterator>
#include <limits>
#include <optional>

namespace furrow {

namespace {

using Json = nlohmann::ordered_json;

// --- Picture ----------------------------------------------------------------------------------------

/// Tracks are drawn in these classes of distance from the plan.
struct ErrorClass {
    double upToM;
    std::string_view name;
    std::string_view colour;
    double width;
};
constexpr ErrorClass kClasses[] = {
    {0.05, "up to 5 cm", "#8cc5e8", 1.8},  {0.10, "up to 10 cm", "#3d9bd6", 1.8},
    {0.25, "up to 25 cm", "#0b5c97", 1.8}, {0.50, "up to 50 cm", "#e69f00", 2.2},
    {1.00, "up to 1 m", "#d55e00", 2.2},   {std::numeric_limits<double>::infinity(), "more", "#7a1f00", 2.6},
};
constexpr std::size_t kUnmatched = std::size(kClasses);

std::size_t classOf(const std::optional<TrackMatch>& match) {
    if (!match) {
        return kUnmatched;
    }
    const auto found = std::ranges::find_if(kClasses, [&match](const ErrorClass& errorClass) {
        return std::abs(match->crossTrackM) <= errorClass.upToM;
    });
    return static_cast<std::size_t>(found - std::ranges::begin(kClasses));
}

/// The track in pieces of one class each; neighbouring pieces share a point.
void addPieces(const Ring& places, const std::vector<std::optional<TrackMatch>>& matches,
               std::vector<std::vector<Polyline>>& lines) {
    for (std::size_t i = 1; i < places.size(); ++i) {
        const std::size_t now = classOf(matches[i]);
        if (i == 1 || classOf(matches[i - 1]) != now) {
            lines[now].push_back({places[i - 1]});
        }
        lines[now].back().push_back(places[i]);
    }
}

void addPlannedPath(const Path& path, std::vector<MapLayer>& layers) {
    MapLayer swaths{
        .name = "planned swath or headland pass", .stroke = "#9aa5b1", .width = 1.0, .arrows = true};
    MapLayer others{.name = "planned turn or transfer", .stroke = "#b8a9c9", .width = 1.0, .dash = "3 2"};
    for (const PathSegment& segment : path.segments) {
        Polyline line;
        for (const PathSample& sample : segment.samples) {
            line.push_back(sample.position);
        }
        const bool works = segment.kind == SegmentKind::Swath || segment.kind == SegmentKind::HeadlandPass;
        (works ? swaths : others).lines.push_back(std::move(line));
    }
    layers.push_back(std::move(others));
    layers.push_back(std::move(swaths));
}

/// Parts far from the plan would make the picture small. They are cut off beside the plan, at a tenth of its
/// size.
std::vector<Polyline> nearPlan(const std::vector<Polyline>& lines, const Bounds& plan) {
    const Bounds room = widened(plan, 0.1 * std::max(plan.width(), plan.height()));
    std::vector<Polyline> kept;
    for (const Polyline& line : lines) {
        Polyline piece;
        for (const Point& point : line) {
            if (contains(room, point)) {
                piece.push_back(point);
            } else if (!piece.empty()) {
                kept.push_back(std::exchange(piece, {}));
            }
        }
        kept.push_back(std::move(piece));
    }
    return kept;
}

Bounds boundsOf(const WrittenPath& plan) {
    Ring all;
    for (const PathSegment& segment : plan.path.segments) {
        for (const PathSample& sample : segment.samples) {
            all.push_back(sample.position);
        }
    }
    for (const Polygon& part : plan.field) {
        all.insert(all.end(), part.outer.begin(), part.outer.end());
    }
    return bounds(all);
}

// --- Figures ----------------------------------------------------------------------------------------

std::string_view kindTitle(SegmentKind kind) {
    switch (kind) {
        case SegmentKind::Swath: return "Swaths";
        case SegmentKind::Turn: return "Turns";
        case SegmentKind::HeadlandPass: return "Headland passes";
        case SegmentKind::Transfer: return "Transfers";
        case SegmentKind::Refill: return "Refills";
        case SegmentKind::Wait: return "Waiting";
    }
    return "";
}

Json speedJson(const std::optional<Speed>& speed) {
    return speed ? Json(speed->si()) : Json();
}

Json figuresJson(const CrossTrackFigures& figures) {
    return {{"samples", figures.samples},
            {"median_m", figures.median.si()},
            {"p95_m", figures.p95.si()},
            {"largest_m", figures.largest.si()},
            {"mean_signed_m", figures.mean.si()},
            {"recorded_speed_mps", speedJson(figures.recordedSpeed)},
            {"planned_speed_mps", speedJson(figures.plannedSpeed)}};
}

std::string speedText(const CrossTrackFigures& figures) {
    const auto kmh = [](const std::optional<Speed>& speed) {
        return speed ? std::format("{:.1f}", 3.6 * speed->si()) : std::string{"-"};
    };
    return std::format("{:>7} ({})", kmh(figures.recordedSpeed), kmh(figures.plannedSpeed));
}

std::string row(std::string_view title, const CrossTrackFigures& figures) {
    return std::format("{:<16} {:>9} {:>8.3f} {:>8.3f} {:>8.3f} {:>+8.3f} {}\n", title, figures.samples,
                       figures.median.si(), figures.p95.si(), figures.largest.si(), figures.mean.si(),
                       speedText(figures));
}

std::string number(const std::optional<double>& value) {
    return value ? std::format("{}", *value) : std::string{};
}

}  // namespace

std::string comparisonCsv(const ComparisonReport& report) {
    std::string text = "track,time_s,lon_deg,lat_deg,x_m,y_m,s_m,segment,order,cross_track_m\n";
    const auto out = std::back_inserter(text);
    for (std::size_t t = 0; t < report.tracks.size(); ++t) {
        const RecordedTrack& track = report.tracks[t];
        const Ring places = placesIn(report.plan.frame, track);
        const GeoRing geo = report.plan.frame.toGeo(places);
        for (std::size_t i = 0; i < track.samples.size(); ++i) {
            const TrackSample& sample = track.samples[i];
            const GeoPoint at = track.places == TrackPlaces::Wgs84 ? sample.geo : geo[i];
            std::format_to(out, "{},{},{},{},{:.4f},{:.4f},", t + 1, number(sample.timeS), at.lonDeg,
                           at.latDeg, places[i].x, places[i].y);
            if (const auto& match = report.comparison.matches[t][i]) {
                std::format_to(out, "{:.4f},{},{},{:.4f}\n", match->sM, segmentKindId(match->kind),
                               match->segment, match->crossTrackM);
            } else {
                text += ",,,\n";
            }
        }
    }
    return text;
}

std::string comparisonSvg(const ComparisonReport& report) {
    MapPicture picture{.title = std::format("{}: recorded and planned", report.plan.name)};
    const CrossTrackFigures& all = report.comparison.overall;
    picture.note = std::format(
        "{} positions, {:.1f} % of them within {:.1f} m of the plan. Distance from the plan: median {:.2f} "
        "m, 95 % "
        "up to {:.2f} m, largest {:.2f} m.",
        report.comparison.samples, 100.0 * report.comparison.matchedShare(), report.radius.si(),
        all.median.si(), all.p95.si(), all.largest.si());
    if (!report.plan.field.empty()) {
        picture.layers.push_back({.name = "field",
                                  .areas = report.plan.field,
                                  .fill = "#f4f1e8",
                                  .stroke = "#8d7b4f",
                                  .width = 1.4});
    }
    if (!report.plan.obstacles.empty()) {
        picture.layers.push_back(
            {.name = "obstacle", .areas = report.plan.obstacles, .fill = "#d9dde2", .stroke = "#52606d"});
    }
    addPlannedPath(report.plan.path, picture.layers);
    std::vector<std::vector<Polyline>> lines(kUnmatched + 1);
    for (std::size_t t = 0; t < report.tracks.size(); ++t) {
        addPieces(placesIn(report.plan.frame, report.tracks[t]), report.comparison.matches[t], lines);
    }
    const Bounds plan = boundsOf(report.plan);
    if (!lines[kUnmatched].empty()) {
        picture.layers.push_back({.name = "recorded, not on the plan",
                                  .lines = nearPlan(lines[kUnmatched], plan),
                                  .stroke = "#6b4c9a",
                                  .width = 1.2,
                                  .dash = "1 3"});
    }
    bool first = true;
    for (std::size_t i = 0; i < kUnmatched; ++i) {
        if (!lines[i].empty()) {
            picture.layers.push_back(
                {.name = std::format("{}{}", first ? "recorded, beside the plan by " : "", kClasses[i].name),
                 .lines = std::move(lines[i]),
                 .stroke = kClasses[i].colour,
                 .width = kClasses[i].width});
            first = false;
        }
    }
    return svgOf(picture);
}

std::string comparisonJson(const ComparisonReport& report) {
    const TrackComparison& comparison = report.comparison;
    Json kinds = Json::object();
    for (const KindFigures& kind : comparison.kinds) {
        kinds[segmentKindId(kind.kind)] = figuresJson(kind.figures);
    }
    Json tracks = Json::array();
    for (const RecordedTrack& track : report.tracks) {
        tracks.push_back({{"source", track.source},
                          {"places", track.places == TrackPlaces::Wgs84 ? "wgs84" : "local"},
                          {"samples", track.samples.size()}});
    }
    Json notes = Json::array();
    for (const Note& note : report.notes) {
        notes.push_back(note.text);
    }
    const Json all{{"field", report.plan.name},      {"format", report.format},
                   {"tracks", std::move(tracks)},    {"samples", comparison.samples},
                   {"matched", comparison.matched},  {"matched_share", comparison.matchedShare()},
                   {"radius_m", report.radius.si()}, {"overall", figuresJson(comparison.overall)},
                   {"kinds", std::move(kinds)},      {"notes", std::move(notes)}};
    return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string comparisonText(const ComparisonReport& report) {
    const TrackComparison& comparison = report.comparison;
    std::string text =
        std::format("Plan      {} · {:.2f} km\n", report.plan.name, report.plan.path.length().si() / 1000.0);
    text += std::format("Track     {} · {} {} · {} positions · {:.1f} % within {:.1f} m of the plan\n",
                        report.format, report.tracks.size(), report.tracks.size() == 1 ? "track" : "tracks",
                        comparison.samples, 100.0 * comparison.matchedShare(), report.radius.si());
    for (const Note& note : report.notes) {
        text += std::format("Note      {}\n", note.text.text());
    }
    text += std::format("\n{:<16} {:>9} {:>8} {:>8} {:>8} {:>8}  km/h (planned)\n", "Beside the plan, m",
                        "positions", "median", "95 %", "largest", "mean");
    for (const KindFigures& kind : comparison.kinds) {
        text += row(kindTitle(kind.kind), kind.figures);
    }
    text += row("All", comparison.overall);
    return text + "Mean: signed, positive to the left of the way of driving.\n";
}

}  // namespace furrow
