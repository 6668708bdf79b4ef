// Recorded tracks that cannot be read, cut off or damaged anywhere.

#include "planner/io/import/track_reader.h"
#include "tests/planner/io/import/track_samples.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <limits>
#include <random>

using namespace furrow;
using namespace furrow::test;

class TestRefusedTracks : public QObject {
    Q_OBJECT

private slots:
    void refusals_data();
    void refusals();
    void nothingIsWrittenBesideAZip();
    void cutOffAnywhere_data();
    void cutOffAnywhere();
    void damagedAnywhere_data();
    void damagedAnywhere();
};

void TestRefusedTracks::refusals_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<bool>("readFailed");
    QTest::addColumn<QString>("part");
    const auto row = [](const char* title, const char* name, const QByteArray& bytes, bool readFailed,
                        const char* part) { QTest::newRow(title) << name << bytes << readFailed << part; };
    row("empty", "a.csv", "", false, "the file is empty");
    row("blank", "a.csv", "\n\n", false, "no header names");
    row("no header", "a.csv", "1,2\n3,4\n", false, "no header names");
    row("header alone", "a.csv", "lon,lat\n", false, "no row");
    row("NaN in a table", "a.csv", "lon,lat\n5,52\nnan,52\n", false, "line 3");
    row("words in a table", "a.csv", "lon,lat\n5,here\n", false, "'5', 'here' is no position");
    row("latitude beyond the pole", "a.csv", "lon,lat\n5,91\n", false, "line 2");
    row("infinite metres", "a.csv", "x_m,y_m\n1,1e300\n", false, "line 2");
    row("GPX cut off", "a.gpx", "<?xml version=\"1.0\"?><gpx><trk><trkseg><trkpt lat=\"1\"", true, "damaged");
    row("GPX with NaN", "a.gpx", "<gpx><trk><trkseg><trkpt lat=\"nan\" lon=\"5\"/></trkseg></trk></gpx>",
        false, "point 1");
    row("GPX without latitude", "a.gpx", "<gpx><trk><trkseg><trkpt lon=\"5\"/></trkseg></trk></gpx>", false,
        "is no place on Earth");
    row("GPX with waypoints only", "a.gpx", "<gpx><wpt lat=\"1\" lon=\"2\"/></gpx>", false, "no track");
    row("XML of another kind", "a.xml", "<kml><Document/></kml>", false, "'kml' files");
    row("gpsd without a fix", "a.log", "{\"class\":\"TPV\",\"mode\":1}\n", false, "none of its 1 position");
    row("NMEA without a fix", "a.log", "$GPRMC,100000.00,V,,,,,,,040526,,,N\n", false, "none of its 1 RMC");
    row("NMEA damaged", "a.log", "$GPRMC,100000.00,A,5205.4,N,00539.6,E,0,0,040526,,,R*00\n", true,
        "wrong checksum");
    row("NMEA of absurd numbers", "a.log", "$GPRMC,9e99,A,1e308,N,-5,E,inf,nan,999999,,,R\n", false,
        "none of");
    row("ROS 1", "a.bag", "#ROSBAG V2.0\n", false, "ROS 1");
    row("no track at all", "a.png", QByteArray{"\x89PNG\r\n\x1a\n\0\0\0", 11}, false,
        "no track that can be read");
    row("MCAP with a record that leads back to itself", "a.mcap",
        QByteArray{"\x89MCAP0\r\n\x10\xF7\xFF\xFF\xFF\xFF\xFF\xFF\xFF", 17}, true, "cut off");
    row("MCAP with nothing behind its magic", "a.mcap", QByteArray{"\x89MCAP0\r\n", 8}, true, "cut off");
    row("MCAP chunk of absurd size", "a.mcap",
        QByteArray{"\x89MCAP0\r\n\x06\xff\xff\xff\xff\xff\xff\xff\x7f", 17}, false, "256 MiB");
    row("MCAP chunk larger than its file", "a.mcap",
        QByteArray{"\x89MCAP0\r\n\x06\xff\xff\xff\x0f\0\0\0\0", 17}, true, "cut off");
    row("sqlite3 cut off", "a.db3", QByteArray{"SQLite format 3\0", 16} + QByteArray(50, '\0'), true,
        "no rosbag2");
    row("a zip that is none", "a.zip", "PK\x03\x04 and nothing more", true, "damaged");
}

