#include "planner/machine/machine_library.h"
#include "planner/swaths/heading_search.h"
#include "planner/swaths/methods.h"
#include "planner/swaths/objective.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stop_token>

using namespace furrow;

namespace {

constexpr GeoPoint kCentre{9.2, 51.3};

Field fieldFrom(const MultiPolygon& polygons) {
    return Field::create(test::fieldSourceFromLocal(polygons, kCentre)).value();
}

Machine machineOf(double operatingWidthM) {
    MachineSpec spec = findMachine("agbot")->spec();
    spec.implement.operatingWidth = metres(operatingWidthM);
    return Machine::create(spec).value();
}

using Given = std::initializer_list<std::pair<const Parameter*, std::string>>;

Result<SwathSet> run(const Method<SwathGenerator>& method, const Field& field, double widthM,
                     const Given& given, const JobContext& job = {}) {
    Settings settings;
    for (const auto& [parameter, text] : given) {
        settings.setText(*parameter, text).value();
    }
    const Machine machine = machineOf(widthM);
    return method.run(
        {.field = field, .mainland = field.workable(), .machine = machine, .settings = settings}, job);
}

/// WKT in WGS84 of points in the field's frame.
std::string wktOf(const Field& field, const std::vector<Point>& points) {
    QStringList texts;
    for (const Point& point : points) {
        const GeoPoint place = field.frame().toGeo(point);
        texts << QStringLiteral("%1 %2").arg(place.lonDeg, 0, 'f', 12).arg(place.latDeg, 0, 'f', 12);
    }
    return (QLatin1String(points.size() == 1 ? "POINT (" : "LINESTRING (") + texts.join(", ") + ")")
        .toStdString();
}

double between(Angle a, double deg) {
    return std::abs(std::remainder(inDegrees(a) - deg, 180.0));
}

/// How far each track lies to the left of a line through `origin`, rising.
std::vector<double> tracksAcross(const SwathSet& set, Point origin) {
    std::map<int, double> tracks;
    for (const Swath& swath : set.swaths) {
        tracks.emplace(swath.track, cross(direction(set.heading.si()), swath.start - origin));
    }
    std::vector<double> across;
    for (const auto& [track, away] : tracks) {
        across.push_back(away);
    }
    std::ranges::sort(across);
    return across;
}

double nearestTo(const std::vector<double>& values, double wanted) {
    double nearest = 1e9;
    for (const double value : values) {
        nearest = std::min(nearest, std::abs(value - wanted));
    }
    return nearest;
}

}  // namespace

