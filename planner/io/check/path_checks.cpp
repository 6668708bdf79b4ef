#include "planner/io/check/path_checks.h"

#include "planner/geometry/segment.h"
#include "planner/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace furrow {

namespace {

// Centimetres of a vehicle's own steps and of drawings in another projection.
constexpr double kOnPathM = 0.15;
constexpr double kLengthShare = 0.01;
constexpr double kLengthSlackM = 2.0;
constexpr double kSmallestStepM = 0.2;
// Half of what a chord of the coarsest table turns from its tangent.
constexpr double kAlongRad = 35.0 / 180.0 * std::numbers::pi;
constexpr double kSpeedShare = 0.1;
constexpr double kSpeedSlackMps = 0.1;

std::vector<Point> placesOf(const ReceivedPath& path, const Plan& plan) {
    std::vector<Point> places;
    places.reserve(path.samples.size());
    for (const ReceivedSample& sample : path.samples) {
        places.push_back(sample.isLocal ? sample.local : plan.field().frame().toLocal(sample.geo));
    }
    return places;
}

double lengthM(const std::vector<Point>& line) {
    double sum = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        sum += distance(line[i - 1], line[i]);
    }
    return sum;
}

std::vector<Point> linePlanned(const Plan& plan) {
    std::vector<Point> line;
    for (const PathSegment& segment : plan.path.segments) {
        for (const PathSample& sample : segment.samples) {
            line.push_back(sample.position);
        }
    }
    return line;
}

}  // namespace

std::optional<Message> pathFollowed(const ReceivedPath& path, const Plan& plan) {
    const std::vector<Point> places = placesOf(path, plan);
    const std::vector<Point> planned = linePlanned(plan);
    if (places.empty()) {
        return std::nullopt;
    }
    // The first edge from the last one on that a sample lies on is never behind the right one.
    std::size_t edge = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Point at = places[i];
        while (edge + 1 < planned.size() &&
               !(distanceToSegment(at, planned[edge], planned[edge + 1]) < kOnPathM)) {
            ++edge;
        }
        if (edge + 1 == planned.size()) {
            return message("place {} of the path is not where the plan goes next", i + 1);
        }
    }
    const bool ends = !path.isWhole || (distance(places.front(), planned.front()) < kOnPathM &&
                                        distance(places.back(), planned.back()) < kOnPathM);
    return ends ? std::nullopt : std::optional{Message{"the path does not begin and end as the plan does"}};
}

std::optional<Message> pathLength(const ReceivedPath& path, const Plan& plan) {
    const double writtenM = lengthM(placesOf(path, plan));
    const double plannedM = lengthM(linePlanned(plan));
    const bool right = std::abs(writtenM - plannedM) < kLengthShare * plannedM + kLengthSlackM;
    return !path.isWhole || right
               ? std::nullopt
               : std::optional{message("the path is {:.0f} m long, not {:.0f} m", writtenM, plannedM)};
}

std::optional<Message> pathTimes(const ReceivedPath& path, const Plan&) {
    std::optional<double> last;
    std::optional<double> first;
    for (std::size_t i = 0; i < path.samples.size(); ++i) {
        const std::optional<double> time = path.samples[i].timeS;
        if (!time) {
            continue;
        }
        if (last && *time < *last) {
            return message("the time of place {} of the path is before that of the place before", i + 1);
        }
        first = first.value_or(*time);
        last = time;
    }
    return first && path.samples.size() > 1 && *last == *first
               ? std::optional{Message{"the times of the path stand still"}}
               : std::nullopt;
}

std::optional<Message> pathHeadings(const ReceivedPath& path, const Plan& plan) {
    const std::vector<Point> places = placesOf(path, plan);
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const ReceivedSample& sample = path.samples[i];
        const Point step = places[i + 1] - places[i];
        if (!sample.headingRad || norm(step) < kSmallestStepM) {
            continue;
        }
        const double motion = std::atan2(step.y, step.x);
        const double nose = *sample.headingRad + (sample.reverse ? std::numbers::pi : 0.0);
        const double off = std::abs(std::remainder(motion - nose, 2.0 * std::numbers::pi));
        // Where nobody says which gear, backwards is right too.
        const bool along = off < kAlongRad || (!path.knowsGear && std::numbers::pi - off < kAlongRad);
        if (!along) {
            return message("the heading at place {} of the path does not point along it", i + 1);
        }
    }
    return std::nullopt;
}

std::optional<Message> pathSpeeds(const ReceivedPath& path, const Plan& plan) {
    double written = -1.0;
    for (std::size_t i = 0; i < path.samples.size(); ++i) {
        if (const auto speed = path.samples[i].speedMps) {
            if (*speed < 0.0) {
                return message("the speed at place {} of the path is negative", i + 1);
            }
            written = std::max(written, *speed);
        }
    }
    double planned = 0.0;
    for (const PathSegment& segment : plan.path.segments) {
        for (const PathSample& sample : segment.samples) {
            planned = std::max(planned, sample.speedMps);
        }
    }
    const bool right = std::abs(written - planned) < kSpeedShare * planned + kSpeedSlackMps;
    return written < 0.0 || !path.isWhole || right
               ? std::nullopt
               : std::optional{message("its largest speed is {:.2f} m/s, not {:.2f} m/s", written, planned)};
}

}  // namespace furrow
