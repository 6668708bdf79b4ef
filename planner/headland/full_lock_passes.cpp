#include "planner/headland/full_lock_passes.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/nearest_on_edges.h"
#include "planner/geometry/polygon_memo.h"
#include "planner/headland/swept_land.h"
#include "planner/jobs/parallel.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <mutex>
#include <numbers>
#include <ranges>
#include <span>
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
constexpr double kMostCircles = 1.25;
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
// Each takes some hundred kilobytes.
constexpr std::size_t kMostPieces = 100;
constexpr std::size_t kMostAhead = 50;
// Bends whose room is looked at together, by several threads.
constexpr std::ptrdiff_t kAtOnce = 8;

}  // namespace

FullLockPasses::FullLockPasses(const Rig& lowered, PassAccessFinder access,
                               std::shared_ptr<FullLockTrials> trials)
    : lowered_{&lowered},
      access_{std::move(access)},
      trailer_{Trailer::of(lowered.machine())},
      look_{trailer_ ? std::min(kLook, trailer_->longestStep()) : kLook},
      bends_{FullLockBend{lowered, 1.0, kMostCircles, look_},
             FullLockBend{lowered, -1.0, kMostCircles, look_}},
      radiusM_{lowered.machine().minTurningRadius().si()},
      trials_{trials != nullptr ? std::move(trials) : std::make_shared<FullLockTrials>()} {}

Result<FullLockPasses> FullLockPasses::of(const AllowedAreas& areas, const Rig& lowered,
                                          PassAccessFinder access, const JobContext& job,
                                          std::shared_ptr<FullLockTrials> trials) {
    FullLockPasses passes{lowered, std::move(access), std::move(trials)};
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

/// Asks whether ways lead to candidates. Poses close to a failed one are skipped, and few are asked for.
class AskedAccess {
public:
    AskedAccess(const PassAccessFinder& access, FailedPoses& failed, double closeM)
        : access_{access}, failed_{failed}, closeM_{closeM} {}

    bool isOver() const { return asked_ == kMostAsked; }

    bool leadsTo(const Curve& line) {
        if (isAmong(failed_.notReached, line.start) || isAmong(failed_.notLeft, line.end())) {
            return false;
        }
        const PassAccess found = access_(line);
        if (found == PassAccess::There) {
            return true;
        }
        ++asked_;
        if (found == PassAccess::NoWayIn) {
            failed_.notReached.push_back(line.start);
        } else {
            failed_.notLeft.push_back(line.end());
        }
        return false;
    }

private:
    bool isAmong(const std::vector<Pose>& poses, const Pose& pose) const {
        return std::ranges::any_of(poses, [&](const Pose& other) { return isClose(pose, other, closeM_); });
    }

    const PassAccessFinder& access_;
    FailedPoses& failed_;
    double closeM_;
    std::size_t asked_ = 0;
};

}  // namespace

/// A bend whose room is not yet looked at.
struct FullLockPasses::Bend {
    std::size_t side = 0;  ///< of those that are driven once
    Point around;
    Angle begin;
    std::size_t worked = 0;  ///< places of the piece that it passes over
    std::size_t index = 0;   ///< among the bends of its piece
    double mostM2 = 0.0;     ///< that it gains
};

/// What follows from a piece, the area and the machine, and not from the ways to a pass.
struct FullLockPasses::Piece {
    std::vector<Point> places;
    Point mean;
    std::vector<Bend> bends;

    /// The part of a bend that has room, of those that gain more than this.
    struct Fitted {
        double leastM2 = 0.0;
        std::optional<Candidate> candidate;
    };
    std::mutex mutex;
    // Under the mutex.
    std::map<std::pair<std::size_t, double>, Fitted> fitted;  ///< by bend and lead
    std::vector<BentPass> chosen;
};

struct FullLockTrials::Known {
    PolygonMemo<std::shared_ptr<FullLockPasses::Piece>> pieces{kMostPieces};
};

FullLockTrials::FullLockTrials() : known_{std::make_unique<Known>()} {}

FullLockTrials::~FullLockTrials() = default;

/// Drives bends over one piece.
class FullLockPasses::Trial {
public:
    Trial(const FullLockPasses& passes, const Polygon& outline, Piece& piece)
        : passes_{passes},
          lowered_{*passes.lowered_},
          piece_{piece},
          places_{piece.places},
          areaEachM2_{area(outline).si() / static_cast<double>(std::max<std::size_t>(1, places_.size()))},
          widthM_{lowered_.machine().operatingWidth().si()},
          swings_{1.0 +
                  (passes.trailer_ ? widthM_ / passes.trailer_->trailingM : widthM_ / passes.radiusM_)} {}

