#include "planner/headland/edge_following.h"

#include "planner/geometry/segment.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace furrow {

namespace {

constexpr double kStepM = 0.25;
constexpr double kClosestM = 0.05;
// Kept from the edge for what the first order leaves out, but for lines that are flush with it anyway.
constexpr double kReserveM = 0.01;
constexpr double kFlushM = 1e-3;
// Where the line bends more than this share of what the machine can, it moves in only.
constexpr double kBentShare = 0.5;
// Moves by less change nothing.
constexpr double kSettledM = 2e-5;
constexpr int kMostRounds = 1000;
// How often and by how much of what is missing both sides of a bend towards the edge move in, too.
constexpr int kGivingRounds = 20;
constexpr double kGiven = 0.5;
// Of what the machine can; the rest is for rounding the points again.
constexpr double kCurvatureShare = 0.95;

/// A corner of the footprint on the side of the edge, or the middle of that side.
struct Feeler {
    Point at;
    std::vector<double> outsideM;  ///< of every station, negative inside
};

std::vector<Feeler> feelersOf(const Machine& machine) {
    std::vector<Feeler> feelers;
    double side = 0.0;
    for (const Point& corner : machine.workingFootprint()) {
        side = std::min(side, corner.y);
        if (corner.y < 0.0) {
            feelers.push_back({.at = corner, .outsideM = {}});
        }
    }
    feelers.push_back({.at = {0.0, side}, .outsideM = {}});
    return feelers;
}

/// Where more than this would be needed the line does not fit anyway.
double farthestM(const Machine& machine) {
    double farthest = 0.0;
    for (const Point& corner : machine.workingFootprint()) {
        farthest = std::max(farthest, norm(corner));
    }
    return farthest;
}

/// Places along a line. An arc that is left out is one place, the point where its two sides meet.
struct Station {
    Pose pose;
    bool isLeftOut = false;
};

std::vector<Station> stationsOf(const Turn& line, const FollowingRules& rules) {
    std::vector<Station> stations;
    Pose begins = line.start;
    for (const TurnPiece& piece : line.pieces) {
        const Pose ends = advanced(begins, piece, piece.length);
        const auto steps = std::max(1, static_cast<int>(std::ceil(piece.length.si() / kStepM)));
        if (piece.curvature != Curvature{} && rules.leavesOut(begins.position) && rules.leavesOut(ends.position)) {
            const Point ahead = direction(begins.heading.si());
            const double toCornerM = toMeeting(begins.position, ahead, ends.position, direction(ends.heading.si())).first;
            stations.push_back({{.position = begins.position + toCornerM * ahead, .heading = begins.heading}, true});
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

}  // namespace

bool FollowingRules::leavesOut(Point place) const {
    return std::ranges::any_of(leftOut, [&](Point corner) { return distance(corner, place) < aroundM; });
}

Ring followingTheEdge(const Turn& line, const BoundaryDistance& edges, const Machine& machine, const FollowingRules& rules) {
    const std::vector<Station> stations = stationsOf(line, rules);
    const std::size_t count = stations.size();
    std::vector<Feeler> feelers = feelersOf(machine);
    for (Feeler& feeler : feelers) {
        for (const auto& [pose, isLeftOut] : stations) {
            if (isLeftOut) {
                feeler.outsideM.push_back(-edges.reachM());
                continue;
            }
            const Point ahead = direction(pose.heading.si());
            const Point at = pose.position + feeler.at.x * ahead + feeler.at.y * Point{-ahead.y, ahead.x};
            const double insideM = edges.insideM(at).value_or(edges.reachM()) - rules.beside.si();
            feeler.outsideM.push_back((std::abs(insideM) < kFlushM ? 0.0 : kReserveM) - insideM);
        }
    }
    const double sharpest = kCurvatureShare / machine.minTurningRadius().si();
    std::vector<double> stepM(count);
    std::vector<double> bend(count);  // 1/m
    std::vector<double> inM(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (i + 1) % count;
        stepM[i] = std::max(1e-3, distance(stations[i].pose.position, stations[next].pose.position));
        bend[i] = std::remainder((stations[next].pose.heading - stations[i].pose.heading).si(), 2.0 * std::numbers::pi) / stepM[i];
        const bool staysPut = std::abs(bend[i]) > kBentShare * sharpest || stations[i].isLeftOut;
        inM[i] = staysPut ? 0.0 : -edges.reachM();
    }
    // Stations whose neighbourhood has changed since they asked.
    std::vector<char> pending(count, 1);
    bool changed = true;
    const double mostM = farthestM(machine);
    const auto raise = [&](std::size_t i, double wantedM) {
        const double leastM = std::min(wantedM, mostM);
        if (leastM > inM[i] + kSettledM) {
            inM[i] = leastM;
            pending[i] = pending[(i + 1) % count] = pending[(i + count - 1) % count] = 1;
            changed = true;
        }
    };
    /// What a station would have if its line bent as its neighbours' do, and how far a radius lets it be from there.
    const auto besideNeighbours = [&](std::size_t i) {
        const std::size_t before = (i + count - 1) % count;
        const std::size_t next = (i + 1) % count;
        const double meanM = (stepM[i] * inM[before] + stepM[before] * inM[next]) / (stepM[before] + stepM[i]);
        return std::pair{meanM, 0.5 * stepM[before] * stepM[i]};
    };
    const auto ask = [&](std::size_t i) {
        if (std::exchange(pending[i], 0) == 0) {
            return;
        }
        const std::size_t before = (i + count - 1) % count;
        for (const Feeler& feeler : feelers) {
            const double x = feeler.at.x;
            const double missingM = feeler.outsideM[i] - inM[i];
            if (x > stepM[i]) {
                raise((i + 1) % count, inM[i] + stepM[i] / x * missingM);
            } else if (x < -stepM[before]) {
                raise(before, inM[i] - stepM[before] / x * missingM);
            } else {
                raise(i, feeler.outsideM[i]);
            }
        }
        // Moving in before and after a corner more than in it bends the line more.
        if (!stations[i].isLeftOut) {
            const auto [meanM, sagM] = besideNeighbours(i);
            raise(i, meanM - sagM * (sharpest - bend[i]));
        }
    };
    const auto settle = [&] {
        for (int round = 0; std::exchange(changed, false) && round < kMostRounds; ++round) {
            for (std::size_t i = 0; i < count; ++i) {
                ask(i);
            }
            for (std::size_t i = count; i-- > 0;) {
                ask(i);
            }
        }
    };
    settle();
    // Moving in somewhere more than before and after bends it the other way. There is no least way to mend that: both
    // sides give a little, a few times.
    for (int round = 0; round < kGivingRounds; ++round) {
        for (std::size_t i = 0; i < count; ++i) {
            const auto [meanM, sagM] = besideNeighbours(i);
            const double tooFarM = inM[i] - meanM - sagM * (sharpest + bend[i]);
            if (tooFarM > 0.0 && !stations[i].isLeftOut) {
                raise((i + count - 1) % count, inM[(i + count - 1) % count] + kGiven * tooFarM);
                raise((i + 1) % count, inM[(i + 1) % count] + kGiven * tooFarM);
            }
        }
        settle();
    }
    Ring ring;
    for (std::size_t i = 0; i < count; ++i) {
        const Point ahead = direction(stations[i].pose.heading.si());
        ring.push_back(stations[i].pose.position + inM[i] * Point{-ahead.y, ahead.x});
    }
    return ring;
}

}  // namespace furrow
