#include "planner/geometry/eased_line.h"

#include "planner/geometry/tolerances.h"
#include "planner/units/angle.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace furrow {

namespace {

constexpr double kNoCurvature = 1e-12;
/// A straight that keeps its place has at least this length after easing, half of it on either side.
constexpr double kKeptStraightM = 0.5;
/// Where the window changes, the mean is not linear along the way: longest piece, as a share of the window.
constexpr double kWindowShare = 0.2;
constexpr int kMostParts = 12;
/// Least distance of two places, as a share of the window there.
constexpr double kPlaceShare = 0.18;
/// Straights change their length more readily than bends.
constexpr double kStraightWeight = 10.0;
/// Nodes of the curvature change less readily than lengths, by this factor.
constexpr double kCurvatureWeight = 0.3;
/// Bends without a straight in them are tied to the given line at this distance.
constexpr double kLongestBendM = 20.0;
constexpr double kFreeShare = 0.9;
constexpr double kFreeM = 10.0;
constexpr int kMostRounds = 20;
/// Steps in which further curvatures reach their bound.
constexpr int kMostBounded = 40;
/// Number of steps with the same derivatives.
constexpr int kSameDerivatives = 4;
/// For derivatives, m or 1/m.
constexpr double kProbe = 1e-7;
constexpr double kEndM = 1e-8;
constexpr double kEndRad = 1e-11;
/// After the last round.
constexpr double kNearEndM = 1e-6;
constexpr double kNearEndRad = 1e-8;
/// Straights whose ends move by less are the same.
constexpr double kSameM = 1e-4;
/// No piece becomes shorter than this share of its length, or longer than this many times.
constexpr double kLeastLeft = 0.2;
constexpr double kMostGrown = 4.0;

/// Divides a line into pieces and bends.
class Easing {
public:
    using Bends = std::vector<LineEasing::Bend>;

    Easing(const GivenLine& line, const AveragingWindows& windows, double sharpest, const Bends& known)
        : line_{line}, windows_{windows}, sharpest_{sharpest}, known_{known} {
        collectPlaces();
    }

    Bends takeBends() { return std::move(bends_); }

    EasedLine run() {
        EasedLine result;
        for (std::size_t i = 0; i + 1 < placesM_.size(); ++i) {
            addPieces(placesM_[i], placesM_[i + 1], result.pieces);
        }
        std::size_t from = 0;
        for (std::size_t k = 0; k + 1 < keptM_.size(); ++k) {
            std::size_t to = from;
            while (to < result.pieces.size() && result.pieces[to].fromM < keptM_[k + 1] - kSamePlaceM) {
                ++to;
            }
            bend({result.pieces.begin() + static_cast<std::ptrdiff_t>(from),
                  result.pieces.begin() + static_cast<std::ptrdiff_t>(to)},
                 {keptM_[k], keptM_[k + 1]}, result);
            from = to;
        }
        return result;
    }

private:
    /// The place at which the window reaches as far as `m`, ahead (1) or back (-1).
    double reaching(double m, double ahead) const {
        const double most = windows_.at(m);
        // Its half grows or falls by half a metre in each metre.
        double near = m;
        double far = std::clamp(m - ahead * most, 0.0, line_.lengthM());
        std::size_t stretch = windows_.stretchAt(m);
        for (int i = 0; i < 60 && std::abs(far - near) > 0.1 * kSamePlaceM; ++i) {
            const double middle = 0.5 * (near + far);
            const bool reaches = ahead * (middle + ahead * 0.5 * windows_.at(middle, stretch) - m) >= 0.0;
            (reaches ? near : far) = middle;
        }
        return 0.5 * (near + far);
    }

