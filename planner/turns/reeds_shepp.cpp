#include "planner/turns/reeds_shepp.h"

#include "planner/turns/dubins.h"
#include "planner/turns/turn_words.h"

namespace furrow {

namespace {

/// The length of an arc of radius 1 is its angle.
struct UnitArcs {
    double bound(double angle) const { return angle; }
    double length(double angle) const { return angle; }
};

words::Word shortestReedsSheppWord(const Pose& from, const Pose& to, Length radius) {
    words::TurnWordSearch<UnitArcs> search{words::goalSeenFrom(from, to, 1.0 / radius.si()), {}, {}};
    search.straightWords(1);
    search.straightWords(-1);
    search.threeTurnsWithCusps();
    search.straightWordsWithCusps();
    search.fourTurns();
    return search.best();
}

Curve runReedsShepp(const Pose& from, const Pose& to, const Machine& machine) {
    return canReverse(machine) ? reedsSheppTurn(from, to, machine.minTurningRadius())
                               : dubinsTurn(from, to, machine.minTurningRadius());
}

}  // namespace

Curve reedsSheppTurn(const Pose& from, const Pose& to, Length radius) {
    const words::Word word = shortestReedsSheppWord(from, to, radius);
    Curve turn{.type = "reeds-shepp", .start = from, .pieces = {}};
    turn.pieces.reserve(5);
    for (int i = 0; i < word.count; ++i) {
        const words::Part& part = word.parts[i];
        if (part.amount > words::kNoPart) {
            turn.pieces.push_back({.length = radius * part.amount,
                                   .curvature = Curvature::fromSi(part.side / radius.si()),
                                   .gear = part.gear > 0 ? Gear::Forward : Gear::Reverse});
        }
    }
    return turn;
}

Length reedsSheppLength(const Pose& from, const Pose& to, Length radius) {
    return radius * shortestReedsSheppWord(from, to, radius).length;
}

const Method<TurnPlanner> kReedsSheppMethod{
    .info = {.id = "reeds-shepp",
             .name = "Curves with reversing",
             .description = "The shortest curve forwards and backwards, at the smallest turning radius "
                            "(Reeds and Shepp).",
             .parameters = {}},
    .run = runReedsShepp,
    .traits = {.reverses = true}};

}  // namespace furrow
