#pragma once

#include "planner/core/result.h"
#include "planner/field/field.h"
#include "planner/geometry/curve.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"
#include "planner/settings/method.h"
#include "planner/settings/settings.h"
#include "planner/swaths/objective.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace furrow {

struct GuideData;

/// Largest distance of curved swaths from the chords that stand for them.
inline constexpr Length kSwathChord = metres(0.005);

/// One pass of the implement: a line with a width, most often straight along the heading of its set.
struct Swath {
    Point start;
    Point end;
    int number = 0;  ///< in the order of generation, from 1
    int track = 0;   ///< shared by swaths cut from the same line; 0 is the rightmost, seen along the heading
    Length width;
    /// Whole spacings to the left of the line that the swaths were laid by. Empty without such a line, or if
    /// the swath was moved to the edge.
    std::optional<int> lane = {};
    bool tramline = false;   ///< passes of a wider machine will later drive on it
    bool goesRound = false;  ///< leaves its track to pass obstacles
    /// The line from start to end as lines and arcs, if it is not straight along the set's heading. Otherwise
    /// without pieces.
    Curve curve = {};

    bool isCurved() const { return !curve.pieces.empty(); }
    /// A ring is always driven in the same direction.
    bool isClosed() const { return isCurved() && start == end; }
    Length length() const { return isCurved() ? curve.length() : metres(distance(start, end)); }
    friend bool operator==(const Swath&, const Swath&) = default;
};

/// The middle of a swath from start to end. Curves are chords within this distance of them.
Polyline middleLine(const Swath& swath, Length chordTolerance = kSwathChord);

/// The line of a swath, straight or not.
Curve lineOf(const Swath& swath);

/// A heading that a search examined closely.
struct HeadingCandidate {
    Angle heading;  ///< modulo pi
    HeadingFigures figures;
    bool alongLongestEdge = false;  ///< of the field or of the mainland
};

/// The swaths of one mainland and the figures of their heading.
struct SwathSet {
    std::vector<Swath> swaths;  ///< ordered by track, then along the heading
    Angle heading;              ///< modulo pi; for curved swaths the mean
    bool proved = false;        ///< no better set exists for the objective
    Length totalLength;         ///< of the swaths as they are
    double coverage = 0.0;      ///< A_cov: covered share of the mainland, flat ends
    Area overlap;               ///< area inside the mainland covered at least twice, flat ends
    Length shift;               ///< from half a width inside the mainland's edge to the first track
    /// The widths of the strips to the right and left of the outermost straight swaths that the last pass
    /// leaves out (`gap`).
    Length restRight;
    Length restLeft;
    /// The parts of the mainland that the method leaves out on purpose: strips beside the outermost swaths if
    /// the last pass is `gap`, and land between and beside rows. Land at the ends of swaths does not count.
    MultiPolygon leftOnPurpose;
    int headingsTried = 1;
    /// Of a search by time: the quickest headings by its estimate, at least a degree apart, quickest first,
    /// and the headings of the longest edges of field and mainland. The set's own heading is among them.
    std::vector<HeadingCandidate> candidates;
    /// Area worked beyond the mainland's edge by extended ends.
    Area endOverlap;
    std::vector<Ring> goneRound;  ///< obstacles inside the mainland that swaths go round
    std::vector<Note> notes;      ///< what was left out, and why

    bool isCurved() const {
        return std::ranges::any_of(swaths, [](const Swath& swath) { return swath.isCurved(); });
    }
};

/// The inputs of swaths. The swaths keep none of them.
struct SwathTask {
    const Field& field;            ///< for its frame and the numbers of its edges
    const MultiPolygon& mainland;  ///< valid polygons in metres, holes allowed
    const Machine& machine;
    const Settings& settings;
    const GuideData* guides = nullptr;  ///< rows and heights, if the method needs any
};

/// The common signature of all swath methods.
///
/// @return at least one swath, with ends on its centre line. InputRefused: the mainland is too narrow for
/// any. Usage: a line or an edge that the method needs is missing. Cancelled.
using SwathGenerator = Result<SwathSet>(const SwathTask& task, const JobContext& job);

template <>
struct MethodTraits<SwathGenerator> {
    bool searchesHeadings = false;  ///< tries many
    bool isFromPoint = false;       ///< along a line that is given by a point and a direction
};

}  // namespace furrow
