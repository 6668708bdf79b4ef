#include "planner/headland/full_lock_passes.h"

#include "planner/geometry/boundary_distance.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/segment.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace furrow {

namespace {

// Approximate number of sampled places in a piece.
constexpr int kPlaces = 120;
// Number of places from which middles are searched.
constexpr int kGuides = 6;
constexpr double kSameMiddleM = 1.0;
// The outer end of the implement is farther out until its bend is as sharp as the circle. So bends are also
// tried round places this far inwards from the middle of a circle that just fits.
constexpr std::array kInwardsM{0.05, 0.2, 0.5, 1.0, 1.8, 3.0};
constexpr int kBegins = 32;
constexpr double kMostRounds = 1.25;
// A bend does not begin right beside the piece, because it needs some way to become as sharp as possible.
constexpr double kLeastBeforeRad = 0.3;
// A bent hitch is in line again after this many lengths of the trailed part, driven straight. The shorter
// distance before the bend is for places without more room, or without a way to its start.
constexpr std::array kLengthsIn{3.0, 1.0};
constexpr double kLengthsOut = 2.5;
// A pass that works this share of the piece with the longer lead is taken; the shorter lead is not tried
// then.
constexpr double kGoodEnough = 0.6;
constexpr Length kLook = metres(0.25);
// Room kept because an arriving implement is not quite in line.
constexpr double kSpareM = 0.02;
// Area that one metre of way has to work, as a share of the width.
constexpr double kWorthShare = 0.01;
// Candidates worth less than this share of the best are not kept as replacements.
constexpr double kWorthAsking = 0.4;
// At most 12 passes may turn out to have no way in or out. Poses closer than this share of the width, with
// headings closer than a quarter of a right angle (the cosine), are one.
constexpr std::size_t kMostAsked = 12;
constexpr double kCloseShare = 0.1;
constexpr double kSameWay = 0.92;
// Exits from a bend are tried at every fourth state.
constexpr std::size_t kExitSteps = 4;
// Swept land is built from pieces of this length.
constexpr double kSweptM = 0.75;

std::vector<Point> placesIn(const Polygon& piece) {
    const Bounds box = bounds({piece});
    const double stepM = std::sqrt(area(piece).si() / kPlaces);
    const BoundaryDistance edges{{piece}, metres(box.width() + box.height() + 1.0)};
    std::vector<Point> places;
    for (double y = box.min.y + 0.5 * stepM; y < box.max.y; y += stepM) {
        for (double x = box.min.x + 0.5 * stepM; x < box.max.x; x += stepM) {
            if (edges.insideM({x, y}).value_or(-1.0) > 0.0) {
                places.push_back({x, y});
            }
        }
    }
    return places;
}

void addSwept(const WorkingLine& from, const WorkingLine& to, MultiPolygon& swept) {
    for (Ring ring : {Ring{from.first, to.first, to.second}, Ring{from.first, to.second, from.second}}) {
        const double twice = signedAreaM2(ring);
        if (twice < 0.0) {
            std::swap(ring[1], ring[2]);
        }
        if (twice != 0.0) {
            swept.push_back({.outer = std::move(ring), .holes = {}});
        }
    }
}

}  // namespace

FullLockPasses::FullLockPasses(const Rig& lowered, PassAccessFinder access)
    : lowered_{&lowered},
      access_{std::move(access)},
      trailer_{Trailer::of(lowered.machine())},
      look_{trailer_ ? std::min(kLook, trailer_->longestStep()) : kLook},
      bends_{FullLockBend{lowered, 1.0, kMostRounds, look_}, FullLockBend{lowered, -1.0, kMostRounds, look_}},
      radiusM_{lowered.machine().minTurningRadius().si()} {}

