#include "planner/path/steerable_legs.h"

#include "planner/geometry/curve_parts.h"
#include "planner/geometry/eased_line.h"
#include "planner/geometry/tolerances.h"
#include "planner/jobs/parallel.h"
#include "planner/turns/steered_line.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <ranges>
#include <span>
#include <utility>

namespace furrow {

namespace {

/// Legs whose headings differ by more at their meeting are turned between on the spot.
constexpr double kOnTheSpotRad = 1e-6;
/// Rounds of smaller windows until the legs stay as they are.
constexpr int kMostRounds = 5;
constexpr double kLiftedTimes = 2.0;
/// The place where a leg begins moves by no more than this.
constexpr double kMostAlongM = 0.5;
/// A line that was outside by more than kContactM before may be as far outside afterwards.
constexpr Length kLegDrawing = metres(8e-3);
/// A trailed implement is in line again after this many of its lengths.
constexpr double kTrailingLengths = 3.0;
/// A run begins at a place that is rounded to these steps, so that it is the same run however the machine got
/// there.
constexpr double kPlaceStepM = 1e-9;
constexpr double kHeadingStepRad = 1e-12;
/// Beyond this number of runs all are forgotten: some ten megabytes.
constexpr std::size_t kMostRunsKept = 4000;
/// Half of a straight at which runs end is as long as this many windows.
constexpr double kStraightWindows = 4.0;

/// Where each leg lies on the line of several.
struct Joined {
    std::vector<Curve> lines;
    std::vector<double> beginM;  ///< of each leg, and the end of the last one
};

Joined joinedLines(std::span<const Leg> legs) {
    Joined joined;
    double m = 0.0;
    for (const Leg& leg : legs) {
        joined.beginM.push_back(m);
        joined.lines.push_back(leg.line);
        for (const CurvePiece& piece : leg.line.pieces) {
            m += piece.length.si();
        }
    }
    joined.beginM.push_back(m);
    return joined;
}

std::vector<LineRange> withoutOverlaps(std::vector<LineRange> ranges) {
    std::ranges::sort(ranges, {}, &LineRange::fromM);
    std::vector<LineRange> apart;
    for (const LineRange& range : ranges) {
        if (!apart.empty() && range.fromM <= apart.back().toM) {
            apart.back().toM = std::max(apart.back().toM, range.toM);
        } else {
            apart.push_back(range);
        }
    }
    return apart;
}

/// A run of legs without a turn on the spot.
class SteerableRun {
public:
    /// @param rigs  of each leg
    SteerableRun(std::span<Leg> legs, std::vector<const Rig*> rigs, const JobContext& job)
        : legs_{legs},
          rigs_{std::move(rigs)},
          job_{job},
          joined_{joinedLines(legs)},
          window_{steeringWindow(machine())},
          easing_{joined_.lines, sharpestSteered(machine())},
          windows_{metres(joined_.beginM.back())} {}

    /// Ends early, with legs as they are, if the job is stopped.
    void ease() {
        for (std::size_t i = 0; i < legs_.size(); ++i) {
            const double beginM = joined_.beginM[i];
            const double endM = joined_.beginM[i + 1];
            // Where it meets others, and at its own jumps.
            windows_.widen({beginM - reachM(), beginM + reachM()}, window_);
            for (const LineRange& jump : jumpsOf(legs_[i].line, machine())) {
                windows_.widen({beginM + jump.fromM - reachM(), beginM + jump.toM + reachM()}, window_);
            }
            windows_.widen({endM - reachM(), endM + reachM()}, window_);
        }
        widenWhereSidesChange();
        std::vector<LineRange> unsure{{0.0, joined_.beginM.back()}};
        for (int round = 0; !unsure.empty(); ++round) {
            if (job_.stopRequested()) {
                return;
            }
            easeNow();
            std::vector<LineRange> tight = outsideIn(unsure);
            std::ranges::copy(line_.failed, std::back_inserter(tight));
            tight = withoutOverlaps(std::move(tight));
            const std::vector<LineRange> bends = withBends(tight);
            // Windows beside a range fall towards it.
            std::vector<LineRange> changing;
            std::ranges::transform(tight, std::back_inserter(changing), [this](const LineRange& range) {
                return LineRange{range.fromM - reachM(), range.toM + reachM()};
            });
            unsure = withBends(withoutOverlaps(std::move(changing)));
            // In the end whole bends stay as they are. Each time at least one more does, so this ends.
            for (const LineRange& range : round < kMostRounds ? tight : bends) {
                if (round < kMostRounds) {
                    windows_.shrink(range, window_);
                } else {
                    windows_.set(range, {});
                }
            }
        }
        writeBack();
    }

private:
    const Machine& machine() const { return rigs_.front()->machine(); }
    /// A jump has its whole window up to this distance. Beyond it the window falls.
    double reachM() const { return 2.0 * window_.si(); }

