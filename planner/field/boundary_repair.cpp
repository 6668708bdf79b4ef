#include "planner/field/boundary_repair.h"

#include "planner/core/place_message.h"
#include "planner/geometry/geos_bridge.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace furrow {

namespace {

// Closer points are one point: a tenth of the resolution of the best receivers.
constexpr double kSamePointM = 1e-3;
// A smaller enclosed area of land is a drawing error.
constexpr double kSliverM2 = 1.0;
constexpr double kSliverShare = 1e-4;
// No field is smaller than this.
constexpr double kNoAreaM2 = 1e-2;

/// A ring in both coordinate systems, point by point.
struct TwinRing {
    GeoRing geo;
    Ring local;
};

struct TwinPolygon {
    TwinRing outer;
    std::vector<TwinRing> holes;
};

bool isSpike(Point before, Point tip, Point after) {
    const Point in = tip - before;
    const Point out = after - tip;
    if (dot(in, out) >= 0.0) {
        return false;
    }
    // A spike returns along its own way: the shorter leg's end is within a point's width of the other leg.
    const double longer = std::max(norm(in), norm(out));
    return std::abs(cross(in, out)) <= kSamePointM * longer;
}

/// Whether a ring is everywhere narrower than two equal points. A pole is small, but not a line.
bool isLine(const Ring& ring) {
    double perimeterM = 0.0;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        perimeterM += distance(ring[j], ring[i]);
    }
    return std::abs(signedAreaM2(ring)) <= 0.5 * kSamePointM * perimeterM;
}

/// Whether a ring has three different points.
bool hasCorners(const GeoRing& ring) {
    const auto first = std::ranges::find_if(ring, [&ring](GeoPoint point) { return point != ring.front(); });
    return std::ranges::any_of(ring,
                               [&](GeoPoint point) { return point != ring.front() && point != *first; });
}

/// Land may lose slivers. Obstacles keep every part.
enum class RepairOf { Land, Obstacle };

/// The points of a ring without those that are given twice, and without spikes.
class PointSieve {
public:
    struct Dropped {
        int count = 0;
        std::size_t first = 0;
    };

    PointSieve(const GeoRing& ring, const Ring& local) : local_{local} {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            if (i + 1 == ring.size() && ring.size() > 1 && ring[i] == ring.front()) {
                break;  // the closing point, as most formats write it
            }
            kept_.push_back(i);
            // Without a point, the one before it may become a duplicate or a spike in turn.
            while (dropsBeforeEnd()) {
            }
        }
        while (dropsWhereItCloses()) {
        }
    }

    const std::vector<std::size_t>& kept() const { return kept_; }
    const Dropped& doubled() const { return doubled_; }
    const Dropped& spikes() const { return spikes_; }

private:
    bool same(std::size_t a, std::size_t b) const { return distance(local_[a], local_[b]) < kSamePointM; }
    bool isSpikeAt(std::size_t before, std::size_t tip, std::size_t after) const {
        return isSpike(local_[before], local_[tip], local_[after]);
    }
    /// Always true.
    bool drop(Dropped& dropped, std::size_t at) {
        if (dropped.count++ == 0) {
            dropped.first = kept_[at];
        }
        kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(at));
        return true;
    }
    bool dropsBeforeEnd() {
        const std::size_t n = kept_.size();
        if (n >= 2 && same(kept_[n - 2], kept_[n - 1])) {
            return drop(doubled_, n - 1);
        }
        return n >= 3 && isSpikeAt(kept_[n - 3], kept_[n - 2], kept_[n - 1]) && drop(spikes_, n - 2);
    }
    bool dropsWhereItCloses() {
        const std::size_t n = kept_.size();
        if (n < 3) {
            return false;
        }
        if (same(kept_[n - 1], kept_[0])) {
            return drop(doubled_, n - 1);
        }
        if (isSpikeAt(kept_[n - 2], kept_[n - 1], kept_[0])) {
            return drop(spikes_, n - 1);
        }
        return isSpikeAt(kept_[n - 1], kept_[0], kept_[1]) && drop(spikes_, 0);
    }

    const Ring& local_;
    std::vector<std::size_t> kept_;
    Dropped doubled_;
    Dropped spikes_;
};

class Repair {
public:
    Repair(const LocalFrame& frame, Message what, RepairOf kind, const JobContext& job)
        : frame_{frame}, what_{std::move(what)}, kind_{kind}, job_{job} {}

