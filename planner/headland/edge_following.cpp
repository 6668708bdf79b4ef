#include "planner/headland/edge_following.h"

#include "planner/geometry/segment.h"
#include "planner/turns/trailer.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace furrow {

namespace {

constexpr double kStationStepM = 0.25;
constexpr double kClosestM = 0.05;
// Kept from the edge for the error of the first order. Lines that are flush with the edge do not need it.
constexpr double kFirstOrderReserveM = 0.01;
constexpr double kFlushM = 1e-3;
// A station that bends more than this share of the machine's sharpest bend can only move in.
constexpr double kBentShare = 0.5;
// Smaller moves are ignored.
constexpr double kSettledM = 2e-5;
constexpr int kMostSettlings = 1000;
// Number of rounds in which both sides of a bend towards the edge move in, and their share of the excess.
constexpr int kGivingRounds = 20;
constexpr double kGiven = 0.5;
// Share of the machine's sharpest curvature. The rest is for rounding the points again.
constexpr double kCurvatureShare = 0.95;

/// A corner of the footprint on the side of the edge, or the middle of that side.
struct Feeler {
    Point at;
    bool mayOverhang = false;
    std::vector<double> outsideM = {};  ///< at every station, negative inside
};

std::vector<Feeler> feelersOf(const Machine& machine, bool overhangs) {
    std::vector<Feeler> feelers;
    double side = 0.0;
    for (const Point& corner : machine.workingFootprint()) {
        side = std::min(side, corner.y);
        if (corner.y < 0.0) {
            feelers.push_back({.at = corner, .mayOverhang = overhangs});
        }
    }
    feelers.push_back({.at = {0.0, side}});
    for (const Point& corner : overhangs ? tractorOutline(machine) : Ring{}) {
        if (corner.y < 0.0) {
            feelers.push_back({.at = corner});
        }
    }
    return feelers;
}

/// A place along a line. An arc that is left out is one station, at the point where its two sides meet.
struct Station {
    Pose pose;
    bool isLeftOut = false;
};

std::vector<Station> stationsOf(const Curve& line, const FollowingRules& rules) {
    std::vector<Station> stations;
    Pose begins = line.start;
    for (const CurvePiece& piece : line.pieces) {
        const Pose ends = advanced(begins, piece, piece.length);
        const auto steps = std::max(1, static_cast<int>(std::ceil(piece.length.si() / kStationStepM)));
        if (piece.curvature != Curvature{} && rules.leavesOut(begins.position) &&
            rules.leavesOut(ends.position)) {
            const Point ahead = direction(begins.heading.si());
            const double toCornerM =
                toMeeting(begins.position, ahead, ends.position, direction(ends.heading.si())).first;
            stations.push_back(
                {{.position = begins.position + toCornerM * ahead, .heading = begins.heading}, true});
        } else {
            for (int i = 0; i < steps; ++i) {
                const Pose pose = advanced(begins, piece, piece.length * (static_cast<double>(i) / steps));
                if (stations.empty() || distance(stations.back().pose.position, pose.position) > kClosestM) {
                    stations.push_back({pose, rules.leavesOut(pose.position)});
                }
            }
        }
        begins = ends;
    }
    return stations;
}

/// An ordered set of numbers. It finds its members without testing each missing number.
class NumberSet {
public:
    NumberSet() = default;
    /// All numbers below `size`.
    explicit NumberSet(std::size_t size) : words_((size + kBits - 1) / kBits, ~Word{0}) {
        if (size % kBits != 0) {
            words_.back() = (Word{1} << size % kBits) - 1;
        }
    }

    void add(std::size_t i) { words_[i / kBits] |= Word{1} << i % kBits; }
    void remove(std::size_t i) { words_[i / kBits] &= ~(Word{1} << i % kBits); }

    /// The least member that is not below `i`.
    std::optional<std::size_t> from(std::size_t i) const {
        Word mask = ~Word{0} << i % kBits;
        for (std::size_t w = i / kBits; w < words_.size(); ++w, mask = ~Word{0}) {
            if (const Word word = words_[w] & mask; word != 0) {
                return w * kBits + static_cast<std::size_t>(std::countr_zero(word));
            }
        }
        return std::nullopt;
    }
    /// The greatest member below `i`.
    std::optional<std::size_t> below(std::size_t i) const {
        Word mask = (Word{1} << i % kBits) - 1;
        for (std::size_t w = std::min(i / kBits, words_.size()); true; mask = ~Word{0}) {
            if (const Word word = w < words_.size() ? words_[w] & mask : 0; word != 0) {
                return w * kBits + kBits - 1 - static_cast<std::size_t>(std::countl_zero(word));
            }
            if (w-- == 0) {
                return std::nullopt;
            }
        }
    }

private:
    using Word = std::uint64_t;
    static constexpr std::size_t kBits = 64;
    std::vector<Word> words_;
};

/// The demands of tail and nose on neighbouring stations, and their least solution.
class WayIn {
public:
    WayIn(std::vector<Station> stations, const AllowedEdges& edges, const Machine& machine, Length beside)
        : stations_{std::move(stations)},
          feelers_{feelersOf(machine, edges.hasOverhang())},
          sharpest_{kCurvatureShare / machine.minTurningRadius().si()} {
        for (const Point& corner : machine.workingFootprint()) {
            mostM_ = std::max(mostM_, norm(corner));
        }
        for (Feeler& feeler : feelers_) {
            for (const Station& station : stations_) {
                feeler.outsideM.push_back(outsideM(
                    feeler, station, feeler.mayOverhang ? edges.implement() : edges.tractor(), beside));
            }
        }
        for (std::size_t i = 0; i < stations_.size(); ++i) {
            const Pose& here = stations_[i].pose;
            const Pose& there = stations_[next(i)].pose;
            stepM_.push_back(std::max(1e-3, distance(here.position, there.position)));
            bend_.push_back(wrappedAngle(there.heading - here.heading).si() / stepM_[i]);
            const bool staysPut = std::abs(bend_[i]) > kBentShare * sharpest_ || stations_[i].isLeftOut;
            inM_.push_back(staysPut ? 0.0 : -edges.tractor().reachM());
        }
        pending_ = NumberSet{stations_.size()};
    }