    bool works(std::size_t worked, double share) const {
        return static_cast<double>(worked) >= share * static_cast<double>(places_.size());
    }

    /// Middles of circles that reach the piece.
    std::vector<Point> middles() const {
        std::vector<Point> found;
        const auto add = [&](Point near) {
            const auto middle = nearestOnEdges(passes_.middles_, near);
            if (middle && std::ranges::none_of(
                              found, [&](Point other) { return distance(*middle, other) < kSameMiddleM; })) {
                found.push_back(*middle);
            }
        };
        if (!places_.empty()) {
            add(piece_.mean);
            for (std::size_t i = 0; i < kGuides; ++i) {
                add(places_[i * (places_.size() - 1) / (kGuides - 1)]);
            }
        }
        return found;
    }

    /// Bends round middles and round places farther inwards that pass over the piece. Cancelled.
    Result<std::vector<Bend>> bendsAround(std::span<const Point> middles, const JobContext& job) const {
        return parallelMap<std::vector<Bend>>(
                   middles.size(), [&](std::size_t i) { return bendsNear(middles[i]); }, job)
            .transform([](const std::vector<std::vector<Bend>>& each) {
                std::vector<Bend> bends;
                for (Bend bend : each | std::views::join) {
                    bend.index = bends.size();
                    bends.push_back(bend);
                }
                return bends;
            });
    }

    /// The bend with the largest gain that has room, and a way in and out, after a straight of `leadM`. A
    /// bend gains no more than the places that it passes over are worth, so the room of others is not looked
    /// at.
    std::optional<Candidate> best(double leadM, AskedAccess access, const JobContext& job) const {
        std::vector<Bend> bends = piece_.bends;
        for (Bend& bend : bends) {
            bend.mostM2 = gainM2(bend.worked, leadM + kLengthsOut * passes_.straightM_);
        }
        std::erase_if(bends, [](const Bend& bend) { return bend.mostM2 <= 0.0; });
        std::ranges::stable_sort(bends, std::ranges::greater{}, &Bend::mostM2);
        const auto less = [](const Candidate& a, const Candidate& b) { return a.gainM2 < b.gainM2; };
        std::vector<Candidate> fitting;  // a heap
        double leastM2 = 0.0;
        auto next = bends.begin();
        auto seen = bends.begin();
        while (!access.isOver() && !job.stopRequested()) {
            const bool isMore = next != bends.end() && next->mostM2 > leastM2;
            if (!fitting.empty() && (!isMore || fitting.front().gainM2 >= next->mostM2)) {
                if (fitting.front().gainM2 < leastM2) {
                    break;
                }
                std::ranges::pop_heap(fitting, less);
                Candidate candidate = std::move(fitting.back());
                fitting.pop_back();
                if (access.leadsTo(candidate.line)) {
                    return candidate;
                }
                continue;
            }
            if (!isMore) {
                break;
            }
            if (next == seen && job.threads != 1) {
                seen += std::min(kAtOnce, bends.end() - next);
                if (!lookAhead({next, seen}, leadM, leastM2, job)) {
                    break;
                }
            }
            if (auto candidate = knownFitted(*next, leadM, leastM2)) {
                leastM2 = std::max(leastM2, kWorthAsking * candidate->gainM2);
                fitting.push_back(*std::move(candidate));
                std::ranges::push_heap(fitting, less);
            }
            ++next;
        }
        return std::nullopt;
    }

private:
    std::vector<Bend> bendsNear(Point middle) const {
        std::vector<Bend> bends;
        const double awayM = distance(middle, piece_.mean);
        const Point inwards = awayM > 0.0 ? (1.0 / awayM) * (middle - piece_.mean) : Point{};
        for (const double inwardsM : kInwardsM) {
            const Point around = middle + inwardsM * inwards;
            for (int turn = 0; turn < kBegins; ++turn) {
                const Angle begin = radians(2.0 * std::numbers::pi * turn / kBegins);
                const Angle ahead = wrappedAngle(radians(std::atan2(-inwards.y, -inwards.x)) - begin);
                if (std::abs(ahead.si()) <= kLeastBeforeRad) {
                    continue;
                }
                for (const std::size_t side : {0, 1}) {
                    Bend bend{.side = side, .around = around, .begin = begin};
                    bend.worked = placesUnder(bend);
                    if (bend.worked > 0) {
                        bends.push_back(bend);
                    }
                }
            }
        }
        return bends;
    }

