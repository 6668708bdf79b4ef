#include "planner/track/track_outline.h"

#include "planner/core/message.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/simplify.h"
#include "planner/track/driven_strips.h"
#include "planner/track/track_jumps.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace furrow {

namespace {

constexpr std::size_t kFewestPositions = 4;
// Positions left out of all: with more the rest is not to be trusted either.
constexpr double kMostJumps = 0.1;
// A standing machine is recorded in every direction.
constexpr double kRecordedStepM = 0.3;
// What receivers differ by from one second to the next.
constexpr Length kLineTolerance = metres(0.03);
constexpr Length kEdgeTolerance = metres(0.05);
constexpr Length kArcs = metres(0.02);
// Rounds that are nearer to each other than twice this are one, and the way to the field and back is none.
constexpr Length kRoundReach = metres(0.75);
constexpr double kGapOfRound = 0.05;
constexpr double kLongWay = 1.6;
constexpr double kWorkedShare = 0.5;
constexpr double kLeastRoundShare = 0.55;
// Of a width: strips of one width disappear, of two they stay.
constexpr double kOpening = 0.55;
constexpr double kLongSpur = 3.0;
constexpr double kLeastFieldM2 = 100.0;
constexpr double kLeastPieceShare = 0.01;

Error refused(Message what, Message remedy, Message where = {}) {
    return {.code = ErrorCode::InputRefused,
            .what = std::move(what),
            .where = std::move(where),
            .remedy = std::move(remedy)};
}

/// A track in metres, without what was never driven.
struct DrivenLine {
    Polyline places;
    std::vector<bool> down;  ///< of each place
    bool tellsDown = false;
    double longestStepM = 0.0;
};

struct DrivenLines {
    LocalFrame frame;
    std::vector<DrivenLine> lines;
    std::vector<Note> notes;