    void easeNow() {
        averaging_ = windows_.windows();
        line_ = easing_.with(*averaging_);
    }

    /// In turns, changing from one side to the other gets twice the way.
    void widenWhereSidesChange() {
        double m = 0.0;
        double lastSide = 0.0;
        double lastEndM = 0.0;
        for (const CurvePiece& piece :
             joined_.lines | std::views::transform(&Curve::pieces) | std::views::join) {
            const double side =
                piece.curvature.si() * piece.endCurvature.si() > 0.0 ? piece.curvature.si() : 0.0;
            if (side * lastSide < 0.0 && m - lastEndM < window_.si() && !legs_[legAt(m)].implementDown) {
                windows_.widen({lastEndM - window_.si(), m + window_.si()}, kLiftedTimes * window_);
            }
            m += piece.length.si();
            if (side != 0.0) {
                lastSide = side;
                lastEndM = m;
            }
        }
    }

    /// The bends that these ranges touch: only they change with smaller windows.
    /// @param ranges  in order, without overlaps
    std::vector<LineRange> withBends(const std::vector<LineRange>& ranges) const {
        std::vector<LineRange> touched;
        auto range = ranges.begin();
        for (const LineRange& bend : line_.bends) {
            while (range != ranges.end() && range->toM <= bend.fromM) {
                ++range;
            }
            if (range != ranges.end() && range->fromM < bend.toM) {
                touched.push_back(bend);
            }
        }
        return touched;
    }

    std::size_t legAt(double m) const {
        const auto after = std::upper_bound(joined_.beginM.begin() + 1, joined_.beginM.end() - 1, m);
        return static_cast<std::size_t>(after - joined_.beginM.begin()) - 1;
    }

    /// The places in `ranges` where the eased line moves too far, or the machine would leave the area.
    std::vector<LineRange> outsideIn(const std::vector<LineRange>& ranges) const {
        const std::vector<RigState> states =
            rigs_.front()->hasTrailer() ? trailedStates() : std::vector<RigState>{};
        std::vector<std::size_t> bad;
        auto range = ranges.begin();
        for (std::size_t i = 0; i < line_.pieces.size(); ++i) {
            const EasedPiece& piece = line_.pieces[i];
            while (range != ranges.end() && range->toM <= piece.fromM) {
                ++range;
            }
            if (range == ranges.end()) {
                break;
            }
            const bool isUnsure = !piece.isSame && piece.toM > range->fromM;
            if (isUnsure && !fits(piece, states.empty() ? Rig::inLine(piece.start) : states[i])) {
                bad.push_back(i);
            }
        }
        // Before the place the implement is brought into its swing.
        const auto trailer = Trailer::of(machine());
        const double beforeM = trailer ? kTrailingLengths * trailer->trailingM : 0.0;
        std::vector<LineRange> outside;
        for (const std::size_t i : bad) {
            const EasedPiece& piece = line_.pieces[i];
            const double windowM = averaging_->at(0.5 * (piece.fromM + piece.toM));
            outside.push_back({std::max(0.0, piece.fromM - windowM - beforeM),
                               std::min(joined_.beginM.back(), piece.toM + windowM)});
        }
        return outside;
    }

    bool fits(const EasedPiece& piece, const RigState& state) const {
        const std::size_t leg = legAt(0.5 * (piece.fromM + piece.toM));
        const Rig& rig = *rigs_[leg];
        if (legs_[leg].implementDown && asideM(piece) > kMostAside.si()) {
            return false;
        }
        // Work begins and ends where it did.
        if (piece.fromM < joined_.beginM[leg] + kMeetM &&
            distance(piece.start.position, piece.was.position) > kMostAlongM) {
            return false;
        }
        if (rig.driven(state, piece.piece, metres(kContactM))) {
            return true;
        }
        const Curve was = partOf(joined_.lines[leg], metres(piece.fromM - joined_.beginM[leg]),
                                 metres(piece.toM - joined_.beginM[leg]));
        RigState at = rig.hasTrailer() ? RigState{was.start, state.implement} : Rig::inLine(was.start);
        const bool wasInside = std::ranges::all_of(was.pieces, [&](const CurvePiece& part) {
            const auto next = rig.driven(at, part, metres(kContactM));
            at = next.value_or(at);
            return next.has_value();
        });
        return !wasInside && rig.driven(state, piece.piece, kLegDrawing);
    }

