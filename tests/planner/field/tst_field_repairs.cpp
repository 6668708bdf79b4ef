#include "planner/field/field.h"
#include "tests/planner/field/drawn_fields.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace furrow;
using test::allNotes;
using test::fieldSourceFromLocal;
using test::placeOf;
using test::sourceFromWkt;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const QString kSquare = QStringLiteral("POLYGON((0 0, 100 0, 100 100, 0 100, 0 0))");

/// The same set of points, wherever each ring begins, after being moved into the row's metres.
bool sameRings(const Field& field, const MultiPolygon& expected, double toleranceM) {
    const LocalFrame frame = LocalFrame::centredOn(test::kDrawnAt).value();
    const auto inRow = [&](const Ring& ring) {
        GeoRing geo = field.frame().toGeo(ring);
        return frame.toLocal(geo);
    };
    const auto same = [&](const Ring& ours, const Ring& wanted) {
        if (ours.size() != wanted.size()) {
            return false;
        }
        for (std::size_t shift = 0; shift < ours.size(); ++shift) {
            bool all = true;
            for (std::size_t i = 0; all && i < ours.size(); ++i) {
                all = distance(ours[(i + shift) % ours.size()], wanted[i]) <= toleranceM;
            }
            if (all) {
                return true;
            }
        }
        return false;
    };
    const auto samePolygon = [&](const Polygon& ours, const Polygon& wanted) {
        return ours.holes.size() == wanted.holes.size() && same(inRow(ours.outer), wanted.outer) &&
               std::ranges::all_of(wanted.holes, [&](const Ring& hole) {
                   return std::ranges::any_of(ours.holes,
                                              [&](const Ring& own) { return same(inRow(own), hole); });
               });
    };
    return field.boundary().size() == expected.size() &&
           std::ranges::all_of(expected, [&](const Polygon& wanted) {
               return std::ranges::any_of(field.boundary(),
                                          [&](const Polygon& own) { return samePolygon(own, wanted); });
           });
}

}  // namespace

/// What is mended in a boundary, and that nothing else is touched.
class FieldRepairsTest : public QObject {
    Q_OBJECT