Result<FullLockPasses> FullLockPasses::of(const AllowedAreas& areas, const Rig& lowered,
                                          PassAccessFinder access, const JobContext& job) {
    FullLockPasses passes{lowered, std::move(access)};
    double implementM = passes.radiusM_;
    if (const auto& trailer = passes.trailer_) {
        passes.straightM_ = trailer->trailingM;
        const double hitchM = std::hypot(passes.radiusM_, trailer->hitchM);
        implementM = std::sqrt(std::max(0.0, hitchM * hitchM - trailer->trailingM * trailer->trailingM));
    }
    passes.outerM_ = implementM + 0.5 * lowered.machine().workingFootprintWidth().si();
    return eroded(areas.implement(), metres(passes.outerM_), kArcTolerance, job)
        .transform([&](MultiPolygon middles) {
            passes.middles_ = std::move(middles);
            return std::move(passes);
        });
}

std::optional<Point> FullLockPasses::nearestMiddle(Point place) const {
    std::optional<Point> nearest;
    double nearestM = std::numeric_limits<double>::infinity();
    forEachEdge(middles_, [&](Point from, Point to) {
        const Point point = nearestOnSegment(place, from, to);
        if (const double awayM = distance(place, point); awayM < nearestM) {
            nearestM = awayM;
            nearest = point;
        }
    });
    return nearest;
}

namespace {

/// A line with its gain.
struct Candidate {
    Curve line;
    double gainM2 = 0.0;
    std::size_t worked = 0;  ///< places of the piece
};

bool isClose(const Pose& a, const Pose& b, double closeM) {
    return distance(a.position, b.position) < closeM &&
           dot(direction(a.heading.si()), direction(b.heading.si())) > kSameWay;
}

/// The best candidate with a way in and a way out. Few are asked for. Poses close to a failed one are
/// skipped.
std::optional<Candidate> bestWithAccess(std::vector<Candidate> candidates, const PassAccessFinder& access,
                                        double closeM) {
    std::ranges::stable_sort(candidates, std::ranges::greater{}, &Candidate::gainM2);
    std::vector<Pose> notReached;
    std::vector<Pose> notLeft;
    std::size_t asked = 0;
    const auto isAmong = [&](const std::vector<Pose>& poses, const Pose& pose) {
        return std::ranges::any_of(poses, [&](const Pose& other) { return isClose(pose, other, closeM); });
    };
    for (Candidate& candidate : candidates) {
        if (isAmong(notReached, candidate.line.start) || isAmong(notLeft, candidate.line.end())) {
            continue;
        }
        const PassAccess found = access(candidate.line);
        if (found == PassAccess::There) {
            return std::move(candidate);
        }
        if (++asked == kMostAsked) {
            break;
        }
        if (found == PassAccess::NoWayIn) {
            notReached.push_back(candidate.line.start);
        } else {
            notLeft.push_back(candidate.line.end());
        }
    }
    return std::nullopt;
}

}  // namespace

/// Drives bends over one piece.
class FullLockPasses::Trial {
public:
    Trial(const FullLockPasses& passes, const Polygon& piece)
        : passes_{passes},
          lowered_{*passes.lowered_},
          places_{placesIn(piece)},
          areaEachM2_{area(piece).si() / static_cast<double>(std::max<std::size_t>(1, places_.size()))},
          widthM_{lowered_.machine().operatingWidth().si()},
          swings_{1.0 +
                  (passes.trailer_ ? widthM_ / passes.trailer_->trailingM : widthM_ / passes.radiusM_)} {
        for (const Point& place : places_) {
            mean_ = mean_ + (1.0 / static_cast<double>(places_.size())) * place;
        }
    }

    bool works(std::size_t worked, double share) const {
        return static_cast<double>(worked) >= share * static_cast<double>(places_.size());
    }

    /// Middles of circles that reach the piece.
    std::vector<Point> middles() const {
        std::vector<Point> found;
        const auto add = [&](Point near) {
            const auto middle = passes_.nearestMiddle(near);
            if (middle && std::ranges::none_of(
                              found, [&](Point other) { return distance(*middle, other) < kSameMiddleM; })) {
                found.push_back(*middle);
            }
        };
        if (!places_.empty()) {
            add(mean_);
            for (std::size_t i = 0; i < kGuides; ++i) {
                add(places_[i * (places_.size() - 1) / (kGuides - 1)]);
            }
        }
        return found;
    }

