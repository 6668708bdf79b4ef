#include "planner/path/travel_rule.h"

#include "planner/geometry/geos_bridge.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace furrow {

namespace {

constexpr double kDear = 8.0;
constexpr double kCellsAcross = 1000.0;
constexpr Length kTolerance = metres(0.25);

/// The cells of a grid whose middle is inside.
class Raster {
public:
    explicit Raster(const MultiPolygon& polygons) : box_{bounds(polygons)} {
        cellM_ = std::max(1.0, std::max(box_.width(), box_.height()) / kCellsAcross);
        columns_ = static_cast<std::size_t>(box_.width() / cellM_) + 1;
        rows_ = static_cast<std::size_t>(box_.height() / cellM_) + 1;
        std::vector<std::vector<double>> crossings(rows_);
        forEachEdge(polygons, [&](Point a, Point b) {
            if (a.y > b.y) {
                std::swap(a, b);
            }
            const auto rowAbove = [&](double y) {
                return std::clamp(std::ceil((y - box_.min.y) / cellM_ - 0.5), 0.0,
                                  static_cast<double>(rows_));
            };
            for (auto row = static_cast<std::size_t>(rowAbove(a.y));
                 row < static_cast<std::size_t>(rowAbove(b.y)); ++row) {
                const double y = box_.min.y + (static_cast<double>(row) + 0.5) * cellM_;
                crossings[row].push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
            }
        });
        inside_.resize(rows_ * columns_);
        for (std::size_t row = 0; row < rows_; ++row) {
            std::ranges::sort(crossings[row]);
            for (std::size_t i = 0; i + 1 < crossings[row].size(); i += 2) {
                const auto columnAt = [&](double x) {
                    return static_cast<std::size_t>(std::clamp(std::ceil((x - box_.min.x) / cellM_ - 0.5),
                                                               0.0, static_cast<double>(columns_)));
                };
                std::fill(inside_.begin() +
                              static_cast<std::ptrdiff_t>(row * columns_ + columnAt(crossings[row][i])),
                          inside_.begin() +
                              static_cast<std::ptrdiff_t>(row * columns_ + columnAt(crossings[row][i + 1])),
                          true);
            }
        }
    }

    bool contains(Point point) const {
        const double column = (point.x - box_.min.x) / cellM_;
        const double row = (point.y - box_.min.y) / cellM_;
        return column >= 0.0 && row >= 0.0 && column < static_cast<double>(columns_) &&
               row < static_cast<double>(rows_) &&
               inside_[static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column)];
    }

private:
    Bounds box_;
    double cellM_ = 1.0;
    std::size_t columns_ = 0;
    std::size_t rows_ = 0;
    std::vector<bool> inside_;
};

}  // namespace

Result<TravelCost> travelRule(Traversal rule, const TravelTask& task, const JobContext& job) {
    if (rule == Traversal::Interior) {
        return TravelCost{};
    }
    const bool headland = rule == Traversal::Headland;
    const Length room =
        headland ? task.machine.minTurningRadius() + 0.5 * task.machine.turningWidth()
                 : task.margin + 1.5 * std::max(task.machine.operatingWidth(), task.machine.turningWidth());
    return eroded(headland ? task.mainland : task.workable, room, kTolerance, job)
        .transform([](const MultiPolygon& dear) -> TravelCost {
            if (dear.empty()) {
                return {};
            }
            return [raster = std::make_shared<const Raster>(dear)](Point point) {
                return raster->contains(point) ? kDear : 1.0;
            };
        });
}

}  // namespace furrow