    static void addRepeatedPointsAndSpikes() {
        QTest::newRow("point twice") << "POLYGON((0 0, 100 0, 100 0, 100 100, 0 100, 0 0))"
                                     << "1 point was given twice" << 100.0 << 0.0 << kSquare;
        QTest::newRow("points twice at several places")
            << "POLYGON((0 0, 100 0, 100 0, 100 0, 100 100, 0 100, 0 100, 0 0))"
            << "3 points were given twice" << 100.0 << 0.0 << kSquare;
        QTest::newRow("closing point twice")
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0, 0 0))" << "given twice" << 0.0 << 0.0 << kSquare;
        QTest::newRow("closing point off by half a millimetre")
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0.0003 0.0004))" << "given twice" << 0.0 << 0.0
            << kSquare;
        QTest::newRow("spike outwards")
            << "POLYGON((0 0, 50 0, 50 -30, 50 0, 100 0, 100 100, 0 100, 0 0))" << "spike" << 50.0 << -30.0
            << "POLYGON((0 0, 50 0, 100 0, 100 100, 0 100, 0 0))";
        QTest::newRow("spike inwards")
            << "POLYGON((0 0, 50 0, 50 40, 50 0, 100 0, 100 100, 0 100, 0 0))" << "spike" << 50.0 << 40.0
            << "POLYGON((0 0, 50 0, 100 0, 100 100, 0 100, 0 0))";
        QTest::newRow("spike at a corner")
            << "POLYGON((0 0, 130 0, 100 0, 100 100, 0 100, 0 0))" << "spike" << 130.0 << 0.0 << kSquare;
        QTest::newRow("spike where the ring closes")
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 -20, 0 0))" << "spike" << 0.0 << -20.0 << kSquare;
        QTest::newRow("spike at the first point")
            << "POLYGON((-20 0, 0 0, 100 0, 100 100, 0 100, 0 0, -20 0))" << "spike" << -20.0 << 0.0
            << kSquare;
        QTest::newRow("spike with a bend")
            << "POLYGON((0 0, 50 0, 50 -30, 80 -30, 50 -30, 50 0, 100 0, 100 100, 0 100, 0 0))" << "spike"
            << 80.0 << -30.0 << "POLYGON((0 0, 50 0, 100 0, 100 100, 0 100, 0 0))";
    }
    static void addWrongWaysAndTouching() {
        QTest::newRow("ring the wrong way round")
            << "POLYGON((0 0, 0 100, 100 100, 100 0, 0 0))"
            << "1 ring ran the wrong way round" << kNan << kNan << kSquare;
        QTest::newRow("hole the wrong way round")
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (40 40, 60 40, 60 60, 40 60, 40 40))"
            << "1 ring ran the wrong way round" << kNan << kNan
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (40 40, 40 60, 60 60, 60 40, 40 40))";
        QTest::newRow("both the wrong way round")
            << "POLYGON((0 0, 0 100, 100 100, 100 0, 0 0), (40 40, 60 40, 60 60, 40 60, 40 40))"
            << "2 rings ran the wrong way round" << kNan << kNan
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (40 40, 40 60, 60 60, 60 40, 40 40))";
        // One line that goes round two squares in the same direction and touches itself where they meet.
        QTest::newRow("figure of eight that touches in a point")
            << "POLYGON((0 0, 50 0, 50 50, 100 50, 100 100, 50 100, 50 50, 0 50, 0 0))" << "taken apart"
            << 50.0 << 50.0
            << "MULTIPOLYGON(((0 0, 50 0, 50 50, 0 50, 0 0)), ((50 50, 100 50, 100 100, 50 100, 50 50)))";
        QTest::newRow("a hole drawn into the outer ring touches it in a point")
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0, 30 60, 60 30, 0 0))" << "taken apart" << 0.0 << 0.0
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (0 0, 30 60, 60 30, 0 0))";
        QTest::newRow("crossing by a sliver")
            << "POLYGON((0 0, 100 0, 100 100, 50 -0.001, 0 100, 0 0))" << "crosses itself by a sliver" << 50.0
            << 0.0 << "MULTIPOLYGON(((0 0, 50 0, 0 100, 0 0)), ((50 0, 100 0, 100 100, 50 0)))";
    }
    static void addOverlaps() {
        QTest::newRow("hole partly outside the boundary")
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (80 40, 80 60, 120 60, 120 40, 80 40))" << "joined"
            << kNan << kNan << "POLYGON((0 0, 100 0, 100 40, 80 40, 80 60, 100 60, 100 100, 0 100, 0 0))";
        QTest::newRow("hole with an edge on the boundary")
            << "POLYGON((0 0, 100 0, 100 40, 100 60, 100 100, 0 100, 0 0), (80 40, 80 60, 100 60, 100 40, 80 40))"
            << "joined" << kNan << kNan
            << "POLYGON((0 0, 100 0, 100 40, 80 40, 80 60, 100 60, 100 100, 0 100, 0 0))";
        QTest::newRow("two holes that overlap")
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (20 20, 20 40, 40 40, 40 20, 20 20), "
               "(30 25, 30 45, 60 45, 60 25, 30 25))"
            << "joined" << kNan << kNan
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (20 20, 20 40, 30 40, 30 45, 60 45, 60 25, 40 25, 40 20, 20 20))";
        QTest::newRow("the same hole twice")
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (20 20, 20 40, 40 40, 40 20, 20 20), "
               "(20 20, 20 40, 40 40, 40 20, 20 20))"
            << "joined" << kNan << kNan
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (20 20, 20 40, 40 40, 40 20, 20 20))";
        QTest::newRow("parts that overlap")
            << "MULTIPOLYGON(((0 0, 100 0, 100 100, 0 100, 0 0)), ((80 10, 180 10, 180 90, 80 90, 80 10)))"
            << "joined" << kNan << kNan
            << "POLYGON((0 0, 100 0, 100 10, 180 10, 180 90, 100 90, 100 100, 0 100, 0 0))";
    }
    static void addWhatIsLeftOut() {
        // 0.0075 m², as in a register beside 6.54 ha.
        QTest::newRow("sliver beside the field")
            << "MULTIPOLYGON(((0 0, 100 0, 100 100, 0 100, 0 0)), ((200 0, 203 0, 203 0.005, 200 0)))"
            << "a sliver of 0.01 m² was left out" << 200.0 << 0.0 << kSquare;
        QTest::newRow("sliver that crosses itself")
            << "MULTIPOLYGON(((0 0, 100 0, 100 100, 0 100, 0 0)), ((200 0, 200.2 0.2, 200.2 0, 200 0.2, 200 0)))"
            << "a sliver of 0.02 m² was left out" << 200.0 << 0.0 << kSquare;
        QTest::newRow("hole without area")
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (20 20, 40 40, 20 20))"
            << "hole 1 encloses no area" << 20.0 << 20.0 << kSquare;
    }