class GuidanceLinesTest : public QObject {
    Q_OBJECT

private slots:
    void aSwathLiesOnTheLine_data() {
        QTest::addColumn<QString>("wkt");
        QTest::addColumn<Point>("a");
        QTest::addColumn<Point>("b");
        QTest::addColumn<double>("headingDeg");
        const QString rectangle = QStringLiteral("POLYGON((-100 -50, 100 -50, 100 50, -100 50, -100 -50))");
        const QString triangle = QStringLiteral("POLYGON((-90 -80, 110 -40, -30 120, -90 -80))");
        QTest::newRow("to the east") << rectangle << Point{-50.0, 7.3} << Point{50.0, 7.3} << 0.0;
        QTest::newRow("to the west") << rectangle << Point{50.0, 7.3} << Point{-50.0, 7.3} << 0.0;
        QTest::newRow("to the north") << rectangle << Point{11.1, -20.0} << Point{11.1, 20.0} << 90.0;
        QTest::newRow("a 3-4-5 slope")
            << rectangle << Point{-40.0, -30.0} << Point{40.0, 30.0} << 36.8698976458440;
        QTest::newRow("falling") << rectangle << Point{0.0, 20.0} << Point{10.0, 10.0} << 135.0;
        QTest::newRow("points just far enough apart")
            << rectangle << Point{0.0, 0.0} << Point{1.2, 0.0} << 0.0;
        QTest::newRow("triangle") << triangle << Point{-20.0, -10.0} << Point{0.0, 10.0} << 45.0;
        QTest::newRow("points outside of the field")
            << rectangle << Point{-300.0, 13.0} << Point{-200.0, 13.0} << 0.0;
    }
    void aSwathLiesOnTheLine() {
        QFETCH(QString, wkt);
        QFETCH(Point, a);
        QFETCH(Point, b);
        QFETCH(double, headingDeg);
        const Field field = fieldFrom(test::polygonsFromWkt(wkt.toStdString()));
        const GeoPoint geoA = LocalFrame::centredOn(kCentre)->toGeo(a);
        const Point localA = field.frame().toLocal(geoA);
        const Point localB = field.frame().toLocal(LocalFrame::centredOn(kCentre)->toGeo(b));
        const std::string line = wktOf(field, {localA, localB});
        for (const char* lastPass : {"overlap", "spread", "gap"}) {
            const auto ab = run(kAbLineMethod, field, 6.0, {{&kLine, line}, {&kLastPass, lastPass}});
            VERIFY_RESULT(ab);
            QVERIFY2(between(ab->heading, headingDeg) < 1e-3,
                     qPrintable(QString::number(inDegrees(ab->heading))));
            const std::vector<double> tracks = tracksAcross(*ab, localA);
            QVERIFY2(nearestTo(tracks, 0.0) < 1e-3, lastPass);
            // B lies on it as well.
            QVERIFY2(nearestTo(tracks, cross(direction(ab->heading.si()), localB - localA)) < 1e-3, lastPass);
            if (QLatin1String(lastPass) != QLatin1String("spread")) {
                QVERIFY2(nearestTo(tracks, 6.0) < 1e-3, lastPass);
                QVERIFY2(nearestTo(tracks, -6.0) < 1e-3, lastPass);
            }
            // The same line from A and its direction.
            const auto plus = run(kAPlusMethod, field, 6.0,
                                  {{&kLine, wktOf(field, {localA})},
                                   {&kAngle, QString::number(headingDeg, 'f', 12).toStdString()},
                                   {&kLastPass, lastPass}});
            VERIFY_RESULT(plus);
            QVERIFY(between(plus->heading, headingDeg) < 1e-9);
            QVERIFY2(nearestTo(tracksAcross(*plus, localA), 0.0) < 1e-3, lastPass);
            QCOMPARE(plus->swaths.size(), ab->swaths.size());
        }
    }

