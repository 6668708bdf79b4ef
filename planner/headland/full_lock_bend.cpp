#include "planner/headland/full_lock_bend.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ranges>
#include <utility>

namespace furrow {

namespace {

// Of a square, in sides, and a little more.
constexpr double kHalfDiagonal = 0.708;

/// How far a place is from a strip, at least: across the line on which the implement works.
double awayAcrossM(std::span<const Point, 4> strip, Point place) {
    const Point right = 0.5 * (strip[0] + strip[1]);
    const Point line = 0.5 * (strip[2] + strip[3]) - right;
    const Point along = (1.0 / norm(line)) * line;
    double halfM = 0.0;
    for (const Point& corner : strip) {
        halfM = std::max(halfM, std::abs(cross(along, corner - right)));
    }
    return std::abs(cross(along, place - right)) - halfM;
}

Point turned(Point point, Point by) {
    return {by.x * point.x - by.y * point.y, by.y * point.x + by.x * point.y};
}

}  // namespace

WorkingLine workingLine(const RigState& state, const Machine& machine,
                        const std::optional<Trailer>& trailer) {
    const Implement& implement = machine.spec().implement;
    const Point ahead = direction(state.implement.si());
    const Point left{-ahead.y, ahead.x};
    const Point carried =
        trailer ? trailer->poseOf(state.tractor, state.implement).position : state.tractor.position;
    const double behindM = trailer ? -trailer->trailingM : implement.offset.si();
    const Point middle = carried + behindM * ahead + implement.lateralOffset.si() * left;
    const Point half = 0.5 * implement.operatingWidth.si() * left;
    return {middle - half, middle + half};
}

FullLockBend::FullLockBend(const Rig& lowered, double side, double rounds, Length look)
    : curvature_{Curvature::fromSi(side / lowered.machine().minTurningRadius().si())} {
    const double radiusM = lowered.machine().minTurningRadius().si();
    const std::optional<Trailer> trailer = Trailer::of(lowered.machine());
    const CurvePiece arc{.length = metres(rounds * 2.0 * std::numbers::pi * radiusM),
                         .curvature = curvature_};
    step_ = arc.length / std::ceil(arc.length / look);
    const RigState from =
        Rig::inLine({.position = {radiusM, 0.0}, .heading = radians(side * 0.5 * std::numbers::pi)});
    WorkingLine last = workingLine(from, lowered.machine(), trailer);
    states_.push_back(from);
    strips_.push_back({});
    static_cast<void>(lowered.follow(from, arc, look, [&](const RigState& state) {
        const WorkingLine line = workingLine(state, lowered.machine(), trailer);
        states_.push_back(state);
        strips_.push_back({last.first, line.first, line.second, last.second});
        last = line;
        return true;
    }));
    enterStrips();
}

void FullLockBend::enterStrips() {
    Ring corners;
    for (const Strip& strip : strips_ | std::views::drop(1)) {
        corners.insert(corners.end(), strip.begin(), strip.end());
    }
    box_ = bounds(corners);
    columns_ = columnOf(box_.max.x) + 1;
    cells_.resize(columns_ * (rowOf(box_.max.y) + 1));
    for (std::size_t i = 1; i < strips_.size(); ++i) {
        const Bounds box = bounds(strips_[i]);
        for (std::size_t row = rowOf(box.min.y); row <= rowOf(box.max.y); ++row) {
            for (std::size_t column = columnOf(box.min.x); column <= columnOf(box.max.x); ++column) {
                const Point middle = box_.min + kCellM * Point{static_cast<double>(column) + 0.5,
                                                               static_cast<double>(row) + 0.5};
                if (awayAcrossM(strips_[i], middle) < kHalfDiagonal * kCellM) {
                    cells_[row * columns_ + column].push_back(i);
                }
            }
        }
    }
}

RigState FullLockBend::stateAt(std::size_t state, Point middle, Angle begin) const {
    const RigState& seen = states_[state];
    return {{.position = middle + turned(seen.tractor.position, direction(begin.si())),
             .heading = seen.tractor.heading + begin},
            seen.implement + begin};
}

std::optional<std::size_t> FullLockBend::firstOver(Point place) const {
    if (place.x < box_.min.x || place.x > box_.max.x || place.y < box_.min.y || place.y > box_.max.y) {
        return std::nullopt;
    }
    const auto& near = cells_[rowOf(place.y) * columns_ + columnOf(place.x)];
    const auto first =
        std::ranges::find_if(near, [&](std::size_t strip) { return isInside(strips_[strip], place); });
    return first != near.end() ? std::optional{*first} : std::nullopt;
}

}  // namespace furrow