    double lengthM() const {
        return std::transform_reduce(lines.begin(), lines.end(), 0.0, std::plus{},
                                     [](const DrivenLine& line) { return furrow::lengthM(line.places); });
    }
};

Result<LocalFrame> frameOf(std::span<const RecordedTrack> tracks, const TrackOutlineOptions& options) {
    GeoRing places;
    for (const RecordedTrack& track : tracks) {
        if (track.places == TrackPlaces::Local && !options.frame) {
            return std::unexpected(refused(
                "the positions of this track are metres in the plan that was driven, not places on Earth",
                "open the field of that plan first, or record longitude and latitude", track.source));
        }
        for (const TrackSample& sample : track.samples) {
            places.push_back(track.places == TrackPlaces::Local ? options.frame->toGeo(sample.local)
                                                                : sample.geo);
        }
    }
    if (places.size() < kFewestPositions) {
        return std::unexpected(refused(
            counted("the track has {} position only", "the track has {} positions only", places.size()),
            "record a position every second, or every few metres"));
    }
    return LocalFrame::centredOn(middleOf(std::vector{GeoPolygon{.outer = std::move(places), .holes = {}}}));
}

Result<DrivenLines> linesOf(std::span<const RecordedTrack> tracks, const TrackOutlineOptions& options) {
    const auto frame = frameOf(tracks, options);
    if (!frame) {
        return std::unexpected(frame.error());
    }
    DrivenLines driven{.frame = *frame, .lines = {}, .notes = {}};
    std::size_t positions = 0;
    std::size_t jumps = 0;
    std::optional<GeoPoint> firstJump;
    for (const RecordedTrack& track : tracks) {
        Ring places = placesIn(options.frame.value_or(*frame), track);
        if (options.frame) {
            places = frame->toLocal(options.frame->toGeo(places));
        }
        std::vector<std::optional<double>> times;
        std::ranges::transform(track.samples, std::back_inserter(times), &TrackSample::timeS);
        const SteadyTrack steady = withoutJumps(places, times);
        positions += places.size();
        jumps += steady.jumps;
        if (steady.firstJump && !firstJump) {
            firstJump = frame->toGeo(places[*steady.firstJump]);
        }
        DrivenLine line;
        line.longestStepM = steady.longestStepM;
        for (const std::size_t i : steady.kept) {
            const std::optional<bool>& down = track.samples[i].implementDown;
            line.tellsDown = line.tellsDown || down.has_value();
            line.places.push_back(places[i]);
            line.down.push_back(down.value_or(false));
        }
        if (line.places.size() > 1) {
            driven.lines.push_back(std::move(line));
        }
    }
    if (driven.lines.empty()) {
        return std::unexpected(refused("none of the tracks has more than one position",
                                       "record a position every second, or every few metres"));
    }
    if (static_cast<double>(jumps) > kMostJumps * static_cast<double>(positions)) {
        Error error = refused(message("{:.0f} % of the positions jump away and back",
                                      100.0 * static_cast<double>(jumps) / static_cast<double>(positions)),
                              "record with a correction signal (EGNOS, RTK), or under an open sky");
        error.place = firstJump;
        return std::unexpected(std::move(error));
    }
    if (jumps > 0) {
        driven.notes.push_back({.text = counted("{} position that jumped away was left out",
                                                "{} positions that jumped away were left out", jumps),
                                .where = {},
                                .place = firstJump});
    }
    return driven;
}

/// Only the outer rings.
MultiPolygon filled(MultiPolygon polygons) {
    for (Polygon& polygon : polygons) {
        polygon.holes.clear();
    }
    return polygons;
}

MultiPolygon simplifiedRings(MultiPolygon polygons, Length tolerance) {
    for (Polygon& polygon : polygons) {
        polygon.outer = simplifiedRing(std::move(polygon.outer), tolerance);
        for (Ring& hole : polygon.holes) {
            hole = simplifiedRing(std::move(hole), tolerance);
        }
        std::erase_if(polygon.holes, [](const Ring& hole) { return hole.size() < 3; });
    }
    std::erase_if(polygons, [](const Polygon& polygon) { return polygon.outer.size() < 3; });
    return polygons;
}

void dropSmallPieces(MultiPolygon& pieces) {
    double largest = 0.0;
    for (const Polygon& piece : pieces) {
        largest = std::max(largest, area(piece).si());
    }
    std::erase_if(pieces, [largest](const Polygon& piece) {
        return area(piece).si() < std::max(kLeastFieldM2, kLeastPieceShare * largest);
    });
    std::ranges::sort(pieces, std::ranges::greater{}, [](const Polygon& piece) { return area(piece).si(); });
}

// --- Around the field -------------------------------------------------------------------------------------

/// What a line goes around; nothing where it goes around nothing. `gapM` is between its end and its
/// beginning.
Result<MultiPolygon> enclosedBy(Polyline line, Length width, double& gapM, const JobContext& job) {
    gapM = distance(line.back(), line.front());
    if (gapM <= std::max(kGapOfRound * lengthM(line), 2.0 * width.si())) {
        line.push_back(line.front());
    }
    const auto around = aroundLines({simplified(line, kLineTolerance)}, kRoundReach, kArcs, job);
    if (!around) {
        return std::unexpected(around.error());
    }
    auto inside = eroded(filled(*around), kRoundReach, kArcs, job);
    if (inside) {
        dropSmallPieces(*inside);
    }
    return inside;
}

/// One outline of loops: those that lie in another one are its holes.
Result<MultiPolygon> nested(MultiPolygon loops, const JobContext& job) {
    std::ranges::sort(loops, std::ranges::greater{}, [](const Polygon& loop) { return area(loop).si(); });
    MultiPolygon outline;
    for (const Polygon& loop : loops) {
        const bool isHole = std::ranges::any_of(
            outline, [&loop](const Polygon& piece) { return isInside(piece.outer, loop.outer.front()); });
        MultiPolygon withLoop = outline;
        withLoop.push_back(loop);
        auto next = isHole ? difference(outline, {loop}, job) : unionOf(withLoop, job);
        if (!next) {
            return next;
        }
        outline = *std::move(next);
    }
    return outline;
}

struct RoundOutline {
    MultiPolygon outline;  ///< none where nothing is enclosed
    double gapM = 0.0;     ///< of the longest track, from its end to its beginning
};

Result<RoundOutline> roundOutline(const DrivenLines& driven, Length width, const JobContext& job) {
    RoundOutline round;
    MultiPolygon loops;
    Polyline whole;
    double longest = 0.0;
    for (const DrivenLine& line : driven.lines) {
        double gapM = 0.0;
        const auto inside = enclosedBy(line.places, width, gapM, job);
        if (!inside) {
            return std::unexpected(inside.error());
        }
        if (lengthM(line.places) > longest) {
            longest = lengthM(line.places);
            round.gapM = gapM;
        }
        loops.insert(loops.end(), inside->begin(), inside->end());
        whole.insert(whole.end(), line.places.begin(), line.places.end());
    }
    if (loops.empty() && driven.lines.size() > 1) {
        auto inside = enclosedBy(whole, width, round.gapM, job);
        if (!inside) {
            return std::unexpected(inside.error());
        }
        loops = *std::move(inside);
    }
    auto outline = nested(std::move(loops), job);
    if (!outline) {
        return std::unexpected(outline.error());
    }
    round.outline = *std::move(outline);
    return round;
}

// --- Worked land ------------------------------------------------------------------------------------------

/// The stretches that were worked, without breaks, with a point at least every kRecordedStepM.
void addWorked(std::vector<Polyline>& stretches, const DrivenLine& line) {
    Polyline stretch;
    const auto end = [&] {
        if (stretch.size() > 1) {
            stretches.push_back(simplified(stretch, kLineTolerance));
        }
        stretch.clear();
    };
    for (std::size_t i = 0; i < line.places.size(); ++i) {
        if (line.tellsDown && !line.down[i]) {
            end();
            continue;
        }
        const double step = stretch.empty() ? 0.0 : distance(stretch.back(), line.places[i]);
        if (step > line.longestStepM) {
            end();
        }
        if (stretch.empty() || step >= kRecordedStepM) {
            stretch.push_back(line.places[i]);
        }
    }
    end();
}

/// Takes out stretches of one strip, as the way to the field.
Result<void> takeOutSpurs(MultiPolygon& land, double widthM, DrivenLines& driven, const JobContext& job) {
    const auto cores = eroded(land, metres(kOpening * widthM), kEdgeTolerance, job);
    if (!cores) {
        return std::unexpected(cores.error());
    }
    if (cores->empty()) {
        return std::unexpected(
            refused("the strips of this track lie nowhere beside each other",
                    "check the width of the implement, or take the track as driven around the field"));
    }
    const auto around = dilated(*cores, metres(2.0 * kOpening * widthM), kEdgeTolerance, job);
    if (!around) {
        return std::unexpected(around.error());
    }
    auto spurs = difference(land, *around, job);
    if (!spurs) {
        return std::unexpected(spurs.error());
    }
    std::erase_if(*spurs,
                  [widthM](const Polygon& spur) { return area(spur).si() < kLongSpur * widthM * widthM; });
    if (spurs->empty()) {
        return {};
    }
    auto rest = difference(land, *spurs, job);
    if (!rest) {
        return std::unexpected(rest.error());
    }
    land = *std::move(rest);
    driven.notes.push_back(
        {.text = counted("{} stretch of one strip was left out, as a way to the field: {:.0f} m",
                         "{} stretches of one strip were left out, as ways to the field: {:.0f} m together",
                         spurs->size(), area(*spurs).si() / widthM),
         .where = {},
         .place = driven.frame.toGeo(spurs->front().outer.front())});
    return {};
}

Result<MultiPolygon> stripsOf(const DrivenLines& driven, Length width, const JobContext& job) {
    std::vector<Polyline> stretches;
    for (const DrivenLine& line : driven.lines) {
        addWorked(stretches, line);
    }
    MultiPolygon strips;
    for (const Polyline& stretch : stretches) {
        addStripsAlong(strips, stretch, 0.5 * width.si());
    }
    if (strips.empty()) {
        return std::unexpected(refused("the implement was nowhere down on this track",
                                       "take the track as driven around the field, or record the work"));
    }
    return unionOf(strips, job, kSnapGrid);
}

Result<MultiPolygon> workedOutline(MultiPolygon land, DrivenLines& driven, const TrackOutlineOptions& options,
                                   const JobContext& job) {
    const double widthM = options.width.si();
    const Length reach = 0.5 * options.gap.value_or(options.width);
    land = simplifiedRings(std::move(land), kLineTolerance);
    if (reach.si() > 0.0) {
        const auto wide = dilated(land, reach, kArcs, job.part(0.0, 0.3));
        if (!wide) {
            return std::unexpected(wide.error());
        }
        auto closed = eroded(simplifiedRings(*wide, kArcs), reach, kArcs, job.part(0.3, 0.6));
        if (!closed) {
            return std::unexpected(closed.error());
        }
        land = *std::move(closed);
    }
    const double hole = options.smallestHole.value_or(squareMetres(std::max(100.0, widthM * widthM))).si();
    for (Polygon& piece : land) {
        std::erase_if(piece.holes, [hole](const Ring& ring) { return std::abs(signedAreaM2(ring)) < hole; });
    }
    const bool tellsDown = std::ranges::any_of(driven.lines, &DrivenLine::tellsDown);
    if (!tellsDown) {
        if (auto taken = takeOutSpurs(land, widthM, driven, job.part(0.6, 1.0)); !taken) {
            return std::unexpected(taken.error());
        }
    }
    dropSmallPieces(land);
    return simplifiedRings(std::move(land), kEdgeTolerance);
}

// --- Both -------------------------------------------------------------------------------------------------

Result<void> checkOptions(const TrackOutlineOptions& options) {
    const double width = options.width.si();
    if (!(width > 0.0 && width <= 100.0)) {
        return std::unexpected(refused("the operating width is out of range", "give a width up to 100 m"));
    }
    if (!(std::abs(options.beyond.si()) <= 50.0)) {
        return std::unexpected(
            refused("the edge cannot lie that far from the line", "give a distance up to 50 m"));
    }
    if (options.gap && !(options.gap->si() >= 0.0 && options.gap->si() <= 100.0)) {
        return std::unexpected(refused("the gap is out of range", "give a gap up to 100 m"));
    }
    return {};
}

Error nothingEnclosed(const RoundOutline& round, const DrivenLines& driven) {
    Error error =
        refused(message("the track goes around nothing: from its end to its beginning {:.0f} m are missing",
                        round.gapM),
                "drive on to where the recording began, or take the track as worked land");
    error.place = driven.frame.toGeo(driven.lines.front().places.back());
    return error;
}

Result<MultiPolygon> movedOut(MultiPolygon outline, Length beyond, const JobContext& job) {
    const double by = beyond.si();
    return by > 0.0   ? dilated(outline, beyond, kArcs, job)
           : by < 0.0 ? eroded(outline, -beyond, kArcs, job)
                      : Result<MultiPolygon>{std::move(outline)};
}

/// What a track that goes around land was driven for.
TrackKind kindOf(const RoundOutline& round, const MultiPolygon& strips, const DrivenLines& driven) {
    const MultiPolygon whole = filled(strips);
    if (area(strips) < kWorkedShare * area(whole)) {
        return TrackKind::Round;
    }
    double edgeM = 0.0;
    forEachEdge(whole, [&edgeM](Point from, Point to) { edgeM += distance(from, to); });
    // Swaths to and fro enclose every other strip, a single round nearly all of the land.
    const bool isOneRound = area(round.outline) > kLeastRoundShare * area(whole);
    return isOneRound && driven.lengthM() < kLongWay * edgeM ? TrackKind::Round : TrackKind::Worked;
}

}  // namespace