    /// Works out `knownFitted` of the next bends at once. With one thread they are worked out when asked for,
    /// as some of these are not.
    Result<void> lookAhead(std::span<const Bend> next, double leadM, double leastM2,
                           const JobContext& job) const {
        return parallelFor(
            next.size(),
            [&](std::size_t i) {
                if (next[i].mostM2 > leastM2) {
                    knownFitted(next[i], leadM, leastM2);
                }
            },
            job.withoutProgress());
    }

    double gainM2(std::size_t worked, double wayM) const {
        return areaEachM2_ * static_cast<double>(worked) - kWorthShare * widthM_ * wayM;
    }

    template <class Visit>
    void forEachPlaceUnder(const Bend& bend, const Visit& visit) const {
        const Point ahead = direction(bend.begin.si());
        for (const Point& place : places_) {
            const Point away = place - bend.around;
            if (const auto state =
                    passes_.bends_[bend.side].firstOver({dot(ahead, away), cross(ahead, away)})) {
                visit(*state);
            }
        }
    }

    std::size_t placesUnder(const Bend& bend) const {
        std::size_t count = 0;
        forEachPlaceUnder(bend, [&](std::size_t) { ++count; });
        return count;
    }

    /// The states at which the implement first passes over places of the piece, rising.
    std::vector<std::size_t> statesOverPlaces(const Bend& bend) const {
        std::vector<std::size_t> states;
        forEachPlaceUnder(bend, [&](std::size_t state) { states.push_back(state); });
        std::ranges::sort(states);
        return states;
    }

    /// The same as `fitted`, whether it was worked out before or not. Only whether a part gains enough
    /// follows from `leastM2`, never which part it is.
    std::optional<Candidate> knownFitted(const Bend& trial, double leadM, double leastM2) const {
        const std::pair key{trial.index, leadM};
        {
            const std::scoped_lock lock{piece_.mutex};
            const auto known = piece_.fitted.find(key);
            if (known != piece_.fitted.end() && known->second.candidate) {
                return known->second.candidate->gainM2 > leastM2 ? known->second.candidate : std::nullopt;
            }
            if (known != piece_.fitted.end() && leastM2 >= known->second.leastM2) {
                return std::nullopt;
            }
        }
        std::optional<Candidate> found = fitted(trial, leadM, leastM2);
        const std::scoped_lock lock{piece_.mutex};
        piece_.fitted.insert_or_assign(key, Piece::Fitted{leastM2, found});
        return found;
    }

