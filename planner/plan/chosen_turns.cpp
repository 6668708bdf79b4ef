#include "planner/plan/chosen_turns.h"

#include "planner/plan/method_registry.h"
#include "planner/turns/best_feasible.h"
#include "planner/turns/connection.h"
#include "planner/turns/continuous_curvature.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace furrow {

namespace {

constexpr std::array kSmooth{&kContinuousDubinsMethod, &kContinuousReedsSheppMethod};

Message whyNot(const Method<TurnPlanner>& kind, const Machine& machine, int outside, int impossible) {
    if (!canReverse(machine) && kind.traits.reverses) {
        return "This machine cannot reverse.";
    }
    if (impossible == 0) {
        return "There the chosen one does not fit into the field.";
    }
    return outside == 0
               ? "The chosen one cannot be driven between these swaths."
               : "There the chosen one does not fit into the field or cannot be driven between these swaths.";
}

}  // namespace

std::vector<std::vector<std::size_t>> turnCells(const Settings& settings, const Decomposition& cells) {
    std::vector<std::vector<std::size_t>> swaths;
    if (!turnMethod(settings).traits.isAnyKind) {
        std::ranges::transform(cells.cells, std::back_inserter(swaths), &Cell::swaths);
    }
    return swaths;
}

ChosenTurns::ChosenTurns(const Settings& settings, const SwathSet& swaths, const Decomposition& cells,
                         const FittingWays& ways)
    : kind_{turnMethod(settings)}, ways_{ways} {
    const auto ofCells = turnCells(settings, cells);
    for (std::size_t cell = 0; cell < ofCells.size(); ++cell) {
        for (const std::size_t swath : ofCells[cell]) {
            cellOfSwath_[swaths.swaths[swath].number] = cell;
        }
    }
}

bool ChosenTurns::belongsBetween(const Leg& leaving, const Leg& arriving) const {
    if (leaving.kind != SegmentKind::Swath || arriving.kind != SegmentKind::Swath) {
        return false;
    }
    const auto from = cellOfSwath_.find(leaving.number);
    const auto to = cellOfSwath_.find(arriving.number);
    return from != cellOfSwath_.end() && to != cellOfSwath_.end() && from->second == to->second;
}

std::optional<Curve> ChosenTurns::fitting(const Method<TurnPlanner>& kind, const Leg& leaving,
                                          const Leg& arriving) const {
    return ways_.byOne(kind, leaving.line.end(), arriving.line.start);
}

std::optional<Curve> ChosenTurns::between(const Leg& leaving, const Leg& arriving) const {
    if (kind_.traits.isAnyKind) {
        return std::nullopt;
    }
    const bool isSmooth = kind_.traits.isSmooth;
    std::optional<Curve> turn;
    if (isSmooth || belongsBetween(leaving, arriving)) {
        turn = fitting(kind_, leaving, arriving);
    }
    for (auto other = kSmooth.begin(); isSmooth && !turn && other != kSmooth.end(); ++other) {
        turn = fitting(**other, leaving, arriving);
    }
    return turn;
}

std::optional<Curve> ChosenTurns::anywhere(const Leg& leaving, const Leg& arriving) const {
    const Rig& rig = ways_.rig();
    Curve turn = connection(leaving.line.end(), arriving.line.start, rig.machine(), kind_.run);
    return rig.driven(Rig::inLine(turn.start), turn) ? std::optional{std::move(turn)} : std::nullopt;
}

std::optional<Finding> ChosenTurns::told(std::span<const Leg> legs) const {
    if (kind_.traits.isAnyKind) {
        return std::nullopt;
    }
    int all = 0;
    int outside = 0;
    int impossible = 0;
    std::optional<Point> place;
    for (std::size_t i = 0; i + 1 < legs.size(); ++i) {
        if (!belongsBetween(legs[i], legs[i + 1])) {
            continue;
        }
        ++all;
        if (fitting(kind_, legs[i], legs[i + 1])) {
            continue;
        }
        const Pose leaving = legs[i].line.end();
        const bool isOfKind =
            connection(leaving, legs[i + 1].line.start, ways_.rig().machine(), kind_.run).type ==
            kind_.info.id;
        ++(isOfKind ? outside : impossible);
        place = place.value_or(leaving.position);
    }
    if (!place) {
        return std::nullopt;
    }
    return Finding{
        .severity = Severity::Note,
        .kind = FindingKind::TurnKind,
        .place = *place,
        .text =
            message("Turns between swaths that are of another kind than chosen (path.method): {} of {}. {}",
                    outside + impossible, all, whyNot(kind_, ways_.rig().machine(), outside, impossible)),
        .suggestion = "Choose the best that fits, which takes the quickest everywhere.",
        .change = SettingChange{"path.method", std::string{kBestFeasibleMethod.info.id}}};
}

}  // namespace furrow