    Result<RepairedBoundary> run(const std::vector<GeoPolygon>& parts) {
        std::vector<TwinPolygon> cleaned;
        const std::vector<bool> slivers = sliverParts(parts);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (slivers[i]) {
                continue;
            }
            auto polygon = cleanedPolygon(parts[i], i, parts.size());
            if (!polygon) {
                return std::unexpected(polygon.error());
            }
            cleaned.push_back(std::move(*polygon));
        }
        RepairedBoundary result;
        for (const TwinPolygon& polygon : cleaned) {
            Polygon local{.outer = polygon.outer.local, .holes = {}};
            GeoPolygon geo{.outer = polygon.outer.geo, .holes = {}};
            for (const TwinRing& hole : polygon.holes) {
                local.holes.push_back(hole.local);
                geo.holes.push_back(hole.geo);
            }
            result.local.push_back(std::move(local));
            result.geo.push_back(std::move(geo));
        }
        auto problem = findInvalidPlace(result.local, job_);
        if (!problem) {
            return std::unexpected(problem.error());
        }
        if (problem->has_value()) {
            auto untangled = untangledPolygons(result.local, **problem);
            if (!untangled) {
                return std::unexpected(untangled.error());
            }
            result.local = std::move(*untangled);
            result.geo.clear();
            for (const Polygon& polygon : result.local) {
                result.geo.push_back(frame_.toGeo(polygon));
            }
        }
        if (reversed_ > 0) {
            note(counted("{} ring ran the wrong way round and was turned",
                         "{} rings ran the wrong way round and were turned", reversed_),
                 parts.front().outer.front());
        }
        result.repairs = std::move(repairs_);
        return result;
    }