    /// The part of a bend that has room. Empty without one that gains more than `leastM2`.
    std::optional<Candidate> fitted(const Bend& trial, double leadM, double leastM2) const {
        const FullLockBend& bend = passes_.bends_[trial.side];
        const Point middle = trial.around;
        const Angle begin = trial.begin;
        const CurvePiece lead{.length = metres(leadM), .curvature = {}};
        const CurvePiece out{.length = metres(kLengthsOut * passes_.straightM_), .curvature = {}};
        const auto isWorthIt = [&](std::size_t worked, Length way) {
            return gainM2(worked, (lead.length + way + out.length).si()) > leastM2;
        };
        const Pose on = bend.stateAt(0, middle, begin).tractor;
        const Pose start{.position = on.position - leadM * direction(on.heading.si()), .heading = on.heading};
        if (lowered_.roomM(Rig::inLine(on)) < kSpareM || lowered_.roomM(Rig::inLine(start)) < kSpareM ||
            !lowered_.driven(Rig::inLine(start), lead)) {
            return std::nullopt;
        }
        InsideSoFar inside{*this, bend, middle, begin};
        std::vector<std::size_t> states = statesOverPlaces(trial);
        while (!states.empty() && !inside.upTo(states.back())) {
            states.pop_back();
        }
        if (states.empty()) {
            return std::nullopt;
        }
        // Leave the bend as soon as there is room.
        for (std::size_t end = states.back(); isWorthIt(states.size(), bend.wayTo(end)) && inside.upTo(end);
             end += kExitSteps) {
            if (out.length == Length{} || lowered_.driven(bend.stateAt(end, middle, begin), out)) {
                const Length way = bend.wayTo(end);
                Curve line{.type = {}, .start = start, .pieces = {}};
                const CurvePiece round{.length = way, .curvature = bend.curvature()};
                std::ranges::copy_if(std::array{lead, round, out}, std::back_inserter(line.pieces),
                                     [](const CurvePiece& part) { return part.length > Length{}; });
                return Candidate{.line = std::move(line),
                                 .gainM2 = gainM2(states.size(), (lead.length + way + out.length).si()),
                                 .worked = states.size()};
            }
        }
        return std::nullopt;
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
    Piece& piece_;
    const std::vector<Point>& places_;
    double areaEachM2_;
    double widthM_;
    double swings_;  ///< largest move of any point for one metre of way
};

/// What is known of a piece: its places and the bends over it, at least.
Result<std::shared_ptr<FullLockPasses::Piece>> FullLockPasses::tried(const Polygon& piece,
                                                                     const JobContext& job) const {
    if (auto known = trials_->known_->pieces.find(piece)) {
        return *std::move(known);
    }
    auto made = std::make_shared<Piece>();
    made->places = placesInside(piece, std::sqrt(area(piece).si() / kPlaces));
    for (const Point& place : made->places) {
        made->mean = made->mean + (1.0 / static_cast<double>(made->places.size())) * place;
    }
    const Trial trial{*this, piece, *made};
    auto bends = trial.bendsAround(trial.middles(), job.withoutProgress());
    if (!bends) {
        return std::unexpected(bends.error());
    }
    made->bends = *std::move(bends);
    trials_->known_->pieces.add(piece, made);
    return made;
}

double FullLockPasses::closeM() const {
    return kCloseShare * lowered_->machine().operatingWidth().si();
}

double FullLockPasses::leadM(double lengths) const {
    return std::max(lengths * straightM_, lowered_->machine().runIn().si());
}

Result<void> FullLockPasses::lookAhead(std::span<const Polygon> pieces,
                                       const std::function<bool(const Curve&)>& isRefused,
                                       const JobContext& job) const {
    return parallelFor(
        std::min(pieces.size(), kMostAhead),
        [&](std::size_t i) {
            const auto known = tried(pieces[i], job);
            if (!known) {
                return;
            }
            // That ways lead to it is found later, most often.
            const PassAccessFinder access = [&](const Curve& line) {
                return isRefused(line) ? PassAccess::NoWayIn : PassAccess::There;
            };
            FailedPoses failed;
            const AskedAccess asked{access, failed, closeM()};
            Trial{*this, pieces[i], **known}.best(leadM(kLengthsIn.front()), asked, job);
        },
        job);
}

std::optional<BentPass> FullLockPasses::over(const Polygon& piece,
                                             const std::function<bool(const Curve&)>& isRefused,
                                             const JobContext& job) {
    if (std::ranges::contains(hopeless_, piece)) {
        return std::nullopt;
    }
    const PassAccessFinder access = [&](const Curve& line) {
        return isRefused(line) ? PassAccess::NoWayIn : access_(line);
    };
    const auto found = tried(piece, job);
    if (!found) {
        return std::nullopt;
    }
    const std::shared_ptr<Piece>& known = *found;
    const Trial trial{*this, piece, *known};
    const AskedAccess asked{access, failed_, closeM()};
    std::optional<Candidate> best;
    for (const double lengths : kLengthsIn) {
        auto pass = trial.best(leadM(lengths), asked, job);
        if (pass && (!best || pass->gainM2 > best->gainM2)) {
            best = std::move(pass);
        }
        if ((best && trial.works(best->worked, kGoodEnough)) || straightM_ == 0.0) {
            break;
        }
    }
    if (!best) {
        hopeless_.push_back(piece);
        return std::nullopt;
    }
    {
        const std::scoped_lock lock{known->mutex};
        const auto chosen = std::ranges::find(known->chosen, best->line, &BentPass::line);
        if (chosen != known->chosen.end()) {
            return *chosen;
        }
    }
    std::optional<BentPass> pass = worked(std::move(best->line), job);
    if (pass) {
        const std::scoped_lock lock{known->mutex};
        known->chosen.push_back(*pass);
    }
    return pass;
}

std::optional<BentPass> FullLockPasses::worked(Curve line, const JobContext& job) const {
    RigState at = Rig::inLine(line.start);
    SweptLand swept{workingLine(at, lowered_->machine(), trailer_)};
    for (const CurvePiece& part : line.pieces) {
        at = *lowered_->follow(at, part, metres(kSweptM), [&](const RigState& state) {
            swept.to(workingLine(state, lowered_->machine(), trailer_));
            return true;
        });
    }
    auto worked = unionOf(swept.polygons(), job);
    return worked ? std::optional{BentPass{.line = std::move(line), .worked = std::move(*worked)}}
                  : std::nullopt;
}

}  // namespace furrow
