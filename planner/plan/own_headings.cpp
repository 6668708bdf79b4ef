#include "planner/plan/own_headings.h"

#include "planner/decomposition/cell_cost.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/plan/cell_stage.h"
#include "planner/plan/mainland_parts.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/swath_stage.h"
#include "planner/swaths/curved_swaths.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

namespace furrow {

namespace {

// A heading of its own has to save this share of the time in swaths of its cell: estimates are no better.
constexpr double kWorthwhile = 0.02;
// Headings that differ by less are one.
constexpr double kCommonDeg = 1.0;
// No time is worth more of the mainland than this, which is what measuring may be wrong by.
constexpr double kMostLost = 0.001;
// Pieces of a cell that are smaller, in squares of the operating width, are left to the neighbours' edges.
constexpr double kSmallPiece = 0.25;

/// A cell as the common heading has it.
struct CommonCell {
    std::size_t piece = 0;
    MultiPolygon outline;
    SwathSet swaths;
    MultiPolygon lanes;
};

/// One with a heading of its own.
struct OwnCell {
    MultiPolygon outline;
    SwathSet swaths;
};

MultiPolygon lanesOf(const SwathSet& set) {
    MultiPolygon lanes;
    for (const Swath& swath : set.swaths) {
        addStrips(lineOf(swath), swath.width, lanes);
    }
    return lanes;
}

void append(MultiPolygon& all, const MultiPolygon& more) {
    all.insert(all.end(), more.begin(), more.end());
}

class HeadingChooser {
public:
    HeadingChooser(const PlanRequest& request, const MultiPolygon& mainland, const SwathSet& common,
                   const std::vector<MultiPolygon>& pieces, const EndsDrawnOut& withEnds,
                   const JobContext& job)
        : request_{request},
          mainland_{mainland},
          common_{common},
          pieces_{pieces},
          withEnds_{withEnds},
          job_{job} {}

    Result<LaidSwaths> chosen() {
        if (auto divided = divide(); !divided) {
            return std::unexpected(divided.error());
        }
        if (cells_.size() < 2) {
            PartCollector collector{common_, mainland_};
            collector.add(mainland_, common_, {});
            return collector.take();
        }
        isOwn_.assign(cells_.size(), false);
        auto best = laid();
        auto estimate = best.and_then([&](const LaidSwaths& now) { return estimated(now); });
        if (!estimate) {
            return std::unexpected(estimate.error());
        }
        for (const std::size_t cell : largestFirst()) {
            auto with = tried(cell, *estimate);
            if (!with) {
                return std::unexpected(with.error());
            }
            if (*with) {
                best = std::move(**with);
            }
        }
        return best;
    }

private:
    Result<void> divide() {
        for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
            const SwathSet inside = pieces_.size() == 1 ? common_ : cutTo(common_, pieces_[piece]);
            const auto cells = decompositionMethod(request_.settings)
                                   .run({.mainland = pieces_[piece],
                                         .swaths = inside,
                                         .machine = request_.machine,
                                         .settings = request_.settings},
                                        job_);
            if (!cells) {
                return std::unexpected(cells.error());
            }
            for (const Cell& cell : cells->cells) {
                CommonCell made{.piece = piece, .outline = cell.outline, .swaths = inside, .lanes = {}};
                made.swaths.swaths.clear();
                for (const std::size_t index : cell.swaths) {
                    made.swaths.swaths.push_back(inside.swaths[index]);
                }
                made.lanes = lanesOf(made.swaths);
                cells_.push_back(std::move(made));
            }
        }
        return {};
    }

    std::vector<std::size_t> largestFirst() const {
        std::vector<std::size_t> order(cells_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, std::ranges::greater{},
                                 [this](std::size_t cell) { return area(cells_[cell].outline); });
        return order;
    }

    /// How long swaths take, and how much of the mainland they cover with their ends.
    struct Estimate {
        Duration time;
        double coverage = 0.0;
    };

    /// With a heading of its own for one more cell; nothing where that is not worth it. `before` becomes that
    /// of what is kept.
    Result<std::optional<LaidSwaths>> tried(std::size_t cell, Estimate& before) {
        if (cells_[cell].swaths.swaths.empty()) {
            return std::optional<LaidSwaths>{};
        }
        auto land = landOf(cell);
        if (!land) {
            return std::unexpected(land.error());
        }
        auto swaths = land->empty() ? Result<SwathSet>{} : swathsByMethod(request_, *land, job_);
        if (!swaths && swaths.error().code == ErrorCode::Cancelled) {
            return std::unexpected(swaths.error());
        }
        if (!swaths || swaths->swaths.empty() || isCommon(swaths->heading)) {
            return std::optional<LaidSwaths>{};
        }
        const Duration working =
            seconds(lengthM(cells_[cell].swaths) / request_.machine.spec().tractor.workingSpeed.si());
        isOwn_[cell] = true;
        own_.push_back({std::move(*land), std::move(*swaths)});
        auto with = laid();
        const auto takes = with.and_then([&](const LaidSwaths& now) { return estimated(now); });
        if (!takes) {
            return std::unexpected(takes.error());
        }
        if (takes->time < before.time - kWorthwhile * working &&
            takes->coverage > before.coverage - kMostLost) {
            before = *takes;
            return std::optional{std::move(*with)};
        }
        isOwn_[cell] = false;
        own_.pop_back();
        return std::optional<LaidSwaths>{};
    }

