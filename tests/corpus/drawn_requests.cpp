#include "tests/corpus/drawn_requests.h"

#include "planner/geodesy/local_frame.h"
#include "planner/geometry/polygon.h"
#include "planner/machine/machine_keys.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/method_registry.h"
#include "tests/support/field_generator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <format>
#include <numbers>

namespace furrow::test {

namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr std::uint64_t kComparing = 16;

class Draw {
public:
    Draw(std::uint64_t seed, std::span<const std::uint8_t> decisions)
        : random_{seed}, decisions_{decisions} {}

    double between(double low, double high) {
        if (decisions_.size() < 2) {
            return uniform(random_, low, high);
        }
        const double share = (256.0 * decisions_[0] + decisions_[1]) / 65536.0;
        decisions_ = decisions_.subspan(2);
        return low + share * (high - low);
    }
    /// Each order of magnitude is as likely as another.
    double scaled(double low, double high) { return low * std::pow(high / low, between(0.0, 1.0)); }
    bool chance(double share) { return between(0.0, 1.0) < share; }
    /// Below `count`, which is not 0.
    std::size_t index(std::size_t count) {
        return std::min(count - 1, static_cast<std::size_t>(between(0.0, static_cast<double>(count))));
    }
    std::mt19937_64& random() { return random_; }

private:
    std::mt19937_64 random_;
    std::span<const std::uint8_t> decisions_;
};

/// Spikes all round, down to slits of millimetres.
Ring spikyRing(Draw& draw, double radiusM) {
    const std::size_t count = 6 + 2 * draw.index(60);
    const double inner = draw.between(0.2, 0.98);
    Ring ring;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = kTwoPi * static_cast<double>(i) / static_cast<double>(count);
        ring.push_back((i % 2 == 0 ? 1.0 : inner) * radiusM * direction(angle));
    }
    return ring;
}

Ring combRing(Draw& draw, double radiusM) {
    const std::size_t teeth = 2 + draw.index(25);
    const double step = 2.0 * radiusM / static_cast<double>(teeth);
    const double body = draw.between(0.05, 0.5) * radiusM;
    const double depth = draw.between(0.05, 1.0) * radiusM;
    const double share = draw.between(0.02, 0.49);
    Ring ring{{0.0, 0.0}, {2.0 * radiusM, 0.0}};
    for (std::size_t i = teeth; i-- > 0;) {
        const double x = static_cast<double>(i) * step;
        ring.push_back({x + (1.0 - 0.5 * share) * step, body});
        ring.push_back({x + 0.75 * step, body + depth});
        ring.push_back({x + 0.25 * step, body + depth});
        ring.push_back({x + 0.5 * share * step, body});
    }
    return ring;
}

/// Holes side by side in a square, which may touch each other and the edge.
Polygon sieve(Draw& draw, double radiusM, std::size_t mostAcross) {
    Polygon polygon = rectangle(2.0 * radiusM, 2.0 * radiusM);
    const std::size_t across = 1 + draw.index(mostAcross);
    const double step = 2.0 * radiusM / static_cast<double>(across);
    const std::array shares{0.02, 0.3, 0.9, 1.0, 1.02};
    const double size = shares[draw.index(shares.size())] * step;
    for (std::size_t i = 0; i < across * across; ++i) {
        const std::size_t row = i / across;
        const Point low{(static_cast<double>(i % across) + 0.5) * step - 0.5 * size,
                        (static_cast<double>(row) + 0.5) * step - 0.5 * size};
        Ring hole = rectangle(size, size, low).outer;
        std::ranges::reverse(hole);
        polygon.holes.push_back(std::move(hole));
    }
    return polygon;
}

MultiPolygon shape(Draw& draw, DrawnSize size, std::string& told) {
    const bool isSmall = size == DrawnSize::Small;
    const double mostM = draw.chance(0.1) ? 1500.0 : 150.0;
    const double radiusM = isSmall ? draw.scaled(8.0, 25.0) : draw.scaled(3.0, mostM);
    const std::size_t kind = draw.index(kShapes.size() + 4);
    told = std::format("kind {}, {:.1f} m", kind, radiusM);
    if (kind < kShapes.size()) {
        return randomPolygons(draw.random(), kShapes[kind], radiusM);
    }
    switch (kind - kShapes.size()) {
        case 0: return {{.outer = spikyRing(draw, radiusM), .holes = {}}};
        case 1: return {{.outer = combRing(draw, radiusM), .holes = {}}};
        case 2: return {sieve(draw, radiusM, isSmall ? 2 : 6)};
        default: {
            MultiPolygon parts;
            const std::size_t count = 2 + draw.index(isSmall ? 2 : 12);
            const double gapM = draw.chance(0.5) ? 0.0 : draw.scaled(1e-3, 10.0);
            for (std::size_t i = 0; i < count; ++i) {
                parts.push_back(
                    rectangle(radiusM, radiusM, {static_cast<double>(i) * (radiusM + gapM), 0.0}));
            }
            return parts;
        }
    }
}

