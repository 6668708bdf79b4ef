#include "planner/audit/tank.h"

#include "planner/audit/length.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace furrow {

namespace {

// Of a tank: chords are shorter than bends, and drawing moves the ends of passes by centimetres.
constexpr double kSameLevel = 0.005;
constexpr double kSameTimeS = 1e-3;

class TankMeter {
public:
    TankMeter(const AuditInput& input, const Tank& tank)
        : input_{input},
          tank_{tank},
          perMetre_{tank.ratePerM2 * input.machine->spec().implement.operatingWidth.si()} {}

    TankReport measure() {
        for (std::size_t i = 0; i < input_.segments.size(); ++i) {
            const PathSegment& segment = input_.segments[i];
            if (i > 0) {
                stopBetween(input_.segments[i - 1], segment, i);
            }
            for (std::size_t k = 0; k < segment.samples.size(); ++k) {
                if (segment.implementDown && k > 0) {
                    work(segment.samples[k - 1], segment.samples[k], i);
                }
                compare(segment.samples[k], i);
            }
        }
        return report_;
    }

private:
    /// Where the stated level changes from one segment to the next, the tank is filled or the bunker emptied.
    void stopBetween(const PathSegment& before, const PathSegment& next, std::size_t index) {
        const PathSample& from = before.samples.back();
        const PathSample& to = next.samples.front();
        const bool changes = from.level && to.level && *from.level != *to.level;
        if (!changes && !before.refills) {
            return;
        }
        used_ = 0.0;
        double nearestM = std::numeric_limits<double>::infinity();
        for (const Point& point : input_.tank->points) {
            nearestM = std::min(nearestM, lengthOf(point - from.position));
        }
        if (nearestM > input_.tank->reach.si() + kEasedM) {
            report_.away.add(nearestM, from.position, index);
        }
        const bool stands = std::max(from.speedMps, to.speedMps) <= kStandingMps;
        const double missingS = tank_.fillTime().si() - (stands ? to.tS - from.tS : 0.0);
        if (input_.statedMotion && missingS > kSameTimeS) {
            report_.standing.add(missingS, from.position, index);
        }
    }

    void work(const PathSample& from, const PathSample& to, std::size_t index) {
        const double wayM = lengthOf(to.position - from.position);
        used_ += perMetre_ * wayM;
        const double beyond = used_ / tank_.capacity - 1.0;
        if (beyond > kSameLevel) {
            report_.beyond.add(beyond, from.position, index);
            report_.beyondM += std::min(wayM, beyond * tank_.capacity / perMetre_);
        }
    }

    void compare(const PathSample& sample, std::size_t index) {
        const double held = std::clamp(used_ / tank_.capacity, 0.0, 1.0);
        const double level = input_.tank->gathers ? held : 1.0 - held;
        const double stated = sample.level ? *sample.level / tank_.capacity : -1.0;
        const double differs = std::abs(stated - level);
        if (!(differs <= kSameLevel)) {
            report_.mismatch.add(differs, sample.position, index);
        }
    }

    // The path is eased by less than this.
    static constexpr double kEasedM = 0.5;

    const AuditInput& input_;
    const Tank& tank_;
    double perMetre_;
    double used_ = 0.0;
    TankReport report_;
};

}  // namespace

TankReport measureTank(const AuditInput& input) {
    const bool isKnown = input.tank && input.machine && input.machine->spec().tank &&
                         input.machine->spec().tank->capacity > 0.0;
    return isKnown ? TankMeter{input, *input.machine->spec().tank}.measure() : TankReport{};
}

}  // namespace furrow