private:
    Error refused(Message what, Message remedy, std::optional<GeoPoint> place, const Message& where) const {
        return {.code = ErrorCode::InputRefused,
                .what = std::move(what),
                .where = where.empty() ? what_ : message("{}, {}", what_, where),
                .remedy = std::move(remedy),
                .place = place};
    }

    void note(Message text, GeoPoint place) { repairs_.push_back({std::move(text), what_, place}); }

    /// Finds parts of land that are drawing errors beside the rest of it, with a note for each.
    std::vector<bool> sliverParts(const std::vector<GeoPolygon>& parts) {
        std::vector<bool> slivers(parts.size(), false);
        if (kind_ == RepairOf::Obstacle || parts.size() < 2) {
            return slivers;
        }
        std::vector<double> enclosedM2;
        double wholeM2 = 0.0;
        for (const GeoPolygon& part : parts) {
            enclosedM2.push_back(enclosedBy(frame_.toLocal(part.outer)));
            wholeM2 += enclosedM2.back();
        }
        for (std::size_t i = 0; i < parts.size(); ++i) {
            slivers[i] =
                hasCorners(parts[i].outer) && enclosedM2[i] < std::min(kSliverM2, kSliverShare * wholeM2);
            if (slivers[i]) {
                note(message("a sliver of {:.2f} m² was left out", enclosedM2[i]), parts[i].outer.front());
            }
        }
        return slivers;
    }

    /// The enclosed area of any ring, even invalid. Both wings of a bow-tie count.
    double enclosedBy(const Ring& ring) const {
        const double signedM2 = ring.size() < 3 ? 0.0 : std::abs(signedAreaM2(ring));
        if (ring.size() < 3 || signedM2 >= kSliverM2) {
            return signedM2;
        }
        const auto valid = madeValid({Polygon{.outer = ring, .holes = {}}}, job_);
        return valid ? area(*valid).si() : signedM2;
    }

    bool enclosesNothing(const Ring& ring, bool isLand) const {
        const bool nothing = isLand ? std::abs(signedAreaM2(ring)) < kNoAreaM2 : isLine(ring);
        return nothing && !crossesItself(ring);
    }

    Result<TwinPolygon> cleanedPolygon(const GeoPolygon& polygon, std::size_t index, std::size_t count) {
        const Message part = count > 1 ? message("part {}", index + 1) : Message{};
        TwinPolygon cleaned{.outer = cleanedRing(polygon.outer, true), .holes = {}};
        const auto place = polygon.outer.empty() ? std::nullopt : std::optional{polygon.outer.front()};
        if (cleaned.outer.local.size() < 3) {
            return std::unexpected(refused("fewer than 3 different points enclose nothing",
                                           "draw it again with at least 3 corners", place, part));
        }
        if (enclosesNothing(cleaned.outer.local, kind_ == RepairOf::Land)) {
            return std::unexpected(refused("its points enclose no area", "draw it again", place, part));
        }
        for (std::size_t i = 0; i < polygon.holes.size(); ++i) {
            TwinRing hole = cleanedRing(polygon.holes[i], false);
            if (hole.local.size() < 3 || enclosesNothing(hole.local, false)) {
                note(message("hole {} encloses no area and was left out", i + 1),
                     polygon.holes[i].empty() ? polygon.outer.front() : polygon.holes[i].front());
                continue;
            }
            cleaned.holes.push_back(std::move(hole));
        }
        return cleaned;
    }

    // The two wings of a bow-tie cancel out in the signed area, so this check has to find it.
    bool crossesItself(const Ring& ring) const {
        const auto problem = findInvalidPlace({Polygon{.outer = ring, .holes = {}}}, job_);
        return problem && problem->has_value() && (*problem)->reason == "Self-intersection";
    }

    TwinRing cleanedRing(const GeoRing& ring, bool outer) {
        const Ring local = frame_.toLocal(ring);
        const PointSieve sieve{ring, local};
        TwinRing cleaned;
        for (const std::size_t index : sieve.kept()) {
            cleaned.geo.push_back(ring[index]);
            cleaned.local.push_back(local[index]);
        }
        if (sieve.doubled().count > 0) {
            note(counted("{} point was given twice and taken once",
                         "{} points were given twice and taken once", sieve.doubled().count),
                 ring[sieve.doubled().first]);
        }
        if (sieve.spikes().count > 0) {
            note(counted("{} spike without area was removed", "{} spikes without area were removed",
                         sieve.spikes().count),
                 ring[sieve.spikes().first]);
        }
        if ((signedAreaM2(cleaned.local) > 0.0) != outer) {
            std::ranges::reverse(cleaned.geo);
            std::ranges::reverse(cleaned.local);
            ++reversed_;
        }
        return cleaned;
    }

    Result<MultiPolygon> untangledPolygons(const MultiPolygon& tangled, const InvalidPlace& problem) {
        const std::size_t repairsBefore = repairs_.size();
        MultiPolygon shells;
        MultiPolygon holes;
        for (const Polygon& polygon : tangled) {
            if (auto shell = untangledRing(polygon.outer, kind_); !shell) {
                return shell;
            } else {
                std::ranges::move(*shell, std::back_inserter(shells));
            }
            for (const Ring& hole : polygon.holes) {
                Ring outline = hole;
                std::ranges::reverse(outline);
                auto untangled = untangledRing(outline, RepairOf::Obstacle);
                if (!untangled) {
                    return untangled;
                }
                const auto inside =
                    intersection(*untangled, {Polygon{.outer = polygon.outer, .holes = {}}}, job_);
                if (inside && inside->empty()) {
                    return std::unexpected(refused("a hole lies outside the boundary", "move or delete it",
                                                   frame_.toGeo(hole.front()), ""));
                }
                std::ranges::move(*untangled, std::back_inserter(holes));
            }
        }
        auto land = unionOf(shells, job_);
        if (!land) {
            return land;
        }
        auto taken = unionOf(holes, job_);
        if (!taken) {
            return taken;
        }
        auto result = difference(*land, *taken, job_);
        if (!result) {
            return result;
        }
        if (repairs_.size() == repairsBefore) {
            // Each ring was valid alone.
            note("rings that overlap each other were joined", frame_.toGeo(problem.place));
        }
        if (kind_ == RepairOf::Land) {
            dropSlivers(*result);
        }
        if (result->empty()) {
            return std::unexpected(refused("its holes leave nothing of it", "delete the hole that covers it",
                                           frame_.toGeo(problem.place), ""));
        }
        return result;
    }

    Result<MultiPolygon> untangledRing(const Ring& ring, RepairOf kind) {
        MultiPolygon alone{Polygon{.outer = ring, .holes = {}}};
        const auto problem = findInvalidPlace(alone, job_);
        if (!problem) {
            return std::unexpected(problem.error());
        }
        if (!problem->has_value()) {
            return alone;
        }
        auto untangled = madeValid(alone, job_);
        if (!untangled) {
            return untangled;
        }
        // Loops that only touch add up to the ring's signed area. Wings that cross cancel out; loops that
        // overlap count twice. Only the first case has one obvious meaning.
        const double signedM2 = std::abs(signedAreaM2(ring));
        const double enclosedM2 = area(*untangled).si();
        const double sliverM2 = std::max(kSliverM2, kSliverShare * enclosedM2);
        const GeoPoint place = frame_.toGeo((*problem)->place);
        if (std::abs(signedM2 - enclosedM2) > sliverM2) {
            return std::unexpected(
                refused(message("the line crosses itself at {}", placeMessage(place)),
                        "move one of the points there, so that it is clear which side is field", place, ""));
        }
        note("the line touches or crosses itself by a sliver; taken apart there", place);
        if (kind == RepairOf::Land) {
            dropSlivers(*untangled);
        }
        return untangled;
    }

    void dropSlivers(MultiPolygon& polygons) {
        const double sliverM2 = std::max(kSliverM2, kSliverShare * area(polygons).si());
        if (polygons.size() < 2) {
            return;
        }
        std::erase_if(polygons, [&](const Polygon& polygon) {
            const double m2 = area(polygon).si();
            if (m2 >= sliverM2) {
                return false;
            }
            note(message("a sliver of {:.2f} m² was left out", m2), frame_.toGeo(polygon.outer.front()));
            return true;
        });
    }

    const LocalFrame& frame_;
    Message what_;
    RepairOf kind_;
    const JobContext& job_;
    std::vector<Note> repairs_;
    int reversed_ = 0;
};

}  // namespace

Result<RepairedBoundary> repairBoundary(const std::vector<GeoPolygon>& parts, const LocalFrame& frame,
                                        const std::string& what, const JobContext& job) {
    return Repair{frame, what, RepairOf::Land, job}.run(parts);
}

Result<RepairedBoundary> repairObstacle(const GeoPolygon& outline, const LocalFrame& frame,
                                        const std::string& what, const JobContext& job) {
    return Repair{frame, what, RepairOf::Obstacle, job}.run({outline});
}

}  // namespace furrow