Result<TrackOutline> outlineOfTracks(std::span<const RecordedTrack> tracks,
                                     const TrackOutlineOptions& options, const JobContext& job) {
    if (auto checked = checkOptions(options); !checked) {
        return std::unexpected(checked.error());
    }
    auto driven = linesOf(tracks, options);
    if (!driven) {
        return std::unexpected(driven.error());
    }
    TrackOutline made;
    for (const DrivenLine& line : driven->lines) {
        made.lines.push_back(driven->frame.toGeo(simplified(line.places, kLineTolerance)));
    }
    RoundOutline round;
    if (options.kind != TrackKind::Worked) {
        auto found = roundOutline(*driven, options.width, job.part(0.0, 0.2));
        if (!found) {
            return std::unexpected(found.error());
        }
        round = *std::move(found);
    }
    MultiPolygon strips;
    if (options.kind != TrackKind::Round) {
        auto found = stripsOf(*driven, options.width, job.part(0.2, 0.6));
        if (!found) {
            return std::unexpected(found.error());
        }
        strips = *std::move(found);
    }
    made.kind = options.kind            ? *options.kind
                : round.outline.empty() ? TrackKind::Worked
                                        : kindOf(round, strips, *driven);
    if (made.kind == TrackKind::Round && round.outline.empty()) {
        return std::unexpected(nothingEnclosed(round, *driven));
    }
    auto outline = made.kind == TrackKind::Round
                       ? movedOut(std::move(round.outline), options.beyond, job.part(0.6, 1.0))
                       : workedOutline(std::move(strips), *driven, options, job.part(0.6, 1.0));
    if (!outline) {
        return std::unexpected(outline.error());
    }
    if (outline->empty()) {
        return std::unexpected(refused("nothing is left of the land inside of this track",
                                       "check the width and how far the edge lies from the line"));
    }
    double squareM = 0.0;
    for (const Polygon& piece : *outline) {
        made.pieces.push_back(driven->frame.toGeo(piece));
        squareM += geodesicArea(made.pieces.back()).si();
    }
    made.area = squareMetres(squareM);
    made.notes = std::move(driven->notes);
    return made;
}

std::vector<FieldSource> fieldsOf(const TrackOutline& outline, const std::string& name,
                                  const std::string& origin) {
    std::vector<FieldSource> fields;
    for (const GeoPolygon& piece : outline.pieces) {
        const std::string number = std::to_string(fields.size() + 1);
        FieldSource field;
        field.id = number;
        field.name = outline.pieces.size() == 1 ? name : name + " " + number;
        field.origin = origin;
        field.parts = {piece};
        fields.push_back(std::move(field));
    }
    return fields;
}

}  // namespace furrow