    void collectPlaces() {
        std::vector<double> needed = line_.joints();
        std::vector<double> others = windows_.kinks();
        const std::vector<CurvePiece>& pieces = line_.pieces();
        keptM_.push_back(0.0);
        double straightM = -1.0;  // where the straight began
        for (std::size_t i = 0; i <= pieces.size(); ++i) {
            const bool ends = i == pieces.size();
            const bool isStraight = !ends && std::abs(pieces[i].curvature.si()) < kNoCurvature &&
                                    std::abs(pieces[i].endCurvature.si()) < kNoCurvature;
            const bool turnsBack = i > 0 && !ends && pieces[i].gear != pieces[i - 1].gear;
            const double here = i == 0 ? 0.0 : line_.endM(i - 1);
            if (straightM >= 0.0 && (!isStraight || turnsBack)) {
                keepStraight(straightM, here);
                straightM = -1.0;
            }
            if (isStraight && straightM < 0.0) {
                straightM = here;
            }
            if (turnsBack || ends) {
                needed.push_back(here);
            }
            others.push_back(here);
            if (windows_.at(here) > kNoWindowM) {
                others.push_back(reaching(here, 1.0));
                others.push_back(reaching(here, -1.0));
            }
        }
        keptM_.push_back(line_.lengthM());
        for (const LineRange& range : windows_.kept()) {
            keptM_.push_back(range.fromM);
            keptM_.push_back(range.toM);
        }
        std::ranges::sort(keptM_);
        dropSame(keptM_);
        std::ranges::copy(keptM_, std::back_inserter(needed));
        std::ranges::sort(needed);
        dropSame(needed);
        std::ranges::sort(others);
        // Averaged curvature changes evenly enough for fewer places than the given line has.
        for (std::size_t i = 0, k = 0; i < needed.size(); ++i) {
            placesM_.push_back(needed[i]);
            for (; k < others.size() && (i + 1 == needed.size() || others[k] < needed[i + 1]); ++k) {
                const double apartM = std::max(kSamePlaceM, kPlaceShare * windows_.at(others[k]));
                const double nextM = i + 1 < needed.size() ? needed[i + 1] : line_.lengthM();
                if (others[k] - placesM_.back() >= apartM && nextM - others[k] >= apartM) {
                    placesM_.push_back(others[k]);
                }
            }
        }
        // The last one is the end of the line.
        placesM_.back() = line_.lengthM();
        keepInLongBends();
    }

    static void dropSame(std::vector<double>& places) {
        const auto same = [](double a, double b) { return b - a < kSamePlaceM; };
        places.erase(std::unique(places.begin(), places.end(), same), places.end());
    }

    /// Long bends without a straight are tied to the given line in between, too. On full lock the line has
    /// no choice, so not near that.
    void keepInLongBends() {
        std::vector<double> all;
        double lastM = 0.0;
        double lockedM = -kFreeM;
        auto next = keptM_.begin();
        for (const double m : placesM_) {
            const double curvature = std::abs(line_.meanCurvature(m, windows_.at(m), false));
            if (curvature > kFreeShare * sharpest_) {
                lockedM = m;
                while (!all.empty() && all.back() > m - kFreeM &&
                       !std::ranges::binary_search(keptM_, all.back())) {
                    all.pop_back();
                }
            }
            while (next != keptM_.end() && *next <= m) {
                lastM = *next++;
                all.push_back(lastM);
            }
            if (next != keptM_.end() && m - lastM > kLongestBendM && *next - m > kLongestBendM &&
                m - lockedM > kFreeM) {
                all.push_back(m);
                lastM = m;
            }
        }
        keptM_ = std::move(all);
    }

    /// Where the mean of the given line's positions and headings over the window is.
    Pose keptPose(double m) const {
        const double windowM = windows_.at(m);
        Pose pose = line_.poseAt(m);
        if (windowM < kNoWindowM) {
            return pose;
        }
        const double curvature = line_.meanCurvature(m, windowM, false);
        const double gear = line_.gearAt(m) == Gear::Forward ? 1.0 : -1.0;
        const Point ahead = direction(pose.heading.si());
        pose.position = pose.position + curvature * windowM * windowM / 24.0 * Point{-ahead.y, ahead.x};
        pose.heading = pose.heading + radians(gear * line_.meanTurn(m, windowM));
        return pose;
    }

    void keepStraight(double fromM, double toM) {
        const double beginM = fromM <= 0.0 ? fromM : reaching(fromM, -1.0);
        const double endM = toM >= line_.lengthM() ? toM : reaching(toM, 1.0);
        if (endM - beginM > kKeptStraightM) {
            keptM_.push_back(0.5 * (beginM + endM));
        }
    }

