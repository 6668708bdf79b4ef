// The lines that task data holds of a plan.

#include "planner/io/content/plan_content.h"
#include "planner/swaths/guide_data.h"
#include "tests/planner/io/formats/isoxml_cases.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <regex>

using namespace furrow;
using namespace furrow::test;

class TestIsoxmlLines : public QObject {
    Q_OBJECT

private slots:
    void lineLiesOnTheLongestSwathOfItsTrack_data();
    void lineLiesOnTheLongestSwathOfItsTrack();
    void oneLineForEachDirection();
    void curvesAndPivots();
    void tramlinesAreLinesOfTheirOwn();
    void tramlinesBesideAPlus();

private:
    static void addCases();
    static std::shared_ptr<const Plan> currentPlan();
};

void TestIsoxmlLines::addCases() {
    QTest::addColumn<int>("index");
    for (int i = 0; i < static_cast<int>(std::size(kTaskDataCases)); ++i) {
        QTest::newRow(kTaskDataCases[i].name) << i;
    }
}

std::shared_ptr<const Plan> TestIsoxmlLines::currentPlan() {
    QFETCH(int, index);
    return planOf(kTaskDataCases[index].field());
}

void TestIsoxmlLines::lineLiesOnTheLongestSwathOfItsTrack_data() {
    addCases();
}

void TestIsoxmlLines::lineLiesOnTheLongestSwathOfItsTrack() {
    const auto plan = currentPlan();
    QVERIFY(plan);
    const Element field = parsed(isoxmlTaskData(*plan)).all("PFD").first();
    QCOMPARE(field.all("GGP").size(), 1);
    const Element group = field.all("GGP").first();
    QCOMPARE(group.value("A"), "GGP1");
    QCOMPARE(group.all("GPN").size(), 1);
    const Element pattern = group.all("GPN").first();
    QCOMPARE(pattern.value("A"), "GPN1");
    QCOMPARE(pattern.value("C"), "1");
    QCOMPARE(pattern.value("E"), "1");
    QCOMPARE(pattern.value("F"), "1");
    QCOMPARE(pattern.value("I"), "16");
    QCOMPARE(pattern.all("LSG").size(), 1);
    const Element line = pattern.all("LSG").first();
    QCOMPARE(line.value("A"), "5");
    QCOMPARE(line.value("C"), "2500");  // the AgBot's 2.5 m
    const QList<Element> points = line.all("PNT");
    QCOMPARE(points.size(), 2);
    QCOMPARE(points[0].value("A"), "6");
    QCOMPARE(points[1].value("A"), "7");
    const Swath* longest = &plan->swaths.swaths.front();
    for (const Swath& swath : plan->swaths.swaths) {
        if (swath.track == longest->track && swath.length() > longest->length()) {
            longest = &swath;
        }
    }
    const GeoRing ends = ringOf(line);
    QVERIFY(near(ends[0], plan->field().frame().toGeo(longest->start)));
    QVERIFY(near(ends[1], plan->field().frame().toGeo(longest->end)));
    // The heading by the plain formula on a sphere; the flattening of the earth turns it by up to 0.2
    // degrees.
    const double east =
        std::remainder(ends[1].lonDeg - ends[0].lonDeg, 360.0) * std::cos(ends[0].latDeg * M_PI / 180.0);
    const double north = ends[1].latDeg - ends[0].latDeg;
    const double bearing = std::fmod(std::atan2(east, north) * 180.0 / M_PI + 360.0, 360.0);
    const double written = pattern.value("G").toDouble();
    QVERIFY2(written >= 0.0 && written < 360.0, qPrintable(pattern.value("G")));
    QVERIFY2(std::abs(std::remainder(written - bearing, 360.0)) < 0.25,
             std::format("{} instead of {}", written, bearing).c_str());
}

void TestIsoxmlLines::oneLineForEachDirection() {
    Plan plan = *planOf(plainField().field);
    const auto swath = [](Point from, Point to, int track) {
        return Swath{.start = from, .end = to, .number = 0, .track = track, .width = metres(2.5)};
    };
    plan.swaths.swaths = {swath({0, 0}, {10, 0}, 0),     swath({20, 0}, {50, 0}, 0),
                          swath({0, 2.5}, {90, 2.5}, 1), swath({0, 9}, {0, 40}, 2),
                          swath({90, 5}, {0, 5}, 3),     swath({3, 40}, {3, 0}, 4)};
    const Element field = parsed(isoxmlTaskData(plan)).all("PFD").first();
    QCOMPARE(field.all("GGP").size(), 2);
    const GeoRing eastward = ringOf(field.all("GGP")[0].all("GPN").first().all("LSG").first());
    QVERIFY(near(eastward[0], plan.field().frame().toGeo(Point{20, 0})));
    QVERIFY(near(eastward[1], plan.field().frame().toGeo(Point{50, 0})));
    QCOMPARE(field.all("GGP")[0].all("GPN").first().value("G"), "90.0000");
    QCOMPARE(field.all("GGP")[1].all("GPN").first().value("G"), "0.0000");
    QCOMPARE(field.all("GGP")[1].value("A"), "GGP2");
}

