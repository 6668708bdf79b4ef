// Boundaries from recorded tracks: areas by hand, and real fields that come back from their plans.

#include "planner/core/error.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/plan.h"
#include "planner/track/track_outline.h"
#include "tests/support/field_generator.h"
#include "tests/support/real_fields.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include "planner/geometry/geos_bridge.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

using namespace furrow;
using namespace furrow::test;

namespace {

const LocalFrame& frame() {
    static const LocalFrame there = LocalFrame::centredOn({.lonDeg = 5.66, .latDeg = 52.09}).value();
    return there;
}

/// Corner by corner, with a position at least every `stepM`.
Polyline along(const Polyline& corners, double stepM) {
    Polyline line{corners.front()};
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const Point way = corners[i] - corners[i - 1];
        const auto steps = static_cast<int>(std::ceil(std::hypot(way.x, way.y) / stepM));
        for (int k = 1; k <= steps; ++k) {
            line.push_back(corners[i - 1] + (static_cast<double>(k) / steps) * way);
        }
    }
    return line;
}

/// Around a circle, `share` of it.
Polyline circle(double radiusM, double share = 1.0) {
    Polyline line;
    const int count = static_cast<int>(360.0 * share);
    for (int k = 0; k <= count; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 360.0;
        line.push_back({radiusM * std::cos(angle), radiusM * std::sin(angle)});
    }
    return line;
}

RecordedTrack recorded(const Polyline& line) {
    RecordedTrack track{.source = "by hand", .places = TrackPlaces::Wgs84, .samples = {}};
    for (const Point place : line) {
        track.samples.push_back({.geo = frame().toGeo(place)});
    }
    return track;
}

/// Swaths of 6 m to and fro over 300 m by 120 m, 2 m from one position to the next, after a round along the
/// edge.
Polyline workedRectangle() {
    Polyline corners{{3, 3}, {297, 3}, {297, 117}, {3, 117}, {3, 3}};
    for (int swath = 0; swath < 18; ++swath) {
        const double y = 9.0 + 6.0 * swath;
        const bool isBack = swath % 2 == 1;
        corners.push_back({isBack ? 294.0 : 6.0, y});
        corners.push_back({isBack ? 6.0 : 294.0, y});
    }
    return along(corners, 2.0);
}

Polyline noisy(Polyline line, double sigmaM) {
    std::mt19937_64 random{7};
    for (Point& place : line) {
        // The sum of twelve is as good as normal.
        double x = -6.0;
        double y = -6.0;
        for (int k = 0; k < 12; ++k) {
            x += uniform(random, 0.0, 1.0);
            y += uniform(random, 0.0, 1.0);
        }
        place = place + Point{sigmaM * x, sigmaM * y};
    }
    return line;
}

TrackOutline outlineOf(const std::vector<RecordedTrack>& tracks, const TrackOutlineOptions& options) {
    auto made = outlineOfTracks(tracks, options);
    if (!made) {
        qFatal("%s", made.error().line().c_str());
    }
    return *std::move(made);
}

TrackOutline outlineOf(const Polyline& line, const TrackOutlineOptions& options) {
    return outlineOf(std::vector{recorded(line)}, options);
}

MultiPolygon local(const TrackOutline& outline, const LocalFrame& in = frame()) {
    MultiPolygon polygons;
    for (const GeoPolygon& piece : outline.pieces) {
        polygons.push_back(in.toLocal(piece));
    }
    return polygons;
}

/// Of what two areas have together, the share that they have in common.
double overlap(const MultiPolygon& a, const MultiPolygon& b) {
    const double both = area(intersection(a, b, {}, kSnapGrid).value()).si();
    return both / (area(a).si() + area(b).si() - both);
}

/// As a receiver on the tractor records it.
RecordedTrack everySecond(const Path& path, const LocalFrame& in) {
    RecordedTrack track{.source = "driven", .places = TrackPlaces::Wgs84, .samples = {}};
    double next = 0.0;
    std::optional<PathSample> before;
    for (const PathSegment& segment : path.segments) {
        for (const PathSample& sample : segment.samples) {
            while (before && sample.tS > before->tS && next <= sample.tS) {
                const double share = (next - before->tS) / (sample.tS - before->tS);
                const Point place = before->position + share * (sample.position - before->position);
                track.samples.push_back({.geo = in.toGeo(place), .timeS = next});
                next += 1.0;
            }
            before = sample;
        }
    }
    return track;
}

