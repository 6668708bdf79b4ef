// Which files are recordings of drives, and which are boundaries.

#include "planner/io/import/boundary_import.h"
#include "planner/io/import/recorded_drive.h"
#include "planner/io/import/track_reader.h"
#include "tests/support/scratch.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace furrow;
using namespace furrow::test;

class TestRecordedDrive : public QObject {
    Q_OBJECT

private slots:
    void files_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("isDrive");
        const auto gpx = [](const QString& inside) {
            return QStringLiteral("<gpx version=\"1.1\" creator=\"t\">%1</gpx>").arg(inside);
        };
        const auto track = [](const QString& points) {
            return QStringLiteral("<trk><trkseg>%1</trkseg></trk>").arg(points);
        };
        const QString a = "<trkpt lat=\"51\" lon=\"5\"/>";
        const QString b = "<trkpt lat=\"51\" lon=\"5.01\"/>";
        const QString c = "<trkpt lat=\"51.01\" lon=\"5.01\"/>";
        const QString timed = "<trkpt lat=\"51\" lon=\"5\"><time>2026-05-04T10:00:00Z</time></trkpt>";
        QTest::newRow("GPX, closed") << "a.gpx" << gpx(track(a + b + c + a)) << false;
        QTest::newRow("GPX, closed, with times") << "a.gpx" << gpx(track(timed + b + c + timed)) << true;
        QTest::newRow("GPX, open") << "a.gpx" << gpx(track(a + b + c + b)) << true;
        QTest::newRow("GPX, a closed route")
            << "a.gpx"
            << gpx("<rte><rtept lat=\"51\" lon=\"5\"/><rtept lat=\"51\" lon=\"5.01\"/><rtept lat=\"51.01\" "
                   "lon=\"5.01\"/><rtept lat=\"51\" lon=\"5\"/></rte>")
            << false;
        QTest::newRow("GPX, waypoints") << "a.gpx" << gpx("<wpt lat=\"51\" lon=\"5\"/>") << false;
        QTest::newRow("table of corners") << "a.csv" << "lon,lat\n5,51\n5.01,51\n5.01,51.01\n" << false;
        QTest::newRow("table with times") << "a.csv" << "time_s,lon,lat\n0,5,51\n1,5.01,51\n2,5.01,51.01\n"
                                          << true;
        QTest::newRow("NMEA") << "a.log"
                              << "$GPRMC,100000,A,5130.000,N,00506.000,E,5.8,90.0,040526,,*29\r\n"
                                 "$GPRMC,100001,A,5130.000,N,00506.010,E,5.8,90.0,040526,,*29\r\n"
                              << true;
        QTest::newRow("GeoJSON")
            << "a.geojson"
            << "{\"type\":\"Polygon\",\"coordinates\":[[[5,51],[5.01,51],[5.01,51.01],[5,51]]]}" << false;
        QTest::newRow("nothing") << "a.gpx" << "" << false;
    }
    void files() {
        QFETCH(QString, name);
        QFETCH(QString, text);
        QFETCH(bool, isDrive);
        const Scratch scratch;
        const auto path = scratch.write(name.toStdString(), text.toStdString());
        const auto drive = recordedDrive(path);
        QCOMPARE(drive.has_value(), isDrive);
        QVERIFY(!drive || drive->sampleCount() > 0);
    }

    void samples_data() {
        QTest::addColumn<QString>("file");
        for (const char* file :
             {"corners.gpx", "corners_semicolon.csv", "corners_nmea.log", "odometry.mcap"}) {
            QTest::newRow(file) << file;
        }
    }
    /// Every format of recordings.
    void samples() {
        QFETCH(QString, file);
        QVERIFY(recordedDrive((QStringLiteral(FURROW_TEST_DATA_DIR "/tracks/") + file).toStdString()));
    }

    void fieldsAreNone() {
        for (const char* file : {"home_field", "bend", "three_ponds"}) {
            const std::string path =
                std::string{FURROW_SOURCE_DIR "/resources/sample_fields/"} + file + ".geojson";
            QVERIFY(!recordedDrive(path));
        }
        QVERIFY(!recordedDrive("/no/such/file.gpx"));
    }
};

FURROW_TEST(TestRecordedDrive);
#include "tst_recorded_drive.moc"
