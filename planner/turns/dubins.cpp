#include "planner/turns/dubins.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace furrow {

namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
// An arc this much short of a full circle is no arc that rounding turned into a circle.
constexpr double kFullCircleSlack = 1e-9;
// A piece shorter than this, in radii, is rounding: picometres.
constexpr double kNoPiece = 1e-12;

double positiveAngle(double angle) {
    const double rest = angle - kTwoPi * std::floor(angle / kTwoPi);
    return rest >= kTwoPi - kFullCircleSlack ? 0.0 : rest;
}

/// Three pieces: angles of arcs and, for the middle of the first four words, a length in radii.
struct Word {
    double first = 0.0;
    double middle = 0.0;
    double last = 0.0;
    // Left 1, straight 0, right -1.
    int turns[3] = {0, 0, 0};

    double length() const { return first + middle + last; }
};

/// The problem scaled to radius 1, with the goal on the x axis at distance d.
struct Scaled {
    double d, alpha, beta;
    double sinA, cosA, sinB, cosB, cosAB;
};

Scaled scaled(const Pose& from, const Pose& to, double radius) {
    const Point way = to.position - from.position;
    const double d = norm(way) / radius;
    // Where both positions are the same any axis will do.
    const double axis = d > 0.0 ? std::atan2(way.y, way.x) : 0.0;
    const double alpha = positiveAngle(from.heading.si() - axis);
    const double beta = positiveAngle(to.heading.si() - axis);
    return {d,
            alpha,
            beta,
            std::sin(alpha),
            std::cos(alpha),
            std::sin(beta),
            std::cos(beta),
            std::cos(alpha - beta)};
}

/// sqrt, taking what rounding pushed below zero for zero.
std::optional<double> root(double square) {
    if (square < -1e-12) {
        return std::nullopt;
    }
    return std::sqrt(std::max(0.0, square));
}

Word outerTangent(const Scaled& s, int side) {
    // Mirroring the plane turns RSR into LSL.
    const double k = side;
    const double middle =
        std::sqrt(std::max(0.0, 2.0 + s.d * s.d - 2.0 * s.cosAB + 2.0 * k * s.d * (s.sinA - s.sinB)));
    const double axis = std::atan2(k * (s.cosB - s.cosA), s.d + k * (s.sinA - s.sinB));
    return {positiveAngle(k * (axis - s.alpha)), middle, positiveAngle(k * (s.beta - axis)), {side, 0, side}};
}

std::optional<Word> innerTangent(const Scaled& s, int side) {
    const double k = side;
    const auto middle = root(-2.0 + s.d * s.d + 2.0 * s.cosAB + 2.0 * k * s.d * (s.sinA + s.sinB));
    if (!middle) {
        return std::nullopt;
    }
    const double axis =
        std::atan2(-k * (s.cosA + s.cosB), s.d + k * (s.sinA + s.sinB)) + k * std::atan2(2.0, *middle);
    return Word{
        positiveAngle(k * (axis - s.alpha)), *middle, positiveAngle(k * (axis - s.beta)), {side, 0, -side}};
}

std::optional<Word> threeArcs(const Scaled& s, int side) {
    const double k = side;
    const double cosine = (6.0 - s.d * s.d + 2.0 * s.cosAB - 2.0 * k * s.d * (s.sinA - s.sinB)) / 8.0;
    if (std::abs(cosine) > 1.0) {
        return std::nullopt;
    }
    const double middle = kTwoPi - std::acos(cosine);
    const double axis = std::atan2(k * (s.cosB - s.cosA), s.d + k * (s.sinA - s.sinB));
    const double first = positiveAngle(k * (axis - s.alpha) + 0.5 * middle);
    return Word{first, middle, positiveAngle(k * (s.beta - s.alpha) - first + middle), {side, -side, side}};
}

Word shortestWord(const Scaled& s) {
    Word best = outerTangent(s, 1);
    const auto consider = [&best](const std::optional<Word>& word) {
        if (word && word->length() < best.length()) {
            best = *word;
        }
    };
    consider(outerTangent(s, -1));
    for (const int side : {1, -1}) {
        consider(innerTangent(s, side));
        consider(threeArcs(s, side));
    }
    return best;
}

Turn runDubins(const Pose& from, const Pose& to, const Machine& machine) {
    return dubinsTurn(from, to, machine.minTurningRadius());
}

}  // namespace

Turn dubinsTurn(const Pose& from, const Pose& to, Length radius) {
    const Word word = shortestWord(scaled(from, to, radius.si()));
    Turn turn{.type = "dubins", .start = from, .pieces = {}};
    const double parts[] = {word.first, word.middle, word.last};
    for (int i = 0; i < 3; ++i) {
        if (parts[i] > kNoPiece) {
            turn.pieces.push_back(
                {.length = radius * parts[i], .curvature = Curvature::fromSi(word.turns[i] / radius.si())});
        }
    }
    return turn;
}

Length dubinsLength(const Pose& from, const Pose& to, Length radius) {
    return radius * shortestWord(scaled(from, to, radius.si())).length();
}

const Method<TurnPlanner> kDubinsMethod{
    .info = {.id = "dubins",
             .name = "Forward curves",
             .description = "The shortest curve without reversing, at the smallest turning radius (Dubins).",
             .parameters = {}},
    .run = runDubins};

}  // namespace furrow