    void addPieces(double fromM, double toM, std::vector<EasedPiece>& pieces) const {
        const double windowM = windows_.at(fromM);
        const double endWindowM = windows_.at(toM);
        const double begins = line_.meanCurvature(fromM, windowM, false);
        const double ends = line_.meanCurvature(toM, endWindowM, true);
        const double middle = 0.5 * (fromM + toM);
        const double bowed = line_.meanCurvature(middle, windows_.at(middle), false) - 0.5 * (begins + ends);
        const double share = (toM - fromM) / (kWindowShare * std::max(windowM, endWindowM) + kSamePlaceM);
        const int parts = std::abs(bowed) < kNoCurvature + 1e-4 * std::abs(begins - ends)
                              ? 1
                              : std::clamp(static_cast<int>(std::ceil(share)), 2, kMostParts);
        double curvature = begins;
        for (int i = 0; i < parts; ++i) {
            const double partM = fromM + (toM - fromM) * i / parts;
            const double nextM = i + 1 == parts ? toM : fromM + (toM - fromM) * (i + 1) / parts;
            const double next = i + 1 == parts ? ends : line_.meanCurvature(nextM, windows_.at(nextM), true);
            const auto plain = [](double one) {
                return Curvature::fromSi(std::abs(one) < kNoCurvature ? 0.0 : one);
            };
            pieces.push_back(
                {.start = {}, .piece = {}, .was = line_.poseAt(partM), .fromM = partM, .toM = nextM});
            pieces.back().piece = {.length = metres(nextM - partM),
                                   .curvature = plain(curvature),
                                   .endCurvature = plain(next),
                                   .gear = line_.gearAt(0.5 * (partM + nextM))};
            curvature = next;
        }
    }

    static bool isStraight(const EasedPiece& piece) {
        return piece.piece.curvature == Curvature{} && piece.piece.endCurvature == Curvature{};
    }

    /// Changes the lengths so that the bend ends where it did.
    void bend(std::span<EasedPiece> pieces, const LineRange& range, EasedLine& result) {
        if (pieces.empty()) {
            return;
        }
        const double middleM = 0.5 * (range.fromM + range.toM);
        if (windows_.at(range.fromM) + windows_.at(middleM) + windows_.at(range.toM) < kNoWindowM) {
            for (EasedPiece& piece : pieces) {
                piece.start = piece.was;
                piece.isSame = true;
            }
            return;
        }
        pieces.front().start = keptPose(range.fromM);
        const Pose goal = keptPose(range.toM);
        if (std::ranges::all_of(pieces, isStraight)) {
            drive(pieces);
            markSame(pieces);
            return;
        }
        result.bends.push_back(range);
        if (const LineEasing::Bend* const same = knownOf(pieces, goal)) {
            std::ranges::copy(same->after, pieces.begin());
            bends_.push_back(*same);
        } else {
            LineEasing::Bend made{{pieces.begin(), pieces.end()}, goal, {}, !reach(pieces, goal)};
            made.after.assign(pieces.begin(), pieces.end());
            bends_.push_back(std::move(made));
        }
        if (bends_.back().failed) {
            result.failed.push_back(range);
        }
    }

    /// The bend of the time before with the same pieces between the same poses. Null if there is none.
    const LineEasing::Bend* knownOf(std::span<const EasedPiece> pieces, const Pose& goal) const {
        const auto known =
            std::ranges::lower_bound(known_, pieces.front().fromM, {},
                                     [](const LineEasing::Bend& bend) { return bend.before.front().fromM; });
        return known != known_.end() && known->goal == goal && std::ranges::equal(known->before, pieces)
                   ? &*known
                   : nullptr;
    }