    bool isCommon(Angle heading) const {
        return inDegrees(angleBetweenLines(heading, common_.heading)) < kCommonDeg;
    }

    static double lengthM(const SwathSet& set) {
        return std::accumulate(set.swaths.begin(), set.swaths.end(), 0.0,
                               [](double sum, const Swath& swath) { return sum + swath.length().si(); });
    }

    /// What a cell and its lanes take, and no other swaths.
    Result<MultiPolygon> landOf(std::size_t cell) const {
        MultiPolygon wanted = cells_[cell].outline;
        append(wanted, cells_[cell].lanes);
        MultiPolygon others;
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            if (i != cell && !isOwn_[i]) {
                append(others, cells_[i].lanes);
            }
        }
        for (const OwnCell& own : own_) {
            append(others, own.outline);
        }
        return unionOf(wanted, job_, kSnapGrid)
            .and_then([&](const MultiPolygon& all) { return intersection(all, mainland_, job_, kSnapGrid); })
            .and_then([&](const MultiPolygon& all) -> Result<MultiPolygon> {
                if (others.empty()) {
                    return all;
                }
                return unionOf(others, job_, kSnapGrid).and_then([&](const MultiPolygon& taken) {
                    return difference(all, taken, job_, kSnapGrid);
                });
            })
            .transform([this](MultiPolygon land) {
                const double widthM = request_.machine.operatingWidth().si();
                std::erase_if(land, [&](const Polygon& piece) {
                    return area(piece).si() < kSmallPiece * widthM * widthM;
                });
                return land;
            });
    }

    Result<LaidSwaths> laid() const {
        PartCollector collector{common_, mainland_};
        MultiPolygon taken;
        for (const OwnCell& own : own_) {
            append(taken, own.outline);
        }
        const auto rest = [&](const MultiPolygon& polygons) {
            return taken.empty() || polygons.empty() ? Result<MultiPolygon>{polygons}
                                                     : difference(polygons, taken, job_, kSnapGrid);
        };
        for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
            auto outline = rest(pieces_[piece]);
            if (!outline) {
                return std::unexpected(outline.error());
            }
            if (SwathSet shared = sharedIn(piece); !shared.swaths.empty() || own_.empty()) {
                collector.add(std::move(*outline), std::move(shared), {});
            }
        }
        auto left = rest(common_.leftOnPurpose);
        if (!left) {
            return std::unexpected(left.error());
        }
        for (const OwnCell& own : own_) {
            collector.add(own.outline, own.swaths, own.swaths.heading);
            append(*left, own.swaths.leftOnPurpose);
        }
        LaidSwaths all = collector.take();
        all.swaths.leftOnPurpose = std::move(*left);
        if (own_.empty()) {
            return all;
        }
        const auto covered = coverageOf(all.swaths, mainland_, job_);
        if (!covered) {
            return std::unexpected(covered.error());
        }
        all.swaths.coverage = covered->share;
        all.swaths.overlap = covered->overlap;
        all.swaths.proved = false;
        return all;
    }

    /// The swaths of a piece whose cells keep the common heading.
    SwathSet sharedIn(std::size_t piece) const {
        SwathSet set = common_;
        set.swaths.clear();
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            if (cells_[i].piece == piece && !isOwn_[i]) {
                std::ranges::copy(cells_[i].swaths.swaths, std::back_inserter(set.swaths));
            }
        }
        std::ranges::stable_sort(set.swaths, {}, &Swath::number);
        return set;
    }

    Result<Estimate> estimated(const LaidSwaths& flat) const {
        const auto laid = withEnds_(flat);
        if (!laid) {
            return std::unexpected(laid.error());
        }
        const LaidSwaths& drawn = *laid;
        const auto cells = cellsOf(request_, drawn, job_);
        if (!cells) {
            return std::unexpected(cells.error());
        }
        std::vector<std::vector<std::size_t>> dealt;
        for (const Cell& cell : cells->cells) {
            dealt.push_back(cell.swaths);
        }
        Groups groups(dealt.size());
        std::iota(groups.begin(), groups.end(), std::size_t{0});
        const Duration turning = CellCost{drawn.swaths, request_.machine, std::move(dealt)}.of(groups);
        const Machine& machine = request_.machine;
        const auto covered = coverageOf(drawn.swaths, mainland_, job_);
        if (!covered) {
            return std::unexpected(covered.error());
        }
        const double missedM = (1.0 - covered->share) * area(mainland_).si() / machine.operatingWidth().si();
        const double workedM = drawn.swaths.totalLength.si() + kPiecemealFactor * missedM;
        return Estimate{.time = turning + seconds(workedM / machine.spec().tractor.workingSpeed.si()),
                        .coverage = covered->share};
    }

    const PlanRequest& request_;
    const MultiPolygon& mainland_;
    const SwathSet& common_;
    const std::vector<MultiPolygon>& pieces_;
    const EndsDrawnOut& withEnds_;
    const JobContext& job_;
    std::vector<CommonCell> cells_;
    std::vector<bool> isOwn_;
    std::vector<OwnCell> own_;
};

}  // namespace

Result<LaidSwaths> withOwnHeadings(const PlanRequest& request, const MultiPolygon& mainland,
                                   const SwathSet& common, const std::vector<MultiPolygon>& pieces,
                                   const EndsDrawnOut& withEnds, const JobContext& job) {
    return HeadingChooser{request, mainland, common, pieces, withEnds, job}.chosen();
}

}  // namespace furrow
