#include "planner/sheet/map_layout.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace furrow;

// Everything here was worked out on paper.
class TestMapLayout : public QObject {
    Q_OBJECT

private slots:
    void scalesAreRound_data() {
        QTest::addColumn<double>("widthM");
        QTest::addColumn<double>("heightM");
        QTest::addColumn<double>("scale");
        // On 150 by 100 mm.
        QTest::newRow("fits exactly") << 300.0 << 200.0 << 2000.0;
        QTest::newRow("a little more") << 301.0 << 200.0 << 2500.0;
        QTest::newRow("the height decides") << 300.0 << 260.0 << 3000.0;
        QTest::newRow("one and a quarter") << 187.5 << 10.0 << 1250.0;
        QTest::newRow("kilometres") << 3100.0 << 2000.0 << 25000.0;
        QTest::newRow("a garden") << 10.0 << 4.0 << 100.0;
        QTest::newRow("a point") << 0.0 << 0.0 << 100.0;
    }
    void scalesAreRound() {
        QFETCH(double, widthM);
        QFETCH(double, heightM);
        QFETCH(double, scale);
        QCOMPARE(roundMapScale({{-5.0, 7.0}, {widthM - 5.0, heightM + 7.0}}, 150.0, 100.0), scale);
    }

    void boxesThatTouchDoNotOverlap() {
        const PaperBox box{{10.0, 10.0}, 5.0, 2.0};
        QVERIFY(!box.overlaps({{15.0, 10.0}, 5.0, 2.0}));
        QVERIFY(!box.overlaps({{10.0, 12.0}, 5.0, 2.0}));
        QVERIFY(box.overlaps({{14.9, 11.9}, 5.0, 2.0}));
        QVERIFY(box.holds({{10.0, 10.0}, 5.0, 2.0}));
        QVERIFY(!box.holds({{10.0, 10.0}, 5.1, 2.0}));
    }

    void theFirstFreePlaceIsTaken() {
        LabelPlaces places{{{0.0, 0.0}, 100.0, 50.0}};
        places.block({{18.0, 18.0}, 4.0, 4.0});
        const LabelWish wish{
            .places = {{20.0, 20.0}, {99.0, 20.0}, {40.0, 20.0}}, .width = 6.0, .height = 3.0};
        // The first is taken, the second stands out on the right.
        QCOMPARE(places.place(wish), std::optional(Point{40.0, 20.0}));
        QVERIFY(!places.place(wish));
    }

    void allNumbersWhereThereIsRoom() {
        std::vector<LabelWish> wishes;
        wishes.reserve(10);
        for (int i = 0; i < 10; ++i) {
            wishes.push_back({.places = {{50.0, 10.0 + 3.0 * i}}, .width = 5.0, .height = 2.9});
        }
        LabelPlaces places{{{0.0, 0.0}, 100.0, 100.0}};
        for (const auto& place : placeNumbers(wishes, places)) {
            QVERIFY(place.has_value());
        }
    }

    void closeLinesAreNumberedInSteps() {
        // A millimetre apart: of every one and of every second number most overlap; 1, 5 and 10 do not.
        std::vector<LabelWish> wishes;
        wishes.reserve(10);
        for (int i = 0; i < 10; ++i) {
            wishes.push_back({.places = {{50.0, 10.0 + i}}, .width = 5.0, .height = 2.9});
        }
        LabelPlaces places{{{0.0, 0.0}, 100.0, 100.0}};
        const auto placed = placeNumbers(wishes, places);
        for (std::size_t i = 0; i < placed.size(); ++i) {
            QCOMPARE(placed[i].has_value(), i == 0 || i == 4 || i == 9);
        }
        // They are taken from now on.
        QVERIFY(!places.place(wishes[4]));
    }

    void noLinesNoNumbers() {
        LabelPlaces places{{{0.0, 0.0}, 10.0, 10.0}};
        QVERIFY(placeNumbers({}, places).empty());
    }

    void pointsOnALine() {
        const Polyline corner{{0.0, 0.0}, {10.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}};
        const PointOnLine later = pointAt(corner, 0.75);
        COMPARE_WITHIN(later.place.x, 10.0, 1e-12);
        COMPARE_WITHIN(later.place.y, 5.0, 1e-12);
        COMPARE_WITHIN(later.way.y, 1.0, 1e-12);
        QCOMPARE(pointAt(corner, 0.0).place, (Point{0.0, 0.0}));
        QCOMPARE(pointAt(corner, 1.0).place, (Point{10.0, 10.0}));
        QCOMPARE(pointAt(Polyline{{3.0, 4.0}, {3.0, 4.0}}, 0.5).way, Point{});
    }
};

FURROW_TEST(TestMapLayout);
#include "tst_map_layout.moc"