    /// Changes the pieces so that they end in the goal. False, with the given line, where none of them does.
    bool reach(std::span<EasedPiece> pieces, const Pose& goal) const {
        const auto missingAt = [&](const Pose& end) {
            return std::pair{goal.position - end.position, wrappedAngle(goal.heading - end.heading).si()};
        };
        std::vector<Change> changes;
        std::optional<Pose> last;
        for (int round = 0; round < kMostRounds; ++round) {
            const Pose end = drive(pieces);
            const auto [missing, turn] = missingAt(end);
            if (norm(missing) < kEndM && std::abs(turn) < kEndRad) {
                last = end;
                break;
            }
            // Derivatives hold for a few steps.
            if (round % kSameDerivatives == 0) {
                changesOf(pieces, end, changes);
            }
            if (!stretch(changes, missing, turn)) {
                break;
            }
        }
        const auto [missing, turn] = missingAt(last ? *last : drive(pieces));
        const bool reached = norm(missing) < kNearEndM && std::abs(turn) < kNearEndRad;
        const bool keptLengths = std::ranges::all_of(pieces, [](const EasedPiece& piece) {
            const double wasM = piece.toM - piece.fromM;
            return isStraight(piece) || (piece.piece.length.si() >= kLeastLeft * wasM &&
                                         piece.piece.length.si() <= kMostGrown * wasM);
        });
        const bool isMade = reached && keptLengths;
        if (!isMade) {
            restore(pieces);
        }
        markSame(pieces);
        return isMade;
    }

    static Pose drive(std::span<EasedPiece> pieces) {
        Pose pose = pieces.front().start;
        for (EasedPiece& piece : pieces) {
            piece.start = pose;
            pose = advanced(pose, piece.piece, piece.piece.length);
        }
        return pose;
    }

    /// A length, or the curvature at the end of one piece and the beginning of the next, which may change so
    /// that the bend ends where it did.
    struct Change {
        Eigen::Vector3d moves;  ///< the end by this, for each unit
        double weight = 0.0;
        CurvePiece* piece = nullptr;
        Curvature* end = nullptr;    ///< of one piece; null for a length
        Curvature* begin = nullptr;  ///< of the next
        double by = 0.0;
        bool isFree = true;  ///< not at its bound

        double curvature() const { return (end != nullptr ? end : begin)->si(); }
        void set(double curvature) const {
            for (Curvature* const side : {end, begin}) {
                if (side != nullptr) {
                    *side = Curvature::fromSi(curvature);
                }
            }
        }
    };

    /// The movement of the bend's end for one unit of a value of one piece.
    template <class Alter>
    static Eigen::Vector3d movement(const EasedPiece& eased, const Pose& ends, const Pose& end,
                                    Alter&& alter) {
        CurvePiece other = eased.piece;
        alter(other, kProbe);
        const Pose moved = advanced(eased.start, other, other.length);
        const double turn = wrappedAngle(moved.heading - ends.heading).si() / kProbe;
        const Point by = (1.0 / kProbe) * (moved.position - ends.position);
        const Point rest = end.position - ends.position;
        return {by.x - turn * rest.y, by.y + turn * rest.x, turn};
    }

    static void changesOf(std::span<EasedPiece> pieces, const Pose& end, std::vector<Change>& changes) {
        changes.clear();
        // Most of the cost is that of movements, and straight places need none.
        const auto addCurvature = [&](const auto& moves, Curvature* before, Curvature* after,
                                      double lengthM) {
            const double curvature = (before != nullptr ? before : after)->si();
            if (std::abs(curvature) > kNoCurvature) {
                changes.push_back({.moves = moves(),
                                   .weight = kCurvatureWeight * curvature * curvature / lengthM,
                                   .end = before,
                                   .begin = after});
            }
        };
        const auto byBegin = [](CurvePiece& piece, double by) { piece.curvature += Curvature::fromSi(by); };
        const auto byEnd = [](CurvePiece& piece, double by) { piece.endCurvature += Curvature::fromSi(by); };
        const auto byLength = [](CurvePiece& piece, double by) { piece.length += metres(by); };
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            CurvePiece& piece = pieces[i].piece;
            const bool isLast = i + 1 == pieces.size();
            const Pose ends = isLast ? end : pieces[i + 1].start;
            changes.push_back({.moves = movement(pieces[i], ends, end, byLength),
                               .weight = weight(pieces[i]),
                               .piece = &piece});
            if (isLast) {
                break;
            }
            EasedPiece& after = pieces[i + 1];
            const Pose afterEnds = i + 2 < pieces.size() ? pieces[i + 2].start : end;
            const auto here = [&] { return movement(pieces[i], ends, end, byEnd); };
            const auto there = [&] { return movement(after, afterEnds, end, byBegin); };
            const double lengthM = piece.length.si();
            const double nextM = after.piece.length.si();
            if (after.piece.curvature == piece.endCurvature) {
                const auto both = [&] { return Eigen::Vector3d{here() + there()}; };
                addCurvature(both, &piece.endCurvature, &after.piece.curvature, lengthM + nextM);
            } else {
                addCurvature(here, &piece.endCurvature, nullptr, lengthM);
                addCurvature(there, nullptr, &after.piece.curvature, nextM);
            }
        }
    }

