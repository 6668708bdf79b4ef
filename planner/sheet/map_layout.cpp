#include "planner/sheet/map_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace furrow {

double roundMapScale(const Bounds& extent, double widthMm, double heightMm) {
    constexpr std::array kSteps{1.0, 1.25, 1.5, 1.75, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0, 6.0, 7.5, 8.0, 10.0};
    constexpr double kFinest = 100.0;
    const double needed =
        std::max({kFinest, 1000.0 * extent.width() / widthMm, 1000.0 * extent.height() / heightMm});
    const double power = std::pow(10.0, std::floor(std::log10(needed) + 1e-12));
    for (const double step : kSteps) {
        if (step * power >= needed * (1.0 - 1e-12)) {
            return std::round(step * power);
        }
    }
    return 10.0 * power;
}

bool PaperBox::overlaps(const PaperBox& other) const {
    return corner.x < other.corner.x + other.width && other.corner.x < corner.x + width &&
           corner.y < other.corner.y + other.height && other.corner.y < corner.y + height;
}

bool PaperBox::holds(const PaperBox& other) const {
    return other.corner.x >= corner.x && other.corner.y >= corner.y &&
           other.corner.x + other.width <= corner.x + width &&
           other.corner.y + other.height <= corner.y + height;
}

std::optional<Point> LabelPlaces::place(const LabelWish& wish) {
    for (const Point& middle : wish.places) {
        const PaperBox box{.corner = middle - 0.5 * Point{wish.width, wish.height},
                           .width = wish.width,
                           .height = wish.height};
        const auto isInTheWay = [&box](const PaperBox& other) { return box.overlaps(other); };
        if (within_.holds(box) && std::ranges::none_of(taken_, isInTheWay)) {
            taken_.push_back(box);
            return middle;
        }
    }
    return std::nullopt;
}

std::vector<std::optional<Point>> placeNumbers(std::span<const LabelWish> wishes, LabelPlaces& places) {
    constexpr double kNearlyAll = 0.9;
    constexpr std::array<std::size_t, 10> kSteps{1, 2, 5, 10, 20, 50, 100, 200, 500, 1000};
    std::vector<std::optional<Point>> best(wishes.size());
    for (const std::size_t step : kSteps) {
        LabelPlaces trial = places;
        std::vector<std::optional<Point>> placed(wishes.size());
        std::size_t wanted = 0;
        std::size_t found = 0;
        const auto add = [&](std::size_t index) {
            ++wanted;
            placed[index] = trial.place(wishes[index]);
            found += placed[index] ? 1U : 0U;
        };
        // The ends first: the driver looks for them.
        if (!wishes.empty()) {
            add(0);
        }
        if (wishes.size() > 1) {
            add(wishes.size() - 1);
        }
        for (std::size_t number = step; number < wishes.size(); number += step) {
            if (number > 1) {
                add(number - 1);
            }
        }
        if (static_cast<double>(found) >= kNearlyAll * static_cast<double>(wanted) || step >= wishes.size()) {
            places = std::move(trial);
            return placed;
        }
        best = std::move(placed);
    }
    return best;
}

PointOnLine pointAt(std::span<const Point> line, double share) {
    double rest = share;
    double whole = 0.0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        whole += distance(line[i], line[i + 1]);
    }
    rest *= whole;
    PointOnLine last{.place = line.empty() ? Point{} : line.front(), .way = {}};
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double length = distance(line[i], line[i + 1]);
        if (length <= 0.0) {
            continue;
        }
        const Point way = (1.0 / length) * (line[i + 1] - line[i]);
        if (rest <= length) {
            return {.place = line[i] + rest * way, .way = way};
        }
        rest -= length;
        last = {.place = line[i + 1], .way = way};
    }
    return last;
}

}  // namespace furrow