// ISO 11783-10: type 3 is a curve from point 6 over points 9 to point 7; type 4 with option 3 a full circle
// about point 8 with its radius in millimetres. One stands for all that lie beside it.
void TestIsoxmlLines::curvesAndPivots() {
    const auto curve = planWith(
        plainField().field,
        {{"swaths.method", "ab-curve"},
         {"swaths.line",
          "LINESTRING ("
          "9.000500 52.000800, 9.000667 52.000818, 9.000833 52.000833, 9.001000 52.000845, 9.001167 52.000853, "
          "9.001333 52.000858, 9.001500 52.000860, 9.001667 52.000858, 9.001833 52.000853, "
          "9.002000 52.000845, 9.002167 52.000833, 9.002333 52.000818, 9.002500 52.000800)"}});
    QVERIFY(curve);
    const QList<Element> curves = parsed(isoxmlTaskData(*curve)).all("PFD").first().all("GGP");
    // And those whose bends are lost to the inside.
    QVERIFY(!curves.isEmpty() && curves.size() < 5);
    const Element pattern = curves.first().all("GPN").first();
    QCOMPARE(pattern.value("C"), "3");
    QCOMPARE(pattern.value("E"), "1");
    const QList<Element> points = pattern.all("LSG").first().all("PNT");
    QVERIFY(points.size() > 2);
    for (qsizetype i = 0; i < points.size(); ++i) {
        QCOMPARE(points[i].value("A"), i == 0 ? "6" : i + 1 == points.size() ? "7" : "9");
    }
    checkSchema(*curve);

    // A round field: rings only.
    FieldSource round = plainField().field;
    round.parts.front().outer.clear();
    for (int i = 0; i < 90; ++i) {
        const double angle = i * M_PI / 45.0;
        round.parts.front().outer.push_back(
            {9.0 + 0.0015 * std::cos(angle),
             52.0 + 0.0015 * std::cos(52.0 * M_PI / 180.0) * std::sin(angle)});
    }
    const auto pivot = planWith(round, {{"swaths.method", "pivot"}, {"swaths.line", "POINT (9 52)"}});
    QVERIFY(pivot);
    QVERIFY(pivot->swaths.swaths[3].isClosed());
    bool found = false;
    for (const Element& group : parsed(isoxmlTaskData(*pivot)).all("PFD").first().all("GGP")) {
        const Element ring = group.all("GPN").first();
        if (ring.value("C") == "4") {
            QVERIFY(!found);
            found = true;
            QCOMPARE(ring.value("D"), "3");
            const double radiusM = pivot->swaths.swaths.front().isClosed()
                                       ? pivot->swaths.swaths.front().length().si() / (2.0 * M_PI)
                                       : 0.0;
            if (radiusM > 0.0) {
                QVERIFY(std::abs(ring.value("H").toDouble() - 1000.0 * radiusM) <= 1.0);
            }
            QCOMPARE(ring.all("LSG").first().all("PNT").size(), 1);
            QCOMPARE(ring.all("LSG").first().all("PNT").first().value("A"), "8");
        }
    }
    QVERIFY(found);
    checkSchema(*pivot);
}

// Beside the AB line a group for each tramline, which is not laid beside itself (propagation 4).
void TestIsoxmlLines::tramlinesAreLinesOfTheirOwn() {
    const auto plan = planWith(plainField().field, {{"swaths.tramline_every", "8"}});
    QVERIFY(plan);
    const auto tramlines = std::ranges::count_if(plan->swaths.swaths, &Swath::tramline);
    QVERIFY(tramlines > 3);
    int written = 0;
    for (const Element& group : parsed(isoxmlTaskData(*plan)).all("PFD").first().all("GGP")) {
        if (group.value("B").startsWith("Tramline")) {
            ++written;
            QCOMPARE(group.all("GPN").first().value("C"), "1");
            QCOMPARE(group.all("GPN").first().value("E"), "4");
        }
    }
    QCOMPARE(written, tramlines);
    checkSchema(*plan);
}

void TestIsoxmlLines::tramlinesBesideAPlus() {
    const auto plan = planWith(plainField().field, {{"swaths.method", "a-plus"},
                                                    {"swaths.line", "POINT(9.0005 52.0005)"},
                                                    {"swaths.angle_deg", "30"},
                                                    {"swaths.tramline_every", "8"}});
    QVERIFY(plan);
    const auto tramlines = std::ranges::count_if(plan->swaths.swaths, &Swath::tramline);
    QVERIFY(tramlines > 3);
    qsizetype once = 0;
    qsizetype aPlus = 0;
    for (const Element& group : parsed(isoxmlTaskData(*plan)).all("PFD").first().all("GGP")) {
        const Element pattern = group.all("GPN").first();
        aPlus +=
            pattern.value("C") == "2" && pattern.value("E") == "1" && pattern.value("G") == "60.0000" ? 1 : 0;
        once += pattern.value("C") == "1" && pattern.value("E") == "4" ? 1 : 0;
    }
    QCOMPARE(aPlus, 1);
    QCOMPARE(once, tramlines);
    checkSchema(*plan);
}

FURROW_TEST(TestIsoxmlLines);
#include "tst_isoxml_lines.moc"