    /// One step of Newton. The weights keep the change of each value in proportion to it. A curvature stays
    /// within the bound. False if a length would vanish.
    bool stretch(std::vector<Change>& changes, Point missing, double turn) const {
        for (Change& change : changes) {
            change.isFree = true;
        }
        Eigen::Vector3d left{missing.x, missing.y, turn};
        for (int again = 0; again < kMostBounded; ++again) {
            Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
            for (const Change& change : changes) {
                if (change.isFree) {
                    sum += change.weight * change.moves * change.moves.transpose();
                }
            }
            sum.diagonal().array() += 1e-13 * sum.trace();
            const Eigen::Vector3d dual = sum.ldlt().solve(left);
            // Curvatures that reach the bound stay there, and the others do the rest.
            bool isBounded = false;
            for (Change& change : changes) {
                change.by = change.isFree ? change.weight * change.moves.dot(dual) : 0.0;
                if (change.piece == nullptr && change.isFree &&
                    std::abs(change.curvature() + change.by) > sharpest_) {
                    const double bounded = std::copysign(sharpest_, change.curvature());
                    left -= (bounded - change.curvature()) * change.moves;
                    change.set(bounded);
                    change.isFree = false;
                    change.by = 0.0;
                    isBounded = true;
                }
            }
            if (!isBounded) {
                break;
            }
        }
        for (const Change& change : changes) {
            if (change.piece == nullptr) {
                change.set(std::clamp(change.curvature() + change.by, -sharpest_, sharpest_));
                continue;
            }
            const double lengthM = change.piece->length.si() + change.by;
            if (!std::isfinite(lengthM) || lengthM <= 0.0) {
                return false;
            }
            change.piece->length = metres(lengthM);
        }
        return true;
    }

    static double weight(const EasedPiece& piece) {
        return (isStraight(piece) ? kStraightWeight : 1.0) * piece.piece.length.si();
    }

    /// The given line in these pieces.
    void restore(std::span<EasedPiece> pieces) const {
        for (EasedPiece& piece : pieces) {
            piece.start = piece.was;
            piece.piece.length = metres(piece.toM - piece.fromM);
            piece.piece.curvature = Curvature::fromSi(line_.meanCurvature(piece.fromM, 0.0, false));
            piece.piece.endCurvature = Curvature::fromSi(line_.meanCurvature(piece.toM, 0.0, true));
        }
    }

    void markSame(std::span<EasedPiece> pieces) const {
        for (EasedPiece& piece : pieces) {
            if (!isStraight(piece)) {
                continue;
            }
            const Pose ends = advanced(piece.start, piece.piece, piece.piece.length);
            piece.isSame = distance(piece.start.position, piece.was.position) < kSameM &&
                           distance(ends.position, line_.poseAt(piece.toM).position) < kSameM &&
                           std::abs(wrappedAngle(piece.was.heading - piece.start.heading).si()) < kNearEndRad;
        }
    }

    const GivenLine& line_;
    const AveragingWindows& windows_;
    double sharpest_;  ///< 1/m
    const Bends& known_;
    Bends bends_;
    std::vector<double> placesM_;  ///< ends of pieces
    std::vector<double> keptM_;    ///< where the pose stays
};

}  // namespace

LineEasing::LineEasing(std::span<const Curve> lines, Curvature sharpest)
    : line_{lines}, sharpest_{sharpest} {}

EasedLine LineEasing::with(const AveragingWindows& windows) {
    if (line_.isEmpty()) {
        return {};
    }
    Easing easing{line_, windows, sharpest_.si(), known_};
    EasedLine made = easing.run();
    known_ = easing.takeBends();
    return made;
}

EasedLine eased(std::span<const Curve> lines, const AveragingWindows& windows, Curvature sharpest) {
    return LineEasing{lines, sharpest}.with(windows);
}

}  // namespace furrow
