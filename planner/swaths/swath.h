#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"
#include "planner/settings/settings.h"

#include <optional>
#include <vector>

namespace furrow {

/// One pass of the implement: a straight line with a width.
struct Swath {
    Point start;
    Point end;
    int number = 0;  ///< as generated, from 1
    int track = 0;   ///< swaths cut from the same line share it; 0 is the rightmost seen along the heading
    Length width;

    Length length() const { return metres(distance(start, end)); }
    friend bool operator==(const Swath&, const Swath&) = default;
};

/// The swaths of one mainland and the figures of their heading.
struct SwathSet {
    std::vector<Swath> swaths;  ///< ordered by track, then along the heading
    Angle heading;              ///< modulo pi
    bool proved = false;        ///< nothing better exists for the objective
    Length totalLength;
    double coverage = 0.0;  ///< A_cov: covered share of the mainland, flat ends
    Area overlap;           ///< area inside the mainland covered at least twice
    Length shift;           ///< of the first track from half a width inside the mainland's edge
    int headingsTried = 1;
};

/// The common signature of all swath methods.
///
/// @param mainland  valid polygons in metres, holes allowed
/// @return at least one swath. InputRefused: the mainland is too narrow for any. Cancelled.
using SwathGenerator = Result<SwathSet>(const MultiPolygon& mainland, const Machine& machine,
                                        const Settings& settings, const JobContext& job);

}  // namespace furrow
