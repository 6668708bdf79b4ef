#include "planner/plan/gate_legs.h"

#include <algorithm>
#include <utility>

namespace furrow {

GateWays addGateWays(std::vector<Leg>& legs, const RouteEnds& places, const Field& field, const Rig& rig) {
    GateWays gates;
    const auto nameOfPlace = [](const RoutePlace& place) {
        return place.gate && !place.gate->name.empty() ? Message{place.gate->name} : Message{"this place"};
    };
    const auto tell = [&](const RoutePlace& place, Message text) {
        gates.findings.push_back(
            {.severity = Severity::Blocking,
             .kind = FindingKind::Gate,
             .place = place.position,
             .text = std::move(text),
             .suggestion = place.gate ? "Make the gate wider, or take another." : "Choose another place."});
    };
    const Length width = rig.machine().transportWidth();
    const auto isNarrow = [&](const RoutePlace& place) {
        return place.gate && place.gate->width > Length{} && place.gate->width < width;
    };
    for (const auto& place : places) {
        const bool isSaid = place && std::ranges::contains(gates.findings, place->position, &Finding::place);
        if (place && isNarrow(*place) && !isSaid) {
            tell(*place, message("{} is {:.2f} m wide; this machine is {:.2f} m wide for transport.",
                                 nameOfPlace(*place).capitalised(), place->gate->width.si(), width.si()));
        }
    }
    if (const auto& start = places[0]) {
        if (const auto in = wayIn(*start, field, rig, legs.front().line.start.position)) {
            gates.in = in->line.end();
            legs.insert(legs.begin(), *in);
        } else {
            tell(*start, message("The machine does not get in at {}.", nameOfPlace(*start)));
        }
    }
    if (const auto& end = places[1]) {
        if (const auto out = wayOut(*end, field, rig, legs.back().line.end().position)) {
            gates.out = out->line.start;
            legs.push_back(*out);
        } else {
            tell(*end, message("The machine does not get out at {}.", nameOfPlace(*end)));
        }
    }
    return gates;
}

}  // namespace furrow