    /// Adds the bends round a middle and round places farther inwards, with a straight of `leadM` before
    /// them.
    void addAround(Point middle, double leadM, std::vector<Candidate>& candidates, const JobContext& job) {
        const double awayM = distance(middle, mean_);
        const Point inwards = awayM > 0.0 ? (1.0 / awayM) * (middle - mean_) : Point{};
        for (const double inwardsM : kInwardsM) {
            const Point around = middle + inwardsM * inwards;
            const auto within = std::ranges::count_if(
                places_, [&](Point place) { return distance(place, around) < passes_.outerM_ + leadM; });
            const double mostM2 =
                gainM2(static_cast<std::size_t>(within), leadM + kLengthsOut * passes_.straightM_);
            for (int i = 0; i < 2 * kBegins && mostM2 > kWorthAsking * bestM2_ && !job.stopRequested(); ++i) {
                const Angle begin =
                    radians(2.0 * std::numbers::pi * (i / 2) / kBegins);  // both sides at each
                const Angle ahead = wrappedAngle(radians(std::atan2(-inwards.y, -inwards.x)) - begin);
                if (std::abs(ahead.si()) > kLeastBeforeRad) {
                    add(passes_.bends_[static_cast<std::size_t>(i % 2)], around, begin, leadM, candidates);
                }
            }
        }
    }

private:
    double gainM2(std::size_t worked, double wayM) const {
        return areaEachM2_ * static_cast<double>(worked) - kWorthShare * widthM_ * wayM;
    }

    /// The states at which the implement first passes over places of the piece, rising.
    std::vector<std::size_t> statesOverPlaces(const FullLockBend& bend, Point middle, Angle begin) const {
        const Point ahead = direction(begin.si());
        std::vector<std::size_t> states;
        for (const Point& place : places_) {
            const Point away = place - middle;
            if (const auto state = bend.firstOver({dot(ahead, away), cross(ahead, away)})) {
                states.push_back(*state);
            }
        }
        std::ranges::sort(states);
        return states;
    }

    void add(const FullLockBend& bend, Point middle, Angle begin, double leadM,
             std::vector<Candidate>& candidates) {
        const CurvePiece lead{.length = metres(leadM), .curvature = {}};
        const CurvePiece out{.length = metres(kLengthsOut * passes_.straightM_), .curvature = {}};
        const auto isWorthIt = [&](std::size_t worked, Length way) {
            return gainM2(worked, (lead.length + way + out.length).si()) > kWorthAsking * bestM2_;
        };
        std::vector<std::size_t> states = statesOverPlaces(bend, middle, begin);
        if (states.empty() || !isWorthIt(states.size(), {})) {
            return;
        }
        const Pose on = bend.stateAt(0, middle, begin).tractor;
        const Pose start{.position = on.position - leadM * direction(on.heading.si()), .heading = on.heading};
        if (lowered_.roomM(Rig::inLine(on)) < kSpareM || lowered_.roomM(Rig::inLine(start)) < kSpareM) {
            return;
        }
        if (!lowered_.driven(Rig::inLine(start), lead)) {
            return;
        }
        InsideSoFar inside{*this, bend, middle, begin};
        while (!states.empty() && !inside.upTo(states.back())) {
            states.pop_back();
        }
        if (states.empty()) {
            return;
        }
        // Leave the bend as soon as there is room.
        for (std::size_t end = states.back(); isWorthIt(states.size(), bend.wayTo(end)) && inside.upTo(end);
             end += kExitSteps) {
            if (out.length == Length{} || lowered_.driven(bend.stateAt(end, middle, begin), out)) {
                const Length way = bend.wayTo(end);
                const double gain = gainM2(states.size(), (lead.length + way + out.length).si());
                bestM2_ = std::max(bestM2_, gain);
                Curve line{.type = {}, .start = start, .pieces = {}};
                const CurvePiece round{.length = way, .curvature = bend.curvature()};
                std::ranges::copy_if(std::array{lead, round, out}, std::back_inserter(line.pieces),
                                     [](const CurvePiece& part) { return part.length > Length{}; });
                candidates.push_back({.line = std::move(line), .gainM2 = gain, .worked = states.size()});
                return;
            }
        }
    }

