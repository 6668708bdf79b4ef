#include "planner/swaths/methods.h"
#include "planner/swaths/tramlines.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace furrow;

namespace {

constexpr GeoPoint kCentre{9.2, 51.3};

Settings settingsOf(std::initializer_list<std::pair<const Parameter*, std::string>> given) {
    Settings settings;
    for (const auto& [parameter, text] : given) {
        settings.setText(*parameter, text).value();
    }
    return settings;
}

Machine drill(double widthM) {
    MachineSpec spec = findMachine("agbot")->spec();
    spec.implement.operatingWidth = metres(widthM);
    return Machine::create(spec).value();
}

/// Northings of the tramlines of level swaths, to the decimetre.
std::set<long> tramlinesAt(const SwathSet& set) {
    std::set<long> places;
    for (const Swath& swath : set.swaths) {
        if (swath.tramline) {
            places.insert(std::lround(swath.start.y * 10.0));
        }
    }
    return places;
}

}  // namespace

class TramlinesTest : public QObject {
    Q_OBJECT

private slots:
    // A 3 m drill and a 24 m sprayer on 72 m: every eighth of 24 swaths, counted from 1 at the right.
    void everyEighth_data() {
        QTest::addColumn<QString>("start");
        QTest::addColumn<QList<int>>("numbers");
        QTest::newRow("from the right") << "right" << QList<int>{1, 9, 17};
        QTest::newRow("from the left") << "left" << QList<int>{8, 16, 24};
        // The sprayer's half, 12 m, ends between the fourth and the fifth from the left: 21 reaches beyond
        // the edge.
        QTest::newRow("half way in") << "half" << QList<int>{5, 13, 21};
    }
    void everyEighth() {
        QFETCH(QString, start);
        QFETCH(QList<int>, numbers);
        SwathSet set = test::swathsOf({test::rectangle(200.0, 72.0)}, 3.0, 0.0);
        QCOMPARE(set.swaths.size(), std::size_t{24});
        markTramlines(set, settingsOf({{&kTramlineEvery, "8"}, {&kTramlineStart, start.toStdString()}}));
        QList<int> marked;
        for (const Swath& swath : set.swaths) {
            if (swath.tramline) {
                marked << swath.number;
            }
        }
        QCOMPARE(marked, numbers);
    }

    void noneByDefault() {
        SwathSet set = test::swathsOf({test::rectangle(200.0, 72.0)}, 3.0, 0.0);
        markTramlines(set, {});
        QVERIFY(std::ranges::none_of(set.swaths, &Swath::tramline));
    }

    // Next season the headland is wider and the boundary was surveyed again: the same AB line has its
    // tramlines where they were, and whichever way it was drawn.
    void anAbLineKeepsThemOverTheSeasons_data() {
        QTest::addColumn<QString>("start");
        QTest::addColumn<bool>("curve");
        QTest::newRow("left") << "left" << false;
        QTest::newRow("half") << "half" << false;
        QTest::newRow("left, as a curve") << "left" << true;
        QTest::newRow("half, as a curve") << "half" << true;
    }
    void anAbLineKeepsThemOverTheSeasons() {
        QFETCH(QString, start);
        QFETCH(bool, curve);
        const Field field =
            Field::create(test::fieldSourceFromLocal({test::centredRectangle(300.0, 150.0)}, kCentre))
                .value();
        const GeoPoint a = field.frame().toGeo(Point{-50.0, 3.0});
        const GeoPoint b = field.frame().toGeo(Point{60.0, 3.0});
        const std::string line = QStringLiteral("LINESTRING (%1 %2, %3 %4)")
                                     .arg(a.lonDeg, 0, 'f', 12)
                                     .arg(a.latDeg, 0, 'f', 12)
                                     .arg(b.lonDeg, 0, 'f', 12)
                                     .arg(b.latDeg, 0, 'f', 12)
                                     .toStdString();
        const Settings settings =
            settingsOf({{&kLine, line}, {&kTramlineEvery, "4"}, {&kTramlineStart, start.toStdString()}});
        const auto tramlines = [&](const MultiPolygon& mainland) {
            const Machine machine = drill(3.0);
            const auto set =
                (curve ? kAbCurveMethod : kAbLineMethod)
                    .run({.field = field, .mainland = mainland, .machine = machine, .settings = settings},
                         {});
            SwathSet marked = set.value();
            markTramlines(marked, settings);
            return tramlinesAt(marked);
        };
        const std::set<long> first = tramlines({test::rectangle(280.0, 130.0, {-140.0, -65.0})});
        const std::set<long> second = tramlines({test::rectangle(270.0, 118.5, {-135.0, -58.2})});
        // On the line itself, or two widths beside it; 12 m apart. What is inside both is in both.
        const std::set<long> wanted =
            start == "half" ? std::set<long>{-510, -390, -270, -150, -30, 90, 210, 330, 450, 570}
                            : std::set<long>{-450, -330, -210, -90, 30, 150, 270, 390, 510};
        for (const long place : wanted) {
            QVERIFY2(first.contains(place), qPrintable(QString::number(place)));
            QVERIFY2(second.contains(place), qPrintable(QString::number(place)));
        }
        for (const long place : second) {
            QVERIFY2(first.contains(place), qPrintable(QString::number(place)));
        }
    }
};

FURROW_TEST(TramlinesTest);
#include "tst_tramlines.moc"