private slots:
    void aCleanFieldIsLeftAsItIs_data() {
        QTest::addColumn<QString>("wkt");
        QTest::newRow("rectangle") << "POLYGON((0 0, 100 0, 100 60, 0 60, 0 0))";
        QTest::newRow("closing point left out") << "POLYGON((0 0, 100 0, 100 60, 0 60))";
        QTest::newRow("with a hole")
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (40 40, 40 60, 60 60, 60 40, 40 40))";
        QTest::newRow("two parts")
            << "MULTIPOLYGON(((0 0, 100 0, 100 100, 0 100, 0 0)), ((120 0, 180 0, 150 60, 120 0)))";
        QTest::newRow("points on a straight edge") << "POLYGON((0 0, 50 0, 100 0, 100 60, 0 60, 0 0))";
        QTest::newRow("a corner of one degree") << "POLYGON((0 0, 1000 0, 1000 17.455, 0 0))";
        QTest::newRow("hole touches the boundary in a vertex")
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (0 0, 30 60, 60 30, 0 0))";
        QTest::newRow("a second field within the hole of the first")
            << "MULTIPOLYGON(((0 0, 100 0, 100 100, 0 100, 0 0), (30 30, 30 70, 70 70, 70 30, 30 30)), "
               "((40 40, 60 40, 60 60, 40 60, 40 40)))";
    }
    void aCleanFieldIsLeftAsItIs() {
        QFETCH(QString, wkt);
        const FieldSource source = sourceFromWkt(wkt);
        const auto field = Field::create(source);
        VERIFY_RESULT(field);
        QVERIFY2(field->repairs().empty(), allNotes(*field).c_str());
        QVERIFY2(sameRings(*field, test::polygonsFromWkt(wkt.toStdString()), 1e-6), "rings differ");
        // Points on the ground are the given ones to the last bit.
        for (std::size_t i = 0; i < source.parts.size(); ++i) {
            for (const GeoPoint& point : field->source().parts[i].outer) {
                QVERIFY(std::ranges::find(source.parts[i].outer, point) != source.parts[i].outer.end());
            }
        }
        COMPARE_WITHIN(area(field->boundary()).si() / area(test::polygonsFromWkt(wkt.toStdString())).si(),
                       1.0, 1e-6);
        COMPARE_WITHIN(field->area().si() / area(field->boundary()).si(), 1.0, 1e-6);
        QVERIFY(field->workable() == field->boundary());
        QVERIFY(field->drivable() == field->boundary());
    }

    void repairs_data() {
        QTest::addColumn<QString>("wkt");
        QTest::addColumn<QString>("note");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<QString>("repaired");
        addRepeatedPointsAndSpikes();
        addWrongWaysAndTouching();
        addOverlaps();
        addWhatIsLeftOut();
    }
    void repairs() {
        QFETCH(QString, wkt);
        QFETCH(QString, note);
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(QString, repaired);
        const auto field = Field::create(sourceFromWkt(wkt));
        VERIFY_RESULT(field);
        const auto said = std::ranges::find_if(field->repairs(), [&](const Note& one) {
            return QString::fromStdString(one.text).contains(note);
        });
        QVERIFY2(said != field->repairs().end(), allNotes(*field).c_str());
        QCOMPARE(said->where, std::string{"the boundary"});
        QVERIFY(said->place.has_value());
        if (!std::isnan(x)) {
            COMPARE_WITHIN(placeOf(said->place).x, x, 0.01);
            COMPARE_WITHIN(placeOf(said->place).y, y, 0.01);
        }
        if (!repaired.isEmpty()) {
            const MultiPolygon expected = test::polygonsFromWkt(repaired.toStdString());
            COMPARE_WITHIN(area(field->boundary()).si(), area(expected).si(), 0.1);
            QVERIFY2(sameRings(*field, expected, 0.002), allNotes(*field).c_str());
        }
        // What was repaired needs no further repair, and is the source of the field from now on.
        const auto again = Field::create(field->source());
        VERIFY_RESULT(again);
        QVERIFY2(again->repairs().empty(), allNotes(*again).c_str());
        COMPARE_WITHIN(area(again->boundary()).si(), area(field->boundary()).si(), 1e-3);
    }

    void sliverPartsAreLeftOut() {
        // 20 m by 1 cm beside a hectare.
        const auto field = Field::create(sourceFromWkt(
            "POLYGON((0 0, 100 0, 100 100, 60 100, 60 130.01, 60.01 130, 60.01 99.9, 0 100, 0 0))"));
        VERIFY_RESULT(field);
        QCOMPARE(field->boundary().size(), std::size_t{1});
        COMPARE_WITHIN(area(field->boundary()).si(), 10'000.0, 5.0);
    }

    // Valid polygons of every kind pass unchanged.
    void generatedFieldsNeedNoRepair() {
        constexpr std::uint64_t kSeed = 77;
        std::mt19937_64 random{kSeed};
        for (int i = 0; i < 200; ++i) {
            const test::Shape shape = test::kShapes[static_cast<std::size_t>(i) % test::kShapes.size()];
            const MultiPolygon drawn = test::moved(
                test::randomPolygons(random, shape, test::uniform(random, 30.0, 600.0)), radians(0.0), {});
            const GeoPoint centre{test::uniform(random, -180.0, 180.0), test::uniform(random, -75.0, 75.0)};
            const auto field = Field::create(fieldSourceFromLocal(drawn, centre));
            const QByteArray told = QStringLiteral("seed %1, field %2").arg(kSeed).arg(i).toUtf8();
            VERIFY_TOLD(field.has_value(), told + ": " + field.error().line().c_str());
            VERIFY_TOLD(field->repairs().empty(), told + ": " + allNotes(*field).c_str());
            VERIFY_TOLD(std::abs(field->area().si() / area(drawn).si() - 1.0) < 1e-6, told);
            VERIFY_TOLD(field->vertexCount() == vertexCount(drawn), told);
        }
    }
};

FURROW_TEST(FieldRepairsTest);
#include "tst_field_repairs.moc"