    void tracksByHand_data() {
        QTest::addColumn<double>("anchorY");
        QTest::addColumn<QString>("lastPass");
        QTest::addColumn<QString>("overlap");
        QTest::addColumn<QList<double>>("tracks");
        // 44 m high at 6 m: centre lines from 3 to 41. The line at 10 m makes 4, 10 ... 40.
        QTest::newRow("overlap on both sides")
            << 10.0 << "overlap" << "0" << QList<double>{3, 4, 10, 16, 22, 28, 34, 40, 41};
        QTest::newRow("gap on both sides")
            << 10.0 << "gap" << "0" << QList<double>{4, 10, 16, 22, 28, 34, 40};
        // 7 m below in 2 steps, 31 m above in 6.
        QTest::newRow("spread on both sides")
            << 10.0 << "spread" << "0"
            << QList<double>{3, 6.5, 10, 10 + 31 / 6.0, 10 + 62 / 6.0, 25.5, 10 + 124 / 6.0, 10 + 155 / 6.0,
                             41};
        QTest::newRow("overlap, flush below")
            << 9.0 << "overlap" << "0" << QList<double>{3, 9, 15, 21, 27, 33, 39, 41};
        QTest::newRow("gap, flush below") << 9.0 << "gap" << "0" << QList<double>{3, 9, 15, 21, 27, 33, 39};
        QTest::newRow("spread, flush below")
            << 3.0 << "spread" << "0"
            << QList<double>{
                   3, 3 + 38 / 7.0, 3 + 76 / 7.0, 3 + 114 / 7.0, 3 + 152 / 7.0, 3 + 190 / 7.0, 3 + 228 / 7.0,
                   41};
        QTest::newRow("spread, flush above")
            << 41.0 << "spread" << "0"
            << QList<double>{
                   3, 3 + 38 / 7.0, 3 + 76 / 7.0, 3 + 114 / 7.0, 3 + 152 / 7.0, 3 + 190 / 7.0, 3 + 228 / 7.0,
                   41};
        QTest::newRow("overlap, flush above")
            << 41.0 << "overlap" << "0" << QList<double>{3, 5, 11, 17, 23, 29, 35, 41};
        QTest::newRow("gap, flush above") << 41.0 << "gap" << "0" << QList<double>{5, 11, 17, 23, 29, 35, 41};
        QTest::newRow("gap, line below the field")
            << -2.0 << "gap" << "0" << QList<double>{4, 10, 16, 22, 28, 34, 40};
        QTest::newRow("overlap, line above the field")
            << 52.0 << "overlap" << "0" << QList<double>{3, 4, 10, 16, 22, 28, 34, 40, 41};
        QTest::newRow("gap, neighbours overlap")
            << 10.0 << "gap" << "1" << QList<double>{5, 10, 15, 20, 25, 30, 35, 40};
        QTest::newRow("overlap, neighbours overlap")
            << 10.0 << "overlap" << "1" << QList<double>{3, 5, 10, 15, 20, 25, 30, 35, 40, 41};
    }
    void tracksByHand() {
        QFETCH(double, anchorY);
        QFETCH(QString, lastPass);
        QFETCH(QString, overlap);
        QFETCH(QList<double>, tracks);
        const Field field = fieldFrom({test::centredRectangle(100.0, 44.0)});
        const std::string line = wktOf(field, {{-10.0, anchorY - 22.0}, {10.0, anchorY - 22.0}});
        const auto set =
            run(kAbLineMethod, field, 6.0,
                {{&kLine, line}, {&kLastPass, lastPass.toStdString()}, {&kOverlap, overlap.toStdString()}});
        VERIFY_RESULT(set);
        const std::vector<double> found = tracksAcross(*set, {0.0, -22.0});
        QCOMPARE(found.size(), static_cast<std::size_t>(tracks.size()));
        for (std::size_t i = 0; i < found.size(); ++i) {
            COMPARE_WITHIN(found[i], tracks[static_cast<qsizetype>(i)], 1e-3);
        }
        // What is left out: 1 m at either edge, or all of it covered.
        const double uncoveredM =
            lastPass == "gap" ? std::max(0.0, tracks.front() - 3.0) + 41.0 - tracks.back() : 0.0;
        COMPARE_WITHIN(set->coverage, 1.0 - uncoveredM / 44.0, 1e-4);
    }

