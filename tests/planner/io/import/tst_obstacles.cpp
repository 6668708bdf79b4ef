#include "planner/field/field.h"
#include "planner/geodesy/local_frame.h"
#include "planner/io/import/boundary_import.h"
#include "tests/support/geo_rings.h"
#include "tests/support/result_check.h"
#include "tests/support/scratch.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <numbers>
#include <ranges>

using namespace furrow;
using namespace furrow::test;

namespace {

// 206 by 223 m.
constexpr const char* kField =
    R"({"type":"Feature","properties":{"kind":"field"},"geometry":{"type":"Polygon","coordinates":[[[9,52],[9.003,52],[9.003,52.002],[9,52.002],[9,52]]]}})";

std::string collection(const std::string& more) {
    return std::string{R"({"type":"FeatureCollection","features":[)"} + kField + "," + more + "]}";
}

std::string feature(const std::string& properties, const std::string& type, const std::string& coordinates) {
    return R"({"type":"Feature","properties":{)" + properties + R"(},"geometry":{"type":")" + type +
           R"(","coordinates":)" + coordinates + "}}";
}

Result<std::vector<FieldSource>> readJson(const std::string& more) {
    const Scratch scratch;
    return readBoundaries(scratch.write("f.geojson", collection(more)));
}

std::string corner(double lat, double lon) {
    return std::format(R"(<PNT A="2" C="{}" D="{}"/>)", lat, lon);
}

std::string ring(const char* kind, double south, double west, double north, double east) {
    return std::format(R"(<LSG A="{}">)", kind) + corner(south, west) + corner(south, east) +
           corner(north, east) + corner(north, west) + corner(south, west) + "</LSG>";
}

/// Of the same field, with more in it.
Result<std::vector<FieldSource>> readTask(const std::string& more) {
    const Scratch scratch;
    return readBoundaries(scratch.write(
        "TASKDATA.XML",
        R"(<ISO11783_TaskData VersionMajor="4" VersionMinor="3"><PFD A="PFD1" C="North" D="0"><PLN A="1">)" +
            ring("1", 52.0, 9.0, 52.002, 9.003) + "</PLN>" + more + "</PFD></ISO11783_TaskData>"));
}

double areaM2(const GeoPolygon& polygon) {
    return geodesicArea(polygon).si();
}

}  // namespace

/// What is in the way is read, or the file is refused with its place: it is never left out.
class TestObstacles : public QObject {
    Q_OBJECT

private slots:
    void pointsAreDiscs() {
        const auto read =
            readJson(feature(R"("kind":"obstacle","name":"Pole","buffer_m":2)", "Point", "[9.001,52.001]"));
        VERIFY_RESULT(read);
        QCOMPARE(read->front().obstacles.size(), 1U);
        const Obstacle& pole = read->front().obstacles.front();
        QCOMPARE(pole.name, std::string{"Pole"});
        // The disc is all that is kept free.
        QCOMPARE(pole.buffer.si(), 0.0);
        for (const GeoPoint& point : pole.outline.outer) {
            const double metres = metresBetween(point, {9.001, 52.001});
            QVERIFY2(metres > 1.99 && metres < 2.02, qPrintable(QString::number(metres)));
        }
        const double discM2 = std::numbers::pi * 4.0;
        QVERIFY(areaM2(pole.outline) > discM2 && areaM2(pole.outline) < 1.02 * discM2);
        VERIFY_RESULT(Field::create(read->front()));
    }

    void severalPointsAreSeveralDiscs() {
        const auto read = readJson(feature(R"("kind":"obstacle","buffer_m":1,"passable":true)", "MultiPoint",
                                           "[[9.001,52.001],[9.002,52.001]]"));
        VERIFY_RESULT(read);
        QCOMPARE(read->front().obstacles.size(), 2U);
        QVERIFY(read->front().obstacles[1].passable);
    }