    /// The distance between the eased line and the given one.
    static double asideM(const EasedPiece& piece) {
        return std::abs(cross(direction(piece.was.heading.si()), piece.start.position - piece.was.position));
    }

    /// The state at the start of each piece.
    std::vector<RigState> trailedStates() const {
        std::vector<RigState> states;
        RigState state = Rig::inLine(line_.pieces.front().start);
        for (const EasedPiece& piece : line_.pieces) {
            state.tractor = piece.start;
            states.push_back(state);
            state = *rigs_.front()->follow(state, piece.piece, piece.piece.length,
                                           [](const RigState&) { return true; });
        }
        return states;
    }

    void writeBack() {
        std::size_t leg = 0;
        for (Leg& each : legs_) {
            each.line.pieces.clear();
        }
        for (const EasedPiece& piece : line_.pieces) {
            while (leg + 1 < legs_.size() && piece.fromM >= joined_.beginM[leg + 1] - kMeetM) {
                ++leg;
            }
            if (legs_[leg].line.pieces.empty()) {
                legs_[leg].line.start = piece.start;
            }
            legs_[leg].line.pieces.push_back(piece.piece);
        }
    }

    std::span<Leg> legs_;
    std::vector<const Rig*> rigs_;
    const JobContext& job_;
    Joined joined_;
    Length window_;
    LineEasing easing_;
    SteeringWindows windows_;
    std::optional<AveragingWindows> averaging_;
    EasedLine line_;
};

bool turnsOnTheSpot(const Leg& leg) {
    return leg.line.pieces.empty();
}

/// A leg, or what lies between the middles of two of its long straights.
struct Part {
    std::size_t leg = 0;
    Leg driven;
    bool endsInStraight = false;
};

/// The way from the middle of a straight to its ends in which everything is in line again.
double longStraightM(const Machine& machine) {
    const auto trailer = Trailer::of(machine);
    return std::max(kStraightWindows * steeringWindow(machine).si(),
                    trailer ? 2.0 * kTrailingLengths * trailer->trailingM : 0.0);
}

/// Long straights stay where they are, so what lies between two of them is eased by itself.
std::vector<Part> partsOf(const std::vector<Leg>& legs, const Machine& machine) {
    const double longM = longStraightM(machine);
    std::vector<Part> parts;
    for (std::size_t i = 0; i < legs.size(); ++i) {
        Leg part = legs[i];
        part.line.pieces.clear();
        for (CurvePiece piece : legs[i].line.pieces) {
            const bool isStraight = piece.curvature == Curvature{} && piece.endCurvature == Curvature{};
            if (isStraight && piece.length.si() > 2.0 * longM) {
                piece.length = 0.5 * piece.length;
                part.line.pieces.push_back(piece);
                const Pose middle = part.line.end();
                parts.push_back({i, part, true});
                part.line.start = middle;
                part.line.pieces.clear();
            }
            part.line.pieces.push_back(piece);
        }
        parts.push_back({i, std::move(part), false});
    }
    return parts;
}

/// The first and the last part of each run: runs end in long straights and where the machine turns on the
/// spot.
std::vector<std::pair<std::size_t, std::size_t>> runsOf(const std::vector<Part>& parts) {
    std::vector<std::pair<std::size_t, std::size_t>> runs;
    std::size_t from = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Leg& leg = parts[i].driven;
        const bool ends =
            i + 1 == parts.size() || parts[i].endsInStraight || turnsOnTheSpot(leg) ||
            turnsOnTheSpot(parts[i + 1].driven) ||
            std::abs(wrappedAngle(parts[i + 1].driven.line.start.heading - leg.line.end().heading).si()) >
                kOnTheSpotRad;
        if (ends) {
            if (!turnsOnTheSpot(leg)) {
                runs.emplace_back(from, i);
            }
            from = i + 1;
        }
    }
    return runs;
}

double rounded(double value, double step) {
    return step * std::round(value / step);
}

/// Moves all of a run so that it begins at a rounded place.
void roundStart(std::vector<Leg>& run) {
    const Pose from = run.front().line.start;
    const Pose to{.position = {rounded(from.position.x, kPlaceStepM), rounded(from.position.y, kPlaceStepM)},
                  .heading = radians(rounded(from.heading.si(), kHeadingStepRad))};
    Pose next = to;
    for (Leg& leg : run) {
        leg.line.start = next;
        next = leg.line.end();
    }
}

/// @param folded  the one of `rigs` for legs that are driven folded
EasedRuns::Key keyOf(const std::vector<Leg>& run, const std::vector<const Rig*>& rigs, const Rig& folded) {
    EasedRuns::Key key;
    for (std::size_t i = 0; i < run.size(); ++i) {
        const Curve& line = run[i].line;
        key.insert(key.end(),
                   {rigs[i] == &folded ? 1.0 : 0.0, run[i].implementDown ? 1.0 : 0.0, line.start.position.x,
                    line.start.position.y, line.start.heading.si(), static_cast<double>(line.pieces.size())});
        for (const CurvePiece& piece : line.pieces) {
            key.insert(key.end(), {piece.length.si(), piece.curvature.si(), piece.endCurvature.si(),
                                   piece.gear == Gear::Forward ? 1.0 : -1.0});
        }
    }
    return key;
}

/// Appends a line that begins where another ends.
void append(Curve& line, const Curve& next) {
    if (line.pieces.empty()) {
        line.start = next.start;
    }
    for (const CurvePiece& piece : next.pieces) {
        const bool goesOn = !line.pieces.empty() && line.pieces.back().gear == piece.gear &&
                            line.pieces.back().curvature == line.pieces.back().endCurvature &&
                            piece.curvature == piece.endCurvature &&
                            line.pieces.back().curvature == piece.curvature;
        if (goesOn) {
            line.pieces.back().length += piece.length;
        } else {
            line.pieces.push_back(piece);
        }
    }
}

}  // namespace