    // Rectangles of any size, lines anywhere along them.
    void whatTheLastPassPromises() {
        constexpr std::uint64_t kSeed = 31;
        std::mt19937_64 random{kSeed};
        for (int i = 0; i < 200; ++i) {
            // Two widths and more: one of the line's neighbours fits anywhere.
            const double heightM = test::uniform(random, 25.0, 150.0);
            const double widthM = test::uniform(random, 2.0, 12.0);
            const double headingDeg = test::uniform(random, 0.0, 180.0);
            const double anchorM = test::uniform(random, -0.8 * heightM, 0.8 * heightM);
            const MultiPolygon mainland =
                test::moved({test::centredRectangle(120.0, heightM)}, degrees(headingDeg), {});
            const Point anchor = anchorM * direction((degrees(headingDeg + 90.0)).si());
            const double lowest = -0.5 * heightM + 0.5 * widthM;
            const double highest = -lowest;
            const bool inside = anchorM > lowest && anchorM < highest;
            for (const LastPass lastPass : {LastPass::Overlap, LastPass::Spread, LastPass::Gap}) {
                const ScanLine scanLine{
                    mainland,
                    {.width = metres(widthM), .overlap = {}, .lastPass = lastPass, .anchor = anchor}};
                const SwathSet set = scanLine.swaths(degrees(headingDeg));
                const std::vector<double> tracks = tracksAcross(set, {});
                const QByteArray said = QStringLiteral("seed %1, field %2, last pass %3")
                                            .arg(kSeed)
                                            .arg(i)
                                            .arg(static_cast<int>(lastPass))
                                            .toUtf8();
                VERIFY_TOLD(!tracks.empty(), said);
                VERIFY_TOLD(!inside || nearestTo(tracks, anchorM) < 1e-6, said);
                if (lastPass == LastPass::Gap) {
                    // Less than half a width is left out, and no more reaches beyond the edge.
                    VERIFY_TOLD(std::abs(tracks.front() - lowest) < 0.5 * widthM + 1e-6, said);
                    VERIFY_TOLD(std::abs(tracks.back() - highest) < 0.5 * widthM + 1e-6, said);
                    for (const double track : tracks) {
                        VERIFY_TOLD(std::abs(std::remainder(track - anchorM, widthM)) < 1e-6, said);
                    }
                    continue;
                }
                VERIFY_TOLD(std::abs(set.coverage - 1.0) < 1e-6, said);
                VERIFY_TOLD(
                    std::abs(tracks.front() - lowest) < 1e-6 && std::abs(tracks.back() - highest) < 1e-6,
                    said);
                for (std::size_t k = 1; k < tracks.size(); ++k) {
                    const double step = tracks[k] - tracks[k - 1];
                    VERIFY_TOLD(step <= widthM + 1e-6, said);
                    if (lastPass == LastPass::Overlap) {
                        // Only the outermost two may be nearer.
                        VERIFY_TOLD(k == 1 || k + 1 == tracks.size() || step > widthM - 1e-6, said);
                    } else if (inside && k > 1) {
                        // Even on either side of the line.
                        const bool atLine = std::abs(tracks[k - 1] - anchorM) < 1e-6;
                        VERIFY_TOLD(atLine || std::abs(step - (tracks[k - 1] - tracks[k - 2])) < 1e-6, said);
                    }
                }
            }
        }
    }

    void alongEveryEdge() {
        // A pentagon with a triangular hole: five edges, then three.
        const MultiPolygon polygons = test::polygonsFromWkt(
            "POLYGON((-100 -50, 100 -70, 120 40, 0 90, -110 30, -100 -50), (-20 -10, 0 20, 25 -5, -20 -10))");
        const Field field = fieldFrom(polygons);
        std::vector<double> headings;
        forEachEdge(polygons, [&](Point from, Point to) {
            headings.push_back(inDegrees(radians(std::atan2(to.y - from.y, to.x - from.x))));
        });
        QCOMPARE(headings.size(), std::size_t{8});
        for (std::size_t i = 0; i < headings.size(); ++i) {
            const auto set = run(kEdgeMethod, field, 6.0, {{&kEdge, std::to_string(i)}});
            VERIFY_RESULT(set);
            QVERIFY2(between(set->heading, headings[i]) < 1e-2,
                     qPrintable(QStringLiteral("edge %1: %2, not %3")
                                    .arg(i)
                                    .arg(inDegrees(set->heading))
                                    .arg(headings[i])));
        }
        const auto none = run(kEdgeMethod, field, 6.0, {{&kEdge, "8"}});
        QVERIFY(!none);
        QCOMPARE(none.error().code, ErrorCode::InputRefused);
        QCOMPARE(none.error().where, std::string{"swaths.edge"});
        QVERIFY2(none.error().remedy.contains("from 0 to 7"), none.error().remedy.c_str());
    }