/// As a plan is written: bends point by point, straights by their ends.
RecordedTrack pointsOf(const Path& path, const LocalFrame& in) {
    RecordedTrack track{.source = "plan", .places = TrackPlaces::Wgs84, .samples = {}};
    for (const PathSegment& segment : path.segments) {
        for (const PathSample& sample : segment.samples) {
            track.samples.push_back({.geo = in.toGeo(sample.position)});
        }
    }
    return track;
}

const TrackOutlineOptions kSixMetres{.width = metres(6.0)};

}  // namespace

class TestTrackOutline : public QObject {
    Q_OBJECT

private slots:
    void aroundARectangle();
    void aroundACircle();
    void halfAWidthBeyond();
    void theWayThereIsNoPart();
    void twoRoundsAndAPond();
    void roundInTwoRecordings();
    void worked();
    void workedWithoutAHeadland();
    void noiseIsNoMatter();
    void jumpsAreLeftOut();
    void oneSwathMissing();
    void aPondInWorkedLand();
    void wayToWorkedLand();
    void onlyWhereItWasDown();
    void sparseSwaths();
    void severalFields();
    void inMetresOfAPlan();
    void refused_data();
    void refused();
    void realFieldsComeBack_data();
    void realFieldsComeBack();
};

void TestTrackOutline::aroundARectangle() {
    const TrackOutline outline =
        outlineOf(along({{0, 0}, {200, 0}, {200, 100}, {0, 100}, {0, 0}}, 3.0), kSixMetres);
    QCOMPARE(outline.kind, TrackKind::Round);
    QCOMPARE(outline.pieces.size(), std::size_t{1});
    COMPARE_WITHIN(outline.area.si(), 20'000.0, 10.0);
    QVERIFY(outline.notes.empty());
    // Also where the end is 12 m before the beginning.
    const TrackOutline open =
        outlineOf(along({{0, 0}, {200, 0}, {200, 100}, {0, 100}, {0, 12}}, 3.0), kSixMetres);
    QCOMPARE(open.kind, TrackKind::Round);
    COMPARE_WITHIN(open.area.si(), 20'000.0, 10.0);
}

void TestTrackOutline::aroundACircle() {
    COMPARE_WITHIN(outlineOf(circle(80.0), kSixMetres).area.si(), std::numbers::pi * 6400.0,
                   0.001 * 20'106.0);
}

void TestTrackOutline::halfAWidthBeyond() {
    const TrackOutline outline = outlineOf(circle(80.0), {.width = metres(6.0), .beyond = metres(3.0)});
    COMPARE_WITHIN(outline.area.si(), std::numbers::pi * 83.0 * 83.0, 0.001 * 21'642.0);
    // Inwards, as after a round on the road outside.
    COMPARE_WITHIN(outlineOf(circle(80.0), {.width = metres(6.0), .beyond = metres(-3.0)}).area.si(),
                   std::numbers::pi * 77.0 * 77.0, 0.001 * 18'627.0);
}

void TestTrackOutline::theWayThereIsNoPart() {
    const TrackOutline outline = outlineOf(
        along({{-400, -50}, {0, 0}, {200, 0}, {200, 100}, {0, 100}, {0, 0}, {-400, -50}}, 3.0), kSixMetres);
    QCOMPARE(outline.kind, TrackKind::Round);
    COMPARE_WITHIN(outline.area.si(), 20'000.0, 20.0);
}

void TestTrackOutline::twoRoundsAndAPond() {
    // The second round lies 6 m farther inside; the pond was driven around after both.
    const TrackOutline outline = outlineOf(
        {recorded(along(
             {{0, 0}, {200, 0}, {200, 100}, {0, 100}, {0, 0}, {6, 6}, {194, 6}, {194, 94}, {6, 94}, {6, 6}},
             3.0)),
         recorded(along({{50, 40}, {70, 40}, {70, 60}, {50, 60}, {50, 40}}, 3.0))},
        kSixMetres);
    QCOMPARE(outline.kind, TrackKind::Round);
    QCOMPARE(outline.pieces.size(), std::size_t{1});
    QCOMPARE(outline.pieces.front().holes.size(), std::size_t{1});
    COMPARE_WITHIN(outline.area.si(), 20'000.0 - 400.0, 20.0);
}

void TestTrackOutline::roundInTwoRecordings() {
    const TrackOutline outline = outlineOf({recorded(along({{0, 0}, {200, 0}, {200, 100}}, 3.0)),
                                            recorded(along({{195, 100}, {0, 100}, {0, 4}}, 3.0))},
                                           kSixMetres);
    QCOMPARE(outline.kind, TrackKind::Round);
    COMPARE_WITHIN(outline.area.si(), 20'000.0, 20.0);
}

void TestTrackOutline::worked() {
    const TrackOutline outline = outlineOf(workedRectangle(), kSixMetres);
    QCOMPARE(outline.kind, TrackKind::Worked);
    QCOMPARE(outline.pieces.size(), std::size_t{1});
    QVERIFY(outline.pieces.front().holes.empty());
    COMPARE_WITHIN(outline.area.si(), 36'000.0, 0.01 * 36'000.0);
    QVERIFY(overlap(local(outline), {rectangle(300.0, 120.0)}) > 0.99);
}

void TestTrackOutline::workedWithoutAHeadland() {
    Polyline corners;
    for (int swath = 0; swath < 20; ++swath) {
        const double y = 3.0 + 6.0 * swath;
        corners.push_back({swath % 2 == 1 ? 300.0 : 0.0, y});
        corners.push_back({swath % 2 == 1 ? 0.0 : 300.0, y});
    }
    const TrackOutline outline = outlineOf(along(corners, 2.0), kSixMetres);
    QCOMPARE(outline.kind, TrackKind::Worked);
    // The strip of a turn reaches half a width beyond the ends: 6 m by 12 m of each of 19, on the whole of a
    // side but for its gaps, which are closed.
    QVERIFY(overlap(local(outline), {rectangle(306.0, 120.0, {-3.0, 0.0})}) > 0.98);
}

void TestTrackOutline::noiseIsNoMatter() {
    const TrackOutline outline = outlineOf(noisy(workedRectangle(), 0.02), kSixMetres);
    QCOMPARE(outline.kind, TrackKind::Worked);
    COMPARE_WITHIN(outline.area.si(), 36'000.0, 0.01 * 36'000.0);
    COMPARE_WITHIN(outlineOf(noisy(circle(80.0), 0.02), kSixMetres).area.si(), std::numbers::pi * 6400.0,
                   0.01 * 20'106.0);
}

void TestTrackOutline::jumpsAreLeftOut() {
    Polyline line = workedRectangle();
    // One position, and five in a row, and the very first and last.
    line[100] = line[100] + Point{0.0, -60.0};
    for (std::size_t i = 500; i < 505; ++i) {
        line[i] = line[i] + Point{900.0, 400.0};
    }
    line.front() = {-3000.0, 0.0};
    line.back() = {3000.0, 0.0};
    const TrackOutline outline = outlineOf(line, kSixMetres);
    QCOMPARE(outline.notes.size(), std::size_t{1});
    QCOMPARE(outline.notes.front().text.text(), std::string{"8 positions that jumped away were left out"});
    QVERIFY(outline.notes.front().place.has_value());
    COMPARE_WITHIN(outline.area.si(), 36'000.0, 0.01 * 36'000.0);
    Polyline round = along({{0, 0}, {200, 0}, {200, 100}, {0, 100}, {0, 0}}, 3.0);
    round[30] = round[30] + Point{25.0, 10.0};
    COMPARE_WITHIN(outlineOf(round, kSixMetres).area.si(), 20'000.0, 20.0);
}

void TestTrackOutline::oneSwathMissing() {
    Polyline corners;
    bool isBack = false;
    for (int swath = 0; swath < 20; ++swath) {
        if (swath == 8) {
            continue;
        }
        const double y = 3.0 + 6.0 * swath;
        corners.push_back({isBack ? 300.0 : 0.0, y});
        corners.push_back({isBack ? 0.0 : 300.0, y});
        isBack = !isBack;
    }
    const Polyline line = along(corners, 2.0);
    // Its 1800 m² belong to the field, unless gaps are to stay.
    const double closed =
        outlineOf(line, {.kind = TrackKind::Worked, .width = metres(6.0), .gap = metres(7.0)}).area.si();
    const double open =
        outlineOf(line, {.kind = TrackKind::Worked, .width = metres(6.0), .gap = metres(4.0)}).area.si();
    COMPARE_WITHIN(closed, 36'000.0, 0.02 * 36'000.0);
    QVERIFY2(closed - open > 1500.0, qPrintable(QString::number(closed - open)));
}

void TestTrackOutline::aPondInWorkedLand() {
    // Swaths of 6 m on 300 m by 120 m; those that meet a pond of 40 m go around it.
    Polyline corners;
    for (int swath = 0; swath < 20; ++swath) {
        const double y = 3.0 + 6.0 * swath;
        const bool isBack = swath % 2 == 1;
        Polyline line{{0.0, y}, {300.0, y}};
        if (y > 40.0 && y < 80.0) {
            line = {{0.0, y}, {127.0, y}, {127.0, 37.0}, {173.0, 37.0}, {173.0, y}, {300.0, y}};
        }
        if (isBack) {
            std::ranges::reverse(line);
        }
        corners.insert(corners.end(), line.begin(), line.end());
    }
    corners.insert(corners.end(), {{127, 117}, {127, 83}, {173, 83}});
    const TrackOutline outline = outlineOf(along(corners, 2.0), kSixMetres);
    QCOMPARE(outline.kind, TrackKind::Worked);
    QCOMPARE(outline.pieces.front().holes.size(), std::size_t{1});
    // 40 m by 36 m between the strips around it, corners with a radius of half the gap that is closed.
    const Ring hole = frame().toLocal(outline.pieces.front().holes.front());
    COMPARE_WITHIN(std::abs(signedAreaM2(hole)), 1440.0 - (4.0 - std::numbers::pi) * 9.0, 3.0);
    const TrackOutline filled =
        outlineOf(along(corners, 2.0), {.width = metres(6.0), .smallestHole = squareMetres(2000.0)});
    QVERIFY(filled.pieces.front().holes.empty());
}

void TestTrackOutline::wayToWorkedLand() {
    Polyline line = along({{-500, 30}, {0, 30}, {3, 3}}, 2.0);
    const Polyline work = workedRectangle();
    line.insert(line.end(), work.begin(), work.end());
    const TrackOutline outline = outlineOf(line, kSixMetres);
    COMPARE_WITHIN(outline.area.si(), 36'000.0, 0.01 * 36'000.0);
    QCOMPARE(outline.notes.size(), std::size_t{1});
    QVERIFY2(outline.notes.front().text.contains("1 stretch of one strip was left out"),
             outline.notes.front().text.c_str());
}

void TestTrackOutline::onlyWhereItWasDown() {
    RecordedTrack track = recorded(workedRectangle());
    for (TrackSample& sample : track.samples) {
        sample.implementDown = frame().toLocal(sample.geo).x < 150.0;
    }
    COMPARE_WITHIN(outlineOf(std::vector{track}, kSixMetres).area.si(), 18'000.0, 0.02 * 18'000.0);
}

/// Swaths by their ends, turns of four positions: none of them is a jump, no swath a break.
void TestTrackOutline::sparseSwaths() {
    Polyline line;
    for (int swath = 0; swath < 20; ++swath) {
        const double y = 3.0 + 6.0 * swath;
        const double side = swath % 2 == 1 ? -1.0 : 1.0;
        const double end = swath % 2 == 1 ? 0.0 : 300.0;
        line.insert(line.end(), {{300.0 - end, y},
                                 {end, y},
                                 {end + 2.0 * side, y + 1.0},
                                 {end + 3.0 * side, y + 3.0},
                                 {end + 2.0 * side, y + 5.0}});
    }
    const TrackOutline outline = outlineOf(line, kSixMetres);
    QCOMPARE(outline.kind, TrackKind::Worked);
    QVERIFY(outline.notes.empty());
    QVERIFY(overlap(local(outline), {rectangle(300.0, 120.0)}) > 0.95);
}

void TestTrackOutline::severalFields() {
    const TrackOutline outline =
        outlineOf({recorded(along({{0, 0}, {200, 0}, {200, 100}, {0, 100}, {0, 0}}, 3.0)),
                   recorded(along({{900, 0}, {1000, 0}, {1000, 100}, {900, 100}, {900, 0}}, 3.0))},
                  kSixMetres);
    QCOMPARE(outline.pieces.size(), std::size_t{2});
    COMPARE_WITHIN(outline.area.si(), 30'000.0, 20.0);
    COMPARE_WITHIN(geodesicArea(outline.pieces.front()).si(), 20'000.0, 20.0);
}

void TestTrackOutline::inMetresOfAPlan() {
    RecordedTrack track{.source = "a robot", .places = TrackPlaces::Local, .samples = {}};
    for (const Point place : circle(80.0)) {
        track.samples.push_back({.local = place});
    }
    TrackOutlineOptions options = kSixMetres;
    const auto without = outlineOfTracks({&track, 1}, options);
    QVERIFY(!without && without.error().what.contains("metres in the plan"));
    options.frame = frame();
    const TrackOutline outline = outlineOf(std::vector{track}, options);
    COMPARE_WITHIN(outline.area.si(), std::numbers::pi * 6400.0, 20.0);
    QVERIFY(isInside(local(outline), {0.0, 0.0}));
}

void TestTrackOutline::refused_data() {
    QTest::addColumn<QString>("track");
    QTest::addColumn<QString>("what");
    QTest::newRow("no position") << "none" << "0 positions only";
    QTest::newRow("few") << "few" << "3 positions only";
    QTest::newRow("half a circle") << "half" << "are missing";
    QTest::newRow("one strip") << "strip" << "nowhere beside each other";
    QTest::newRow("jumps") << "jumps" << "jump away and back";
    QTest::newRow("no width") << "no width" << "out of range";
}

void TestTrackOutline::refused() {
    QFETCH(QString, track);
    QFETCH(QString, what);
    Polyline line;
    TrackOutlineOptions options = kSixMetres;
    std::vector<RecordedTrack> tracks;
    if (track == "few") {
        line = {{0, 0}, {50, 0}, {50, 50}};
    } else if (track == "half") {
        line = circle(80.0, 0.5);
        options.kind = TrackKind::Round;
    } else if (track == "strip") {
        line = along({{0, 0}, {400, 0}}, 2.0);
    } else if (track == "jumps") {
        line = workedRectangle();
        for (std::size_t i = 0; i + 6 < line.size(); i += 6) {
            line[i] = line[i] + Point{400.0, 5000.0};
        }
    } else if (track == "no width") {
        line = circle(80.0);
        options.width = metres(0.0);
    }
    if (!line.empty()) {
        tracks.push_back(recorded(line));
    }
    if (track == "jumps") {
        for (std::size_t i = 0; i < tracks.front().samples.size(); ++i) {
            tracks.front().samples[i].timeS = static_cast<double>(i);
        }
    }
    const auto made = outlineOfTracks(tracks, options);
    QVERIFY(!made);
    QCOMPARE(made.error().code, ErrorCode::InputRefused);
    QVERIFY2(made.error().what.contains(what.toStdString()), made.error().line().c_str());
    QVERIFY(!made.error().remedy.empty());
}

void TestTrackOutline::realFieldsComeBack_data() {
    QTest::addColumn<int>("index");
    QTest::addColumn<bool>("byPlan");
    // On smaller fields the corners that no machine gets into are more than the 2 %.
    constexpr double kSmallM2 = 10'000.0;
    const std::vector<FieldSource> fields = shippedFields();
    int row = 0;
    for (int i = 0; i < static_cast<int>(fields.size()); ++i) {
        const FieldSource& field = fields[static_cast<std::size_t>(i)];
        const double squareM = geodesicArea(field.parts.front()).si();
        if (squareM < kSmallM2 || row++ % 3 != 0) {
            continue;
        }
        QTest::newRow(field.name.c_str()) << i << false;
        if (row % 2 == 0) {
            QTest::newRow((field.name + ", as planned").c_str()) << i << true;
        }
    }
}

/// A plan is driven and recorded, the field forgotten.
void TestTrackOutline::realFieldsComeBack() {
    QFETCH(int, index);
    QFETCH(bool, byPlan);
    static const std::vector<FieldSource> fields = shippedFields();
    const auto field =
        std::make_shared<const Field>(Field::create(fields[static_cast<std::size_t>(index)]).value());
    const Machine machine = findMachine("cultivator").value();
    const auto plan = makePlan({.field = field, .machine = machine, .settings = {}});
    QVERIFY2(plan.has_value(), plan ? "" : plan.error().line().c_str());
    const RecordedTrack track =
        byPlan ? pointsOf((*plan)->path, field->frame()) : everySecond((*plan)->path, field->frame());
    const TrackOutline outline = outlineOf(std::vector{track}, {.width = machine.operatingWidth()});
    const MultiPolygon rebuilt = local(outline, field->frame());
    const double share = overlap(rebuilt, field->workable());
    const double off = std::abs(area(rebuilt).si() / area(field->workable()).si() - 1.0);
    QVERIFY2(share > 0.97 && off < 0.02,
             qPrintable(QStringLiteral("overlap %1, area off by %2 %").arg(share).arg(100.0 * off)));
}

FURROW_TEST(TestTrackOutline);
#include "tst_track_outline.moc"