std::optional<std::vector<Curve>> EasedRuns::find(const Key& key) const {
    const std::scoped_lock lock{mutex_};
    const auto known = known_.find(key);
    return known != known_.end() ? std::optional{known->second} : std::nullopt;
}

void EasedRuns::add(Key key, std::vector<Curve> lines) {
    const std::scoped_lock lock{mutex_};
    if (known_.size() >= kMostRunsKept) {
        known_.clear();
    }
    known_.emplace(std::move(key), std::move(lines));
}

SteeringRoom::SteeringRoom(const AllowedAreas& areas, const Machine& machine)
    : lowered{areas, machine, ImplementAt::Lowered},
      raised{areas, machine},
      folded{areas, machine.folded()} {}

Result<std::vector<Leg>> steerableLegs(std::vector<Leg> legs, const SteeringRoom& room,
                                       const JobContext& job) {
    const auto works = [](const Leg& leg) { return leg.implementDown; };
    const auto first = std::ranges::find_if(legs, works) - legs.begin();
    const auto last = std::ranges::find_last_if(legs, works).begin() - legs.begin();
    const auto rigOf = [&](std::size_t leg) {
        const auto place = static_cast<std::ptrdiff_t>(leg);
        return works(legs[leg])                                    ? &room.lowered
               : legs[leg].folded || place < first || place > last ? &room.folded
                                                                   : &room.raised;
    };
    std::vector<Part> parts = partsOf(legs, room.raised.machine());
    const auto runs = runsOf(parts);
    const auto eased = parallelFor(
        runs.size(),
        [&](std::size_t i) {
            const auto [from, to] = runs[i];
            std::vector<Leg> run;
            std::vector<const Rig*> rigs;
            for (std::size_t k = from; k <= to; ++k) {
                run.push_back(parts[k].driven);
                rigs.push_back(rigOf(parts[k].leg));
            }
            roundStart(run);
            EasedRuns::Key key = keyOf(run, rigs, room.folded);
            auto lines = room.known->find(key);
            if (!lines) {
                SteerableRun{run, std::move(rigs), job}.ease();
                lines.emplace();
                std::ranges::transform(run, std::back_inserter(*lines), &Leg::line);
                if (!job.stopRequested()) {
                    room.known->add(std::move(key), *lines);
                }
            }
            for (std::size_t k = from; k <= to; ++k) {
                parts[k].driven.line = std::move((*lines)[k - from]);
            }
        },
        job);
    if (!eased) {
        return std::unexpected(eased.error());
    }
    for (Leg& leg : legs) {
        leg.line.pieces.clear();
    }
    for (const Part& part : parts) {
        append(legs[part.leg].line, part.driven.line);
    }
    return legs;
}

}  // namespace furrow