    void refuses_data() {
        QTest::addColumn<QString>("method");
        QTest::addColumn<QString>("line");
        QTest::addColumn<ErrorCode>("code");
        QTest::newRow("AB without a line") << "ab-line" << "" << ErrorCode::Usage;
        QTest::newRow("AB with one point") << "ab-line" << "POINT (9.2 51.3)" << ErrorCode::Usage;
        QTest::newRow("AB with three points")
            << "ab-line" << "LINESTRING (9.2 51.3, 9.3 51.3, 9.4 51.3)" << ErrorCode::Usage;
        // A millionth of a degree of latitude is 0.11 m.
        QTest::newRow("AB of 0.9 m") << "ab-line" << "LINESTRING (9.2 51.3, 9.2 51.300008)"
                                     << ErrorCode::InputRefused;
        QTest::newRow("AB of nothing")
            << "ab-line" << "LINESTRING (9.2 51.3, 9.2 51.3)" << ErrorCode::InputRefused;
        QTest::newRow("A+ without a point") << "a-plus" << "" << ErrorCode::Usage;
    }
    void refuses() {
        QFETCH(QString, method);
        QFETCH(QString, line);
        QFETCH(ErrorCode, code);
        const Field field = fieldFrom({test::centredRectangle(100.0, 44.0)});
        const auto set = run(method == "ab-line" ? kAbLineMethod : kAPlusMethod, field, 6.0,
                             {{&kLine, line.toStdString()}});
        QVERIFY(!set);
        QCOMPARE(set.error().code, code);
        QCOMPARE(set.error().where, std::string{"swaths.line"});
        QVERIFY(!set.error().remedy.empty());
        QCOMPARE(set.error().place.has_value(), code == ErrorCode::InputRefused);
    }

    void justFarEnoughApart() {
        // Ten millionths of a degree of latitude are 1.11 m.
        const Field field = fieldFrom({test::centredRectangle(100.0, 44.0)});
        const auto set = run(kAbLineMethod, field, 6.0, {{&kLine, "LINESTRING (9.2 51.3, 9.2 51.30001)"}});
        VERIFY_RESULT(set);
        QVERIFY(between(set->heading, 90.0) < 1e-3);
    }

    void oksanenFindsTheLongSide_data() {
        QTest::addColumn<double>("turnedDeg");
        for (const double deg :
             {0.0, 7.0, 20.0, 33.3, 45.0, 59.0, 77.7, 90.0, 101.0, 120.0, 149.5, 165.0, 179.6}) {
            QTest::addRow("turned by %g degrees", deg) << deg;
        }
    }
    void oksanenFindsTheLongSide() {
        QFETCH(double, turnedDeg);
        const Field field =
            fieldFrom(test::moved({test::centredRectangle(300.0, 90.0)}, degrees(turnedDeg), {}));
        const auto set = run(kOksanenMethod, field, 3.0, {{&kObjective, "swath-count"}});
        VERIFY_RESULT(set);
        QVERIFY2(between(set->heading, turnedDeg) <= 1.0,
                 qPrintable(QString::number(inDegrees(set->heading))));
        // Six at first, then at most two for each of three in five rounds.
        QVERIFY(set->headingsTried > 6 && set->headingsTried <= 36);
        QVERIFY(!set->proved);
    }

    void aStoppedJobIsCancelled() {
        std::stop_source stop;
        stop.request_stop();
        const Field field = fieldFrom({test::centredRectangle(100.0, 44.0)});
        for (const auto* method : {&kAbLineMethod, &kAPlusMethod, &kEdgeMethod, &kOksanenMethod}) {
            const auto set = run(*method, field, 6.0, {{&kLine, "LINESTRING (9.2 51.3, 9.2 51.31)"}},
                                 {.stop = stop.get_token()});
            QVERIFY(!set);
            QCOMPARE(set.error().code, ErrorCode::Cancelled);
        }
    }
};

FURROW_TEST(GuidanceLinesTest);
#include "tst_guidance_lines.moc"