void TestRefusedTracks::refusals() {
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    QFETCH(bool, readFailed);
    QFETCH(QString, part);
    const QTemporaryDir folder;
    const auto read = readTracks(pathOf(written(folder, name, bytes)));
    QVERIFY(!read);
    QVERIFY2(read.error().line().find(part.toStdString()) != std::string::npos, read.error().line().c_str());
    QCOMPARE(read.error().code, readFailed ? ErrorCode::ReadFailed : ErrorCode::InputRefused);
    QVERIFY(!read.error().remedy.empty());
    QVERIFY(read.error().where.find(name.toStdString()) != std::string::npos);
    QVERIFY(read.error().line().find('\n') == std::string::npos);
}

void TestRefusedTracks::nothingIsWrittenBesideAZip() {
    const QTemporaryDir folder;
    const QString zip = written(folder, "inner/job.zip", bytesOf(sample("corners_isoxml.zip")));
    QVERIFY(readTracks(pathOf(zip)));
    QCOMPARE(QDir{folder.path()}.entryList(QDir::AllEntries | QDir::NoDotAndDotDot), QStringList{"inner"});
    QCOMPARE(QDir{folder.filePath("inner")}.entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
             QStringList{"job.zip"});
    const QString bag = written(folder, "bag/drive_0.db3", bytesOf(sample("rosbag_sqlite3/drive_0.db3")));
    QVERIFY(readTracks(pathOf(bag)));
    QCOMPARE(QDir{folder.filePath("bag")}.entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
             QStringList{"drive_0.db3"});
}

void TestRefusedTracks::cutOffAnywhere_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<bool>("mustFail");  // text of lines may end early
    for (const char* file : {"corners.gpx", "corners_isoxml.zip", "odometry.mcap", "path.mcap"}) {
        QTest::newRow(file) << file << true;
    }
    for (const char* file : {"corners_semicolon.csv", "corners_yield_monitor.txt", "corners_gpsd.log",
                             "corners_nmea.log", "rosbag_sqlite3/drive_0.db3"}) {
        QTest::newRow(file) << file << false;
    }
}

void TestRefusedTracks::cutOffAnywhere() {
    QFETCH(QString, file);
    QFETCH(bool, mustFail);
    const QByteArray whole = bytesOf(sample(file));
    QVERIFY(!whole.isEmpty());
    const QTemporaryDir folder;
    // Behind the end of what is read there may be something nobody needs: blanks, an index.
    const qsizetype last = mustFail ? whole.size() - 60 : whole.size();
    const qsizetype step = std::max<qsizetype>(1, whole.size() / 250);
    for (qsizetype size = 0; size < last; size += step) {
        const auto read = readTracks(pathOf(written(folder, QFileInfo{file}.fileName(), whole.first(size))));
        QVERIFY2(!mustFail || !read, qPrintable(QString::number(size)));
        QVERIFY(read || !read.error().remedy.empty());
    }
}

void TestRefusedTracks::damagedAnywhere_data() {
    QTest::addColumn<QString>("file");
    for (const char* file :
         {"corners.gpx", "corners_isoxml.zip", "odometry.mcap", "path.mcap", "corners_nmea.log",
          "corners_semicolon.csv", "corners_gpsd.log", "rosbag_sqlite3/drive_0.db3"}) {
        QTest::newRow(file) << file;
    }
}

/// Whatever a byte becomes: every place that is read is finite, and nothing crashes.
void TestRefusedTracks::damagedAnywhere() {
    QFETCH(QString, file);
    const QByteArray whole = bytesOf(sample(file));
    const QTemporaryDir folder;
    std::mt19937 random{20260504};
    for (int i = 0; i < 200; ++i) {
        QByteArray bytes = whole;
        for (int k = 0; k < 1 + i % 3; ++k) {
            bytes[static_cast<qsizetype>(random() % static_cast<unsigned>(bytes.size()))] =
                static_cast<char>(random() & 0xFFU);
        }
        const auto read = readTracks(pathOf(written(folder, QFileInfo{file}.fileName(), bytes)));
        if (!read) {
            continue;
        }
        for (const RecordedTrack& track : read->tracks) {
            QVERIFY(!track.samples.empty());
            for (const TrackSample& at : track.samples) {
                QVERIFY(std::isfinite(at.geo.lonDeg) && std::isfinite(at.geo.latDeg));
                QVERIFY(std::isfinite(at.local.x) && std::isfinite(at.local.y));
                QVERIFY(std::abs(at.geo.lonDeg) <= 180.0 && std::abs(at.geo.latDeg) <= 90.0);
                QVERIFY(std::isfinite(at.timeS.value_or(0.0)) && std::isfinite(at.speedMps.value_or(0.0)));
            }
        }
    }
}

FURROW_TEST(TestRefusedTracks);
#include "tst_refused_tracks.moc"
