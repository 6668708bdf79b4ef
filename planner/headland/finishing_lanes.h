#pragma once

#include "planner/geometry/ring_clipping.h"
#include "planner/headland/finishing_passes.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace furrow {

// Internal to the finishing passes: where a straight pass could lie, and what it would gain.

/// A pass of the implement: its middle goes from `from` to `to`.
struct FinishingPass {
    Point from;
    Point to;
    double gainM2 = 0.0;
};

/// The area that a pass works.
Ring stripOf(const FinishingPass& pass, double widthM);

/// The line of the vehicle's reference point.
Curve lineOf(const FinishingPass& pass, const Machine& machine);

/// A stretch of a line beside land that is left.
struct FinishingLane {
    Point on;
    Point along;  ///< unit vector
    double fromM = 0.0;
    double toM = 0.0;
    double gainM2 = 0.0;  ///< at most
    bool isFree = false;  ///< known to have room for the machine
};

/// The land that is left, in pieces.
class LeftLand {
public:
    struct Piece {
        Polygon outline;
        Bounds box;
        Area area;
    };
    /// What one more pass makes of it.
    struct Cut {
        std::vector<std::size_t> cut;  ///< pieces that the pass may touch, by index, rising
        std::vector<Piece> rest;       ///< of them
        Area inAll;
        Area largest;
    };

    explicit LeftLand(const MultiPolygon& all);

    const std::vector<Piece>& pieces() const { return pieces_; }
    Area inAll() const { return inAll_; }
    Area largest() const { return largest_; }

    /// Cost: that of GEOS for the pieces near by. Cancelled.
    Result<Cut> cutBy(const MultiPolygon& worked, const JobContext& job) const;
    void take(Cut cut);
    void sortLargestFirst();

private:
    std::vector<Piece> pieces_;
    Area inAll_;
    Area largest_;
};

/// Finds lanes for one task, which it refers to.
class FinishingLanes {
public:
    explicit FinishingLanes(const FinishingTask& task);

    double widthM() const { return widthM_; }
    /// Whether so much was looked at that the rest of the land is not worth more: on outlines of a thousand
    /// teeth every pass is beside every other one. Counted, not timed, so that plans stay the same.
    bool isSpent() const;
    /// The least gain worth lowering the implement for, and worth the search for a bend.
    double leastGainM2() const;
    double leastGainOfBendM2() const;
    /// Whether nearly the same pass was refused before.
    bool isRefused(const Curve& line) const;

    /// Every stretch beside a piece on which a pass would gain enough. Room is not checked yet.
    std::vector<FinishingLane> beside(const Polygon& piece) const;
    /// Every stretch over a piece, in all headings, independent of the edges beside it.
    std::vector<FinishingLane> across(const Polygon& piece) const;

    /// The land still left beside a lane: no pass on it gains more.
    double landBesideM2(const FinishingLane& lane, const LeftLand& left) const;
    /// The pass along a lane over the land still left beside it. Empty if it gains too little.
    std::optional<FinishingPass> passAlong(const FinishingLane& lane, const LeftLand& left) const;
    /// The line of a pass in the other direction; empty where the machine has no room for it.
    std::optional<Curve> otherWay(const FinishingPass& pass) const;
    /// The stretches of a lane on which the machine has room.
    std::vector<FinishingLane> free(const FinishingLane& lane) const;

private:
    bool worksOnPurposeLeft(const FinishingPass& pass) const;
    bool isClear(const Curve& line) const;
    void addLane(const Polygon& piece, Point on, Point along, double lengthM,
                 std::vector<FinishingLane>& lanes) const;

    /// Valid until the next one.
    const Ring& clippedBy(const Ring& strip, const Ring& ring) const;

    const FinishingTask& task_;
    double widthM_;
    double flushM_;  ///< from an edge to the middle of a pass along it
    double runInM_;
    mutable std::size_t pointsClipped_ = 0;
    mutable RingClipping clipping_;
};

}  // namespace furrow
