// The land that a recorded drive worked: areas by hand.

#include "planner/track/driven_area.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace furrow;
using namespace furrow::test;

namespace {

RecordedTrack along(const std::vector<Point>& places, std::optional<bool> down) {
    RecordedTrack track{.source = "by hand", .places = TrackPlaces::Local, .samples = {}};
    for (const Point place : places) {
        track.samples.push_back({.local = place, .implementDown = down});
    }
    return track;
}

/// All samples belong to stretches of this kind: to one, or each to another.
DrivenArea driven(const RecordedTrack& track, SegmentKind kind = SegmentKind::Swath, bool oneStretch = true) {
    const LocalFrame frame = LocalFrame::centredOn({.lonDeg = 5.66, .latDeg = 52.09}).value();
    TrackComparison matches;
    matches.matches.emplace_back();
    for (std::size_t i = 0; i < track.samples.size(); ++i) {
        matches.matches.back().push_back(TrackMatch{.segment = oneStretch ? 0 : i, .kind = kind});
    }
    const Ring places = placesIn(frame, track);
    return drivenArea({rectangle(100.0, 20.0)}, {&track, 1}, {&places, 1}, matches, metres(10.0)).value();
}

}  // namespace

class TestDrivenArea : public QObject {
    Q_OBJECT

private slots:
    /// Along the lower half of 100 m by 20 m: half of it.
    void halfAField() {
        const DrivenArea area = driven(along({{0, 5}, {20, 5}, {40, 5}, {60, 5}, {80, 5}, {100, 5}}, true));
        COMPARE_WITHIN(area.covered.si(), 1000.0, 1e-3);
        COMPARE_WITHIN(area.missed.si(), 1000.0, 1e-3);
        QCOMPARE(area.places.size(), std::size_t{1});
    }

    /// 60 m without a sample: a break in the recording.
    void aBreakIsNotWorked() {
        const RecordedTrack track = along({{0, 5}, {20, 5}, {80, 5}, {100, 5}}, true);
        COMPARE_WITHIN(driven(track, SegmentKind::Swath, false).covered.si(), 400.0, 1e-3);
        // Along one swath the receiver was only slow.
        COMPARE_WITHIN(driven(track).covered.si(), 1000.0, 1e-3);
    }

    void upIsNotWorked() {
        const DrivenArea area = driven(along({{0, 5}, {20, 5}, {40, 5}}, false));
        COMPARE_WITHIN(area.covered.si(), 0.0, 1e-3);
    }

    void withoutWordOfItTheKindTells() {
        const RecordedTrack track = along({{0, 5}, {20, 5}, {40, 5}}, std::nullopt);
        COMPARE_WITHIN(driven(track).covered.si(), 400.0, 1e-3);
        COMPARE_WITHIN(driven(track, SegmentKind::HeadlandPass).covered.si(), 400.0, 1e-3);
        COMPARE_WITHIN(driven(track, SegmentKind::Turn).covered.si(), 0.0, 1e-3);
    }

    /// Twice over the same land is once worked, and land outside is none of the field.
    void twiceIsOnce() {
        const DrivenArea area =
            driven(along({{-20, 5}, {0, 5}, {20, 5}, {40, 5}, {20, 5}, {0, 5}, {-20, 5}}, true));
        COMPARE_WITHIN(area.covered.si(), 400.0, 1e-3);
    }

    /// A right angle: two strips of 10 m by 20 m up to the corner (50, 10), where their ends overlap in a
    /// square of 5 m, and the wedge outside of it, half a square of 5 m.
    void bendsLeaveNoGap() {
        const DrivenArea area = driven(along({{30, 5}, {50, 5}, {50, 20}}, true));
        COMPARE_WITHIN(area.covered.si(), 200.0 + 150.0 - 25.0 + 12.5, 1e-3);
    }

    void standingStillIsNoMatter() {
        const DrivenArea area = driven(along({{0, 5}, {20, 5}, {20, 5}, {20, 5}, {40, 5}}, true));
        COMPARE_WITHIN(area.covered.si(), 400.0, 1e-3);
    }
};

FURROW_TEST(TestDrivenArea);
#include "tst_driven_area.moc"
