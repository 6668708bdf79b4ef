#include "planner/headland/swept_land.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ranges>
#include <utility>

namespace furrow {

namespace {

// The sine of the turn of a run. A sharper one could meet itself.
constexpr double kMostOfRun = 0.5;

double turnsBy(const WorkingLine& from, const WorkingLine& to) {
    const Point a = from.second - from.first;
    const Point b = to.second - to.first;
    return std::abs(cross(a, b)) / (norm(a) * norm(b));
}

}  // namespace

void SweptLand::to(const WorkingLine& line) {
    const WorkingLine& last = run_.back();
    const bool isAhead = cross(line.first - last.first, line.second - last.first) > 0.0 &&
                         cross(line.second - last.first, last.second - last.first) > 0.0;
    if (!isAhead) {
        endRun();
        addTriangle({last.first, line.first, line.second});
        addTriangle({last.first, line.second, last.second});
        run_ = {line};
        return;
    }
    run_.push_back(line);
    if (turnsBy(run_.front(), line) > kMostOfRun) {
        endRun();
        run_ = {line};
    }
}

MultiPolygon SweptLand::polygons() {
    endRun();
    return std::move(polygons_);
}

void SweptLand::addTriangle(Ring ring) {
    const double twice = signedAreaM2(ring);
    if (twice < 0.0) {
        std::swap(ring[1], ring[2]);
    }
    if (twice != 0.0) {
        polygons_.push_back({.outer = std::move(ring), .holes = {}});
    }
}

void SweptLand::endRun() {
    if (run_.size() < 2) {
        return;
    }
    Ring ring;
    std::ranges::transform(run_, std::back_inserter(ring), &WorkingLine::first);
    std::ranges::transform(run_ | std::views::reverse, std::back_inserter(ring), &WorkingLine::second);
    polygons_.push_back({.outer = std::move(ring), .holes = {}});
}

}  // namespace furrow
