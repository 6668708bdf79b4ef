#pragma once

#include "planner/route/link_costs.h"
#include "tests/support/field_generator.h"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace furrow::test {

/// A straight track beside others, in metres.
struct Track {
    double x = 0.0;
    double low = 0.0;
    double high = 0.0;
};

enum class TurnKind {
    BulbOrU,       ///< omega with reverse gear, Bakhtiari et al. 2011
    ForwardOmega,  ///< and U turns
};

/// The length of a turn between tracks, as in Bakhtiari et al. 2011.
inline double turnLength(double apart, double radius, TurnKind kind) {
    const double pi = std::numbers::pi;
    if (apart >= 2.0 * radius) {
        return apart + (pi - 2.0) * radius;
    }
    return kind == TurnKind::BulbOrU
               ? radius * (2.0 + pi) - apart
               : radius * (3.0 * pi - 4.0 * std::asin((2.0 * radius + apart) / (4.0 * radius)));
}

/// Turns between neighbouring ends, with the difference of the ends driven straight. A machine that leaves a
/// track at one side cannot enter another one at the other side for less than some hundred metres.
/// @param slope  added in one direction and taken off in the other
inline LinkCosts trackCosts(const std::vector<Track>& tracks, double radius, TurnKind kind,
                            double slope = 0.0) {
    const auto link = [=](SwathEnd leaving, SwathEnd entered) {
        const Track& from = tracks[leaving / 2];
        const Track& to = tracks[entered / 2];
        const double fromY = leaving % 2 == 1 ? from.high : from.low;
        const double toY = entered % 2 == 1 ? to.high : to.low;
        const double across = leaving % 2 == entered % 2 ? 0.0 : 400.0;
        return turnLength(std::abs(from.x - to.x), radius, kind) + std::abs(fromY - toY) + across +
               (to.x > from.x ? slope : -slope);
    };
    return LinkCosts{tracks.size(), {.link = link, .atLeast = {}, .begin = {}, .finish = {}, .fitting = {}}};
}

/// 10 equal tracks 4.5 m apart.
inline std::vector<Track> fieldA() {
    std::vector<Track> tracks;
    tracks.reserve(10);
    for (int i = 0; i < 10; ++i) {
        tracks.push_back({4.5 * i, 0.0, 100.0});
    }
    return tracks;
}

/// 18 tracks that get shorter after 45 m.
inline std::vector<Track> fieldB() {
    std::vector<Track> tracks;
    for (int i = 0; i < 18; ++i) {
        const double x = 4.5 * i + 2.25;
        tracks.push_back({x, 0.0, x <= 45.0 ? 130.0 : 130.0 - 30.0 * (x - 45.0) / 36.0});
    }
    return tracks;
}

inline std::vector<Track> randomTracks(std::mt19937_64& random, std::size_t count, double width) {
    const double slopeLow = uniform(random, -1.0, 1.0);
    const double slopeHigh = uniform(random, -1.0, 1.0);
    const double ragged = uniform(random, 0.0, 10.0);
    std::vector<Track> tracks;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = width * static_cast<double>(i);
        tracks.push_back({x, slopeLow * x + uniform(random, -ragged, ragged),
                          300.0 + slopeHigh * x + uniform(random, -ragged, ragged)});
    }
    return tracks;
}

/// To and fro.
inline EndOrder plainOrder(std::size_t count) {
    EndOrder order;
    for (std::size_t i = 0; i < count; ++i) {
        order.push_back(static_cast<SwathEnd>(2 * i + i % 2));
    }
    return order;
}

}  // namespace furrow::test