    void linesAreStrips() {
        // 111.3 m to the north: 3 m broad, with half discs at its ends.
        const auto read = readJson(feature(R"("kind":"obstacle","buffer_m":1.5)", "LineString",
                                           "[[9.001,52.0005],[9.001,52.0015]]"));
        VERIFY_RESULT(read);
        QCOMPARE(read->front().obstacles.size(), 1U);
        const Obstacle& fence = read->front().obstacles.front();
        QCOMPARE(fence.buffer.si(), 0.0);
        const double stripM2 = 111.27 * 3.0 + std::numbers::pi * 2.25;
        QVERIFY2(std::abs(areaM2(fence.outline) - stripM2) < 0.01 * stripM2,
                 qPrintable(QString::number(areaM2(fence.outline))));
    }

    void areasKeepTheirBuffer() {
        const auto read =
            readJson(feature(R"("kind":"obstacle","buffer_m":1.5)", "Polygon",
                             "[[[9.001,52.001],[9.0011,52.001],[9.0011,52.0011],[9.001,52.001]]]"));
        VERIFY_RESULT(read);
        QCOMPARE(read->front().obstacles.front().buffer.si(), 1.5);
        QCOMPARE(read->front().obstacles.front().overhang.si(), 0.0);
    }

    void overhangsAreRead() {
        const auto read =
            readJson(feature(R"("kind":"obstacle","buffer_m":1.5,"overhang_m":6)", "Polygon",
                             "[[[9.001,52.001],[9.0011,52.001],[9.0011,52.0011],[9.001,52.001]]]"));
        VERIFY_RESULT(read);
        QCOMPARE(read->front().obstacles.front().overhang.si(), 6.0);
    }

    void refusesJson_data() {
        QTest::addColumn<QString>("feature");
        QTest::addColumn<QString>("message");
        QTest::addColumn<bool>("hasPlace");
        const auto row = [](const char* name, const std::string& json, const char* message,
                            bool hasPlace = true) {
            QTest::newRow(name) << QString::fromStdString(json) << QString::fromUtf8(message) << hasPlace;
        };
        const std::string area = "[[[9.001,52.001],[9.0011,52.001],[9.0011,52.0011],[9.001,52.001]]]";
        row("point without a buffer",
            feature(R"("kind":"obstacle","name":"Pole")", "Point", "[9.001,52.001]"),
            "f.geojson, obstacle Pole: it is a point at 9.0010000, 52.0010000 without a size");
        row("line without a buffer",
            feature(R"("kind":"obstacle","buffer_m":0)", "LineString", "[[9.001,52.001],[9.002,52.001]]"),
            "it is a line at 9.0010000, 52.0010000 without a width");
        row("no shape",
            R"({"type":"Feature","properties":{"kind":"obstacle","name":"Pole"},"geometry":null})",
            "f.geojson, obstacle Pole: it has no shape", false);
        row("area without a kind", feature(R"("name":"Pond")", "Polygon", area),
            "f.geojson, feature 2: it does not say what it is");
        row("area of another kind", feature(R"("kind":"pond")", "Polygon", area),
            "f.geojson, feature 2: its kind 'pond' is not known");
        row("hole that is a line",
            feature(R"("kind":"hole","name":"Pond")", "LineString", "[[9.001,52.001],[9.002,52.001]]"),
            "f.geojson, hole Pond: it is no closed line", false);
    }
    void refusesJson() {
        QFETCH(QString, feature);
        QFETCH(QString, message);
        QFETCH(bool, hasPlace);
        const auto read = readJson(feature.toStdString());
        QVERIFY(!read);
        QVERIFY2(read.error().line().contains(message.toStdString()), read.error().line().c_str());
        QVERIFY(read.error().code == ErrorCode::InputRefused);
        QVERIFY(!read.error().remedy.empty());
        QCOMPARE(read.error().place.has_value(), hasPlace);
    }

    void holesOfTheirOwnPolygons() {
        // As machines write them.
        const auto read =
            readTask("<PLN A=\"1\">" + ring("2", 52.0005, 9.001, 52.0006, 9.0011) + "</PLN><PLN A=\"1\">" +
                     ring("2", 52.0010, 9.001, 52.0011, 9.0011) + "</PLN>");
        VERIFY_RESULT(read);
        QCOMPARE(read->front().parts.size(), 1U);
        QCOMPARE(read->front().parts.front().holes.size(), 2U);
    }