Ring& anyRing(Draw& draw, MultiPolygon& polygons) {
    Polygon& polygon = polygons[draw.index(polygons.size())];
    return polygon.holes.empty() || draw.chance(0.6) ? polygon.outer
                                                     : polygon.holes[draw.index(polygon.holes.size())];
}

/// One thing that people, programs and receivers get wrong.
void damage(Draw& draw, MultiPolygon& polygons, std::string& told) {
    Ring& ring = anyRing(draw, polygons);
    const std::size_t i = draw.index(ring.size());
    const auto at = ring.begin() + static_cast<std::ptrdiff_t>(i);
    const Point here = ring[i];
    const Point next = ring[(i + 1) % ring.size()];
    const std::size_t kind = draw.index(8);
    told += std::format(", damage {}", kind);
    switch (kind) {
        case 0: ring.insert(at, 1 + draw.index(4), here); return;
        case 1:
            ring.insert(at, here + draw.scaled(1e-9, 1e-2) * direction(draw.between(0.0, kTwoPi)));
            return;
        case 2: {  // a spike, out and back
            const Point tip = here + draw.scaled(0.1, 50.0) * direction(draw.between(0.0, kTwoPi));
            const Point aside{draw.chance(0.5) ? 0.0 : draw.scaled(1e-6, 0.1), 0.0};
            ring.insert(at, {here, tip, tip + aside});
            return;
        }
        case 3: ring[i] = ring[draw.index(ring.size())]; return;
        case 4: std::swap(ring[i], ring[draw.index(ring.size())]); return;
        case 5: ring[i] = here + draw.scaled(1e-3, 100.0) * direction(draw.between(0.0, kTwoPi)); return;
        case 6: {  // a sliver beside an edge
            const Point along = next - here;
            const Point across{-along.y, along.x};
            const double thin = draw.scaled(1e-7, 1e-2);
            polygons.push_back(
                {.outer = {here, next, next + thin * across, here + thin * across}, .holes = {}});
            return;
        }
        default: {  // many points on one edge
            const std::size_t count = 2 + draw.index(200);
            Ring between;
            for (std::size_t k = 1; k < count; ++k) {
                between.push_back(here +
                                  (static_cast<double>(k) / static_cast<double>(count)) * (next - here));
            }
            ring.insert(at + 1, between.begin(), between.end());
        }
    }
}

GeoPoint centre(Draw& draw) {
    constexpr std::array<GeoPoint, 5> kSpecial{
        {{179.9999, -17.0}, {-180.0, 66.0}, {25.0, 79.9}, {-70.0, -54.0}, {0.0, 0.0}}};
    return draw.chance(0.2) ? kSpecial[draw.index(kSpecial.size())]
                            : GeoPoint{draw.between(-179.0, 179.0), draw.between(-60.0, 70.0)};
}

FieldSource fieldSource(Draw& draw, DrawnSize size, std::string& told) {
    MultiPolygon polygons = shape(draw, size, told);
    if (draw.chance(0.4)) {
        for (std::size_t i = 1 + draw.index(2); i > 0; --i) {
            damage(draw, polygons, told);
        }
    }
    FieldSource source = fieldSourceFromLocal(polygons, centre(draw));
    const auto frame = LocalFrame::centredOn(middleOf(source.parts));
    if (!frame) {
        return source;
    }
    const double radiusM = 0.5 * std::max(bounds(polygons).width(), bounds(polygons).height());
    for (std::size_t i = draw.chance(0.4) ? draw.index(6) : 0; i > 0; --i) {
        const Point middle = draw.between(0.0, 0.9) * radiusM * direction(draw.between(0.0, kTwoPi));
        const double longM = draw.scaled(0.1, std::max(0.2, radiusM));
        const auto outline = moved({centredRectangle(longM, longM * draw.scaled(0.01, 1.0))},
                                   radians(draw.between(0.0, kTwoPi)), middle);
        source.obstacles.push_back({.name = std::format("O{}", i),
                                    .outline = frame->toGeo(outline.front()),
                                    .passable = draw.chance(0.3),
                                    .buffer = metres(draw.chance(0.5) ? 0.0 : draw.scaled(0.01, 5.0))});
    }
    if (draw.chance(0.2)) {
        source.gates.push_back({.name = "Gate",
                                .position = source.parts.front().outer.front(),
                                .width = metres(draw.scaled(0.5, 20.0))});
    }
    source.boundaryAccuracy = metres(draw.chance(0.8) ? 0.0 : draw.scaled(0.01, 3.0));
    return source;
}