    /// How far a bend stays inside, looked at as far as somebody asks.
    class InsideSoFar {
    public:
        InsideSoFar(const Trial& trial, const FullLockBend& bend, Point middle, Angle begin)
            : trial_{trial}, bend_{bend}, middle_{middle}, begin_{begin} {}

        bool upTo(std::size_t state) {
            if (state >= bend_.stateCount()) {
                return false;
            }
            while (!isOutside_ && next_ <= state) {
                const double roomM = trial_.lowered_.roomM(bend_.stateAt(next_, middle_, begin_));
                isOutside_ = roomM < kSpareM;
                if (!isOutside_) {
                    // No state on this way is without room.
                    const Length free = metres((roomM - kSpareM) / trial_.swings_);
                    next_ += 1 + static_cast<std::size_t>(free / bend_.wayTo(1));
                }
            }
            return state < next_;
        }

    private:
        const Trial& trial_;
        const FullLockBend& bend_;
        Point middle_;
        Angle begin_;
        std::size_t next_ = 1;  ///< to be looked at
        bool isOutside_ = false;
    };

    const FullLockPasses& passes_;
    const Rig& lowered_;
    std::vector<Point> places_;
    Point mean_;
    double areaEachM2_;
    double widthM_;
    double swings_;  ///< largest move of any point for one metre of way
    double bestM2_ = 0.0;
};

std::optional<BentPass> FullLockPasses::over(const Polygon& piece,
                                             const std::function<bool(const Curve&)>& isRefused,
                                             const JobContext& job) {
    if (std::ranges::contains(hopeless_, piece)) {
        return std::nullopt;
    }
    const auto access = [&](const Curve& line) {
        return isRefused(line) ? PassAccess::NoWayIn : access_(line);
    };
    const Machine& machine = lowered_->machine();
    Trial trial{*this, piece};
    const std::vector<Point> middles = trial.middles();
    std::optional<Candidate> best;
    for (const double lengths : kLengthsIn) {
        const double leadM = std::max(lengths * straightM_, machine.runIn().si());
        std::vector<Candidate> candidates;
        for (const Point& middle : middles) {
            trial.addAround(middle, leadM, candidates, job);
        }
        auto found =
            bestWithAccess(std::move(candidates), access, kCloseShare * machine.operatingWidth().si());
        if (found && (!best || found->gainM2 > best->gainM2)) {
            best = std::move(found);
        }
        if ((best && trial.works(best->worked, kGoodEnough)) || straightM_ == 0.0) {
            break;
        }
    }
    if (!best) {
        hopeless_.push_back(piece);
        return std::nullopt;
    }
    return worked(std::move(best->line), job);
}

std::optional<BentPass> FullLockPasses::worked(Curve line, const JobContext& job) const {
    MultiPolygon swept;
    RigState at = Rig::inLine(line.start);
    WorkingLine last = workingLine(at, lowered_->machine(), trailer_);
    for (const CurvePiece& part : line.pieces) {
        at = *lowered_->follow(at, part, metres(kSweptM), [&](const RigState& state) {
            const WorkingLine now = workingLine(state, lowered_->machine(), trailer_);
            addSwept(last, now, swept);
            last = now;
            return true;
        });
    }
    auto worked = unionOf(swept, job);
    return worked ? std::optional{BentPass{.line = std::move(line), .worked = std::move(*worked)}}
                  : std::nullopt;
}

}  // namespace furrow