    /// Finds the least way in at every station with nothing outside and no bend sharper than the machine can
    /// drive.
    void solve() {
        settle();
        // A station that has moved in more than its neighbours bends the line the other way. There is no
        // least solution, so both neighbours give a little, for several rounds.
        for (int round = 0; round < kGivingRounds; ++round) {
            for (std::size_t i = 0; i < stations_.size(); ++i) {
                const auto [meanM, sagM] = besideNeighbours(i);
                const double tooFarM = inM_[i] - meanM - sagM * (sharpest_ + bend_[i]);
                if (tooFarM > 0.0 && !stations_[i].isLeftOut) {
                    raise(last(i), inM_[last(i)] + kGiven * tooFarM);
                    raise(next(i), inM_[next(i)] + kGiven * tooFarM);
                }
            }
            settle();
        }
    }

    Ring ring() const {
        Ring ring;
        for (std::size_t i = 0; i < stations_.size(); ++i) {
            const Point ahead = direction(stations_[i].pose.heading.si());
            ring.push_back(stations_[i].pose.position + inM_[i] * Point{-ahead.y, ahead.x});
        }
        return ring;
    }

private:
    std::size_t next(std::size_t i) const { return (i + 1) % stations_.size(); }
    std::size_t last(std::size_t i) const { return (i + stations_.size() - 1) % stations_.size(); }

    static double outsideM(const Feeler& feeler, const Station& station, const BoundaryDistance& edges,
                           Length beside) {
        if (station.isLeftOut) {
            return -edges.reachM();
        }
        const Point ahead = direction(station.pose.heading.si());
        const Point at = station.pose.position + feeler.at.x * ahead + feeler.at.y * Point{-ahead.y, ahead.x};
        const double insideM = edges.insideM(at).value_or(edges.reachM()) - beside.si();
        return (std::abs(insideM) < kFlushM ? 0.0 : kFirstOrderReserveM) - insideM;
    }

    void raise(std::size_t i, double wantedM) {
        const double leastM = std::min(wantedM, mostM_);
        if (leastM > inM_[i] + kSettledM) {
            inM_[i] = leastM;
            for (const std::size_t touched : {i, next(i), last(i)}) {
                pending_.add(touched);
            }
            changed_ = true;
        }
    }

    /// The value at a station if its line bent like its neighbours', and the sag for one unit of curvature.
    std::pair<double, double> besideNeighbours(std::size_t i) const {
        const double beforeM = stepM_[last(i)];
        const double meanM = (stepM_[i] * inM_[last(i)] + beforeM * inM_[next(i)]) / (beforeM + stepM_[i]);
        return {meanM, 0.5 * beforeM * stepM_[i]};
    }

    void ask(std::size_t i) {
        pending_.remove(i);
        for (const Feeler& feeler : feelers_) {
            const double x = feeler.at.x;
            const double missingM = feeler.outsideM[i] - inM_[i];
            if (x > stepM_[i]) {
                raise(next(i), inM_[i] + stepM_[i] / x * missingM);
            } else if (x < -stepM_[last(i)]) {
                raise(last(i), inM_[i] - stepM_[last(i)] / x * missingM);
            } else {
                raise(i, feeler.outsideM[i]);
            }
        }
        // Neighbours that move in more than a corner bend the line more.
        if (!stations_[i].isLeftOut) {
            const auto [meanM, sagM] = besideNeighbours(i);
            raise(i, meanM - sagM * (sharpest_ - bend_[i]));
        }
    }

    void settle() {
        for (int round = 0; std::exchange(changed_, false) && round < kMostSettlings; ++round) {
            for (auto i = pending_.from(0); i; i = pending_.from(*i + 1)) {
                ask(*i);
            }
            for (auto i = pending_.below(stations_.size()); i; i = pending_.below(*i)) {
                ask(*i);
            }
        }
    }

    std::vector<Station> stations_;
    std::vector<Feeler> feelers_;
    double sharpest_;            ///< 1/m
    double mostM_ = 0.0;         ///< a larger value means that the line does not fit anyway
    std::vector<double> stepM_;  ///< to the next station
    std::vector<double> bend_;   ///< 1/m
    std::vector<double> inM_;
    NumberSet pending_;  ///< stations whose neighbourhood has changed since their last turn
    bool changed_ = true;
};

}  // namespace

bool FollowingRules::leavesOut(Point place) const {
    return leftOut.anyNearer(place, aroundM);
}

Ring followingTheEdge(const Curve& line, const AllowedEdges& edges, const Machine& machine,
                      const FollowingRules& rules) {
    WayIn way{stationsOf(line, rules), edges, machine, rules.beside};
    way.solve();
    return way.ring();
}

}  // namespace furrow