MachineSpec machineSpec(Draw& draw, std::string& told) {
    MachineSpec spec = machineLibrary()[draw.index(machineLibrary().size())].spec();
    told += "; " + spec.id;
    if (draw.chance(0.5)) {
        return spec;
    }
    const auto keys = machineKeys();
    for (std::size_t i = 1 + draw.index(5); i > 0; --i) {
        const MachineKey& key = keys[draw.index(keys.size())];
        if (key.kind == MachineKeyKind::Flag) {
            key.set(spec, draw.chance(0.5));
        } else if (key.kind == MachineKeyKind::Number) {
            // Two of three as real machines have it.
            const bool isUsual = draw.chance(0.67);
            const double number = draw.between(isUsual ? key.min : key.least, isUsual ? key.max : key.most);
            key.set(spec, number);
            told += std::format(" {}={:.4g}", key.key, number);
        }
    }
    return spec;
}

std::string point(Draw& draw, const FieldSource& field) {
    const GeoRing& ring = field.parts.front().outer;
    const GeoPoint near = ring[draw.index(ring.size())];
    const double away = draw.chance(0.9) ? draw.scaled(1e-7, 1e-2) : draw.scaled(1e-2, 10.0);
    return std::format("{:.9f} {:.9f}", near.lonDeg + draw.between(-away, away),
                       std::clamp(near.latDeg + draw.between(-away, away), -89.0, 89.0));
}

std::string line(Draw& draw, const FieldSource& field) {
    std::string text = "LINESTRING (";
    for (std::size_t i = 0, count = 2 + (draw.chance(0.5) ? 0 : draw.index(8)); i < count; ++i) {
        text += (i == 0 ? "" : ", ") + point(draw, field);
    }
    return text + ")";
}

std::string numbers(Draw& draw) {
    std::string text;
    for (std::size_t i = 0, count = 1 + draw.index(6); i < count; ++i) {
        text += std::format("{}{}{}", i == 0 ? "" : ",", draw.chance(0.3) ? "-" : "", 1 + draw.index(12));
    }
    return text;
}

std::string valueOf(Draw& draw, const Parameter& parameter, const FieldSource& field) {
    switch (parameter.kind) {
        case ParameterKind::Choice:
            return std::string{parameter.choices[draw.index(parameter.choices.size())].id};
        case ParameterKind::Flag: return draw.chance(0.5) ? "true" : "false";
        case ParameterKind::Line:
            return draw.chance(0.3) ? "POINT (" + point(draw, field) + ")" : line(draw, field);
        case ParameterKind::Lines: return line(draw, field);
        case ParameterKind::File: return "/no/such/file";
        case ParameterKind::Place:
        case ParameterKind::Places: return draw.chance(0.3) ? "Gate" : "POINT (" + point(draw, field) + ")";
        case ParameterKind::Numbers: return numbers(draw);
        default: break;
    }
    if (parameter.canBeAuto && draw.chance(0.2)) {
        return "auto";
    }
    // Most near the least one: ranges are wide.
    const double most =
        draw.chance(0.7) ? std::min(parameter.max, parameter.min + 20.0 * parameter.step) : parameter.max;
    const double number = draw.chance(0.1) ? parameter.max : draw.between(parameter.min, most);
    return parameter.kind == ParameterKind::Count ? std::format("{}", std::round(number))
                                                  : std::format("{:.6g}", number);
}

Settings settings(Draw& draw, const FieldSource& field, DrawnRequest& drawn) {
    Settings all;
    if (draw.chance(0.25)) {
        return all;
    }
    const auto parameters = allParameters();
    const bool areMany = draw.chance(0.2);
    for (std::size_t i = areMany ? 10 + draw.index(20) : 1 + draw.index(5); i > 0; --i) {
        const Parameter& parameter = *parameters[draw.index(parameters.size())];
        // Files are read before a plan is made.
        if (parameter.kind == ParameterKind::File) {
            continue;
        }
        const std::string text = valueOf(draw, parameter, field);
        if (auto set = applySetting(all, parameter.key, text); !set) {
            drawn.refused.push_back(set.error());
        } else {
            drawn.told += std::format(" --set '{}={}'", parameter.key, text);
        }
    }
    return all;
}

DrawnRequest drawnRequest(std::uint64_t seed, DrawnSize size, std::span<const std::uint8_t> decisions) {
    Draw draw{seed, decisions};
    DrawnRequest drawn;
    drawn.field = fieldSource(draw, size, drawn.told);
    drawn.field.name = std::format("Seed {}", seed);
    drawn.machine = machineSpec(draw, drawn.told);
    drawn.told += ";";
    drawn.settings = settings(draw, drawn.field, drawn);
    return drawn;
}

}  // namespace

DrawnRequest drawnRequest(std::uint64_t seed, DrawnSize size) {
    return drawnRequest(seed, size, {});
}

DrawnRequest chosenRequest(std::span<const std::uint8_t> bytes) {
    std::uint64_t seed = 0;
    const std::size_t seedSize = std::min(sizeof(seed), bytes.size());
    for (const std::uint8_t byte : bytes.first(seedSize)) {
        seed = 256 * seed + byte;
    }
    DrawnRequest drawn = drawnRequest(seed, DrawnSize::Small, bytes.subspan(seedSize));
    if (seed % kComparing != 0) {
        drawn.settings.set(kCompare, "blocked").value();
    }
    return drawn;
}

}  // namespace furrow::test