    void obstacleLinesOfTasks() {
        const auto read = readTask(R"(<LSG A="9" B="Fence" C="3000">)" + corner(52.0005, 9.001) +
                                   corner(52.0015, 9.001) + "</LSG>");
        VERIFY_RESULT(read);
        QCOMPARE(read->front().obstacles.size(), 1U);
        const double stripM2 = 111.27 * 3.0 + std::numbers::pi * 2.25;
        const double gotM2 = areaM2(read->front().obstacles.front().outline);
        QVERIFY2(std::abs(gotM2 - stripM2) < 0.01 * stripM2, qPrintable(QString::number(gotM2)));
    }

    void areasAcrossTheWholeField() {
        // No corner of either lies in the other.
        const auto read =
            readTask("<PLN A=\"6\" B=\"Ditch\">" + ring("1", 52.0010, 8.999, 52.0011, 9.004) + "</PLN>");
        VERIFY_RESULT(read);
        QCOMPARE(read->front().obstacles.size(), 1U);
    }

    void roadsMayBeDriven() {
        const auto read = readTask("<PLN A=\"5\">" + ring("1", 52.0010, 8.999, 52.0011, 9.004) + "</PLN>");
        VERIFY_RESULT(read);
        QCOMPARE(read->front().obstacles.size(), 1U);
        QVERIFY(read->front().obstacles.front().passable);
    }

    void largerAreasThanTheHoleBeside() {
        // Both begin at the same corner; the obstacle is twice as large, and no twin.
        const auto read =
            readTask("<PLN A=\"1\">" + ring("2", 52.0005, 9.001, 52.0006, 9.0011) + "</PLN><PLN A=\"6\">" +
                     ring("1", 52.0005, 9.001, 52.0006, 9.0012) + "</PLN>");
        VERIFY_RESULT(read);
        QCOMPARE(read->front().obstacles.size(), 1U);
        const auto twin =
            readTask("<PLN A=\"1\">" + ring("2", 52.0005, 9.001, 52.0006, 9.0011) + "</PLN><PLN A=\"6\">" +
                     ring("1", 52.0005, 9.001, 52.0006, 9.0011) + "</PLN>");
        VERIFY_RESULT(twin);
        QVERIFY(twin->front().obstacles.empty());
    }

    void refusesTasks_data() {
        QTest::addColumn<QString>("more");
        QTest::addColumn<QString>("message");
        QTest::newRow("obstacle point")
            << R"(<PNT A="5" B="Pole" C="52.001" D="9.001"/>)"
            << "field 'North', obstacle Pole: it is a point at 9.0010000, 52.0010000 without a size";
        QTest::newRow("obstacle line without a width")
            << QString::fromStdString(R"(<LSG A="9" B="Fence">)" + corner(52.001, 9.001) +
                                      corner(52.001, 9.002) + "</LSG>")
            << "obstacle Fence: it is a line at 9.0010000, 52.0010000 without a width";
        QTest::newRow("hole with a place that is none")
            << R"(<PLN A="1"><LSG A="2"><PNT A="2" C="north" D="9.001"/><PNT A="2" C="52" D="9"/></LSG></PLN>)"
            << "'north', '9.001' is no latitude and longitude";
        QTest::newRow("obstacle with a place that is none")
            << R"(<PLN A="6"><LSG A="1"><PNT A="2" C="52.001" D="900"/><PNT A="2" C="52" D="9"/></LSG></PLN>)"
            << "'52.001', '900' is no latitude and longitude";
    }
    void refusesTasks() {
        QFETCH(QString, more);
        QFETCH(QString, message);
        const auto read = readTask(more.toStdString());
        QVERIFY(!read);
        QVERIFY2(read.error().line().contains(message.toStdString()), read.error().line().c_str());
        QVERIFY(read.error().code == ErrorCode::InputRefused);
        QVERIFY(!read.error().remedy.empty());
    }
};

FURROW_TEST(TestObstacles);
#include "tst_obstacles.moc"
