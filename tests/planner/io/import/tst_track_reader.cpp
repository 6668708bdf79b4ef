// Recorded tracks: the same four corners in every format (tests/data/tracks/make_samples.py says where they
// are), and real recordings where the shared data lies beside the project.

#include "planner/io/import/track_reader.h"
#include "tests/planner/io/import/track_samples.h"
#include "tests/support/large_data.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>

using namespace furrow;
using namespace furrow::test;

class TestTrackReader : public QObject {
    Q_OBJECT

private slots:
    void corners_data();
    void corners();
    void localCorners_data();
    void localCorners();
    void compressedChunks_data();
    void compressedChunks();
    void pathCsvIsATrack();
    void bareXAndY_data();
    void bareXAndY();
    void segmentsAreTracksOfTheirOwn();
    void logWithoutDateCountsOverMidnight();
    void logsOfOtherFoldersStayOut();
    void logsOfOtherNames();
    void junkBeforeTheFirstSentence();
    void cancelled();
    void realRecordings_data();
    void realRecordings();
};

void TestTrackReader::corners_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("format");
    QTest::addColumn<double>("firstTimeS");
    QTest::addColumn<double>("firstSpeedMps");
    QTest::addColumn<bool>("headings");
    QTest::addColumn<bool>("workStates");
    QTest::addColumn<int>("notes");
    const auto row = [](const char* name, const char* file, const char* format, double speed, bool headings,
                        bool states, int notes) {
        QTest::newRow(name) << file << format << kStartS << speed << headings << states << notes;
    };
    row("GPX with a zone", "corners.gpx", "GPX", 3.0, true, false, 0);
    row("semicolons and decimal commas below a preamble", "corners_semicolon.csv", "table", 3.0, true, true,
        1);
    // 236 inches in 2 s.
    row("yield monitor text", "corners_yield_monitor.txt", "yield monitor text", 2.9972, false, false, 0);
    row("gpsd", "corners_gpsd.log", "gpsd log", 3.0, true, false, 1);
    row("NMEA with one wrong checksum", "corners_nmea.log", "NMEA log", 3.0, true, false, 1);
    row("ISOXML folder", "isoxml", "ISOXML time log", 3.0, false, true, 1);
    row("ISOXML inner folder", "isoxml/TASKDATA", "ISOXML time log", 3.0, false, true, 1);
    row("ISOXML main file", "isoxml/TASKDATA/TASKDATA.XML", "ISOXML time log", 3.0, false, true, 1);
    row("ISOXML zip", "corners_isoxml.zip", "ISOXML time log", 3.0, false, true, 1);
    row("rosbag2 folder", "rosbag_sqlite3", "rosbag2", -1.0, false, false, 1);
    row("rosbag2 file", "rosbag_sqlite3/drive_0.db3", "rosbag2", -1.0, false, false, 1);
}

void TestTrackReader::corners() {
    QFETCH(QString, file);
    QFETCH(QString, format);
    QFETCH(double, firstTimeS);
    QFETCH(double, firstSpeedMps);
    QFETCH(bool, headings);
    QFETCH(bool, workStates);
    QFETCH(int, notes);
    const auto read = readTracks(pathOf(sample(file)));
    QVERIFY2(read, read ? "" : read.error().line().c_str());
    QCOMPARE(QString::fromStdString(read->format), format);
    QCOMPARE(static_cast<int>(read->notes.size()), notes);
    QCOMPARE(read->tracks.size(), std::size_t{1});
    const RecordedTrack& track = read->tracks.front();
    QCOMPARE(track.places, TrackPlaces::Wgs84);
    QCOMPARE(track.samples.size(), std::size_t{4});
    constexpr double lon[] = {5.66, 5.6601, 5.6601, 5.66};
    constexpr double lat[] = {52.09, 52.09, 52.0901, 52.0901};
    // Clockwise from north 90, 90, 0, 270; counter-clockwise from east 0, 0, 90, 180.
    constexpr double heading[] = {0.0, 0.0, kPi / 2, kPi};
    for (std::size_t i = 0; i < 4; ++i) {
        const TrackSample& at = track.samples[i];
        QVERIFY(near(at.geo.lonDeg, lon[i], 1e-9));
        QVERIFY(near(at.geo.latDeg, lat[i], 1e-9));
        QVERIFY(near(at.timeS.value(), firstTimeS + 2.0 * static_cast<double>(i), 1e-3));
        QCOMPARE(at.headingRad.has_value(), headings);
        QVERIFY(!headings || near(*at.headingRad, heading[i], 1e-9));
        QCOMPARE(at.implementDown.has_value(), workStates);
        QVERIFY(!workStates || *at.implementDown == (i == 1 || i == 2));
    }
    QCOMPARE(track.samples[0].speedMps.has_value(), firstSpeedMps >= 0.0);
    QVERIFY(firstSpeedMps < 0.0 || near(*track.samples[0].speedMps, firstSpeedMps, 1e-5));
}

void TestTrackReader::localCorners_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<bool>("speeds");
    QTest::addColumn<bool>("times");
    QTest::newRow("odometry in MCAP") << "odometry.mcap" << true << true;
    QTest::newRow("path in MCAP") << "path.mcap" << false << false;
}

void TestTrackReader::localCorners() {
    QFETCH(QString, file);
    QFETCH(bool, speeds);
    QFETCH(bool, times);
    const auto read = readTracks(pathOf(sample(file)));
    QVERIFY2(read, read ? "" : read.error().line().c_str());
    QCOMPARE(read->tracks.size(), std::size_t{1});
    const RecordedTrack& track = read->tracks.front();
    QCOMPARE(track.places, TrackPlaces::Local);
    QCOMPARE(track.samples.size(), std::size_t{4});
    constexpr Point place[] = {{0, 0}, {6, 0}, {6, 8}, {0, 8}};
    constexpr double heading[] = {0.0, 0.0, kPi / 2, kPi};
    for (std::size_t i = 0; i < 4; ++i) {
        QCOMPARE(track.samples[i].local, place[i]);
        QVERIFY(near(track.samples[i].headingRad.value(), heading[i], 1e-9));
        QCOMPARE(track.samples[i].speedMps.has_value(), speeds);
        QCOMPARE(track.samples[i].timeS.has_value(), times);
    }
}

void TestTrackReader::compressedChunks_data() {
    QTest::addColumn<QByteArray>("compression");
    QTest::newRow("zstd") << QByteArray{"zstd"};
    QTest::newRow("lz4") << QByteArray{"lz4"};
}

void TestTrackReader::compressedChunks() {
    QFETCH(QByteArray, compression);
    const QTemporaryDir folder;
    const auto plain = readTracks(pathOf(sample("odometry.mcap")));
    const QByteArray bytes = withCompressedChunk(compression);
    const auto read = readTracks(pathOf(written(folder, "a.mcap", bytes)));
    QVERIFY2(read, read ? "" : read.error().line().c_str());
    QVERIFY(read->tracks == plain->tracks);
    // Sizes that are not so, below the limit and above it.
    QCOMPARE(readTracks(pathOf(written(folder, "b.mcap", withCompressedChunk(compression, 10)))).error().code,
             ErrorCode::ReadFailed);
    QCOMPARE(
        readTracks(pathOf(written(folder, "c.mcap", withCompressedChunk(compression, 100'000)))).error().code,
        ErrorCode::ReadFailed);
    const auto huge =
        readTracks(pathOf(written(folder, "d.mcap", withCompressedChunk(compression, quint64{1} << 40))));
    QCOMPARE(huge.error().code, ErrorCode::InputRefused);
    std::mt19937 random{11};
    for (int i = 0; i < 300; ++i) {
        QByteArray damaged = bytes;
        damaged[static_cast<qsizetype>(random() % static_cast<unsigned>(bytes.size()))] =
            static_cast<char>(random() & 0xFFU);
        const auto answer = readTracks(pathOf(written(folder, "e.mcap", damaged)));
        QVERIFY(answer || !answer.error().remedy.empty());
    }
    const QByteArray unknown = withCompressedChunk("zstd").replace("zstd", "xyzw");
    const auto refused = readTracks(pathOf(written(folder, "f.mcap", unknown)));
    QVERIFY(refused.error().what.find("'xyzw' is not known") != std::string::npos);
}

void TestTrackReader::pathCsvIsATrack() {
    const QTemporaryDir folder;
    const QString file = written(folder, "path.csv",
                                 "s_m,t_s,x_m,y_m,lon_deg,lat_deg,heading_rad,curvature_1pm,speed_mps,gear,"
                                 "implement_down,segment,order,machine,level\n"
                                 "0,0,1,2,5.66,52.09,0.5,0,2.5,1,1,swath,0,0,\n"
                                 "6,2.4,3,4,5.6601,52.09,0.5,0,2.5,1,0,turn,1,0,\n");
    const auto read = readTracks(pathOf(file));
    QVERIFY2(read, read ? "" : read.error().line().c_str());
    const RecordedTrack& track = read->tracks.front();
    QCOMPARE(track.places, TrackPlaces::Wgs84);
    QCOMPARE(track.samples[1].geo, (GeoPoint{5.6601, 52.09}));
    QCOMPARE(track.samples[1].timeS.value(), 2.4);
    QCOMPARE(track.samples[0].headingRad.value(), 0.5);
    QCOMPARE(track.samples[0].speedMps.value(), 2.5);
    QCOMPARE(track.samples[0].implementDown.value(), true);
    QCOMPARE(track.samples[1].implementDown.value(), false);
}

void TestTrackReader::bareXAndY_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<bool>("geographic");
    QTest::newRow("within a degree") << QByteArray{"x,y\n5.66,52.09\n5.67,52.10\n"} << true;
    QTest::newRow("metres within the ranges of degrees") << QByteArray{"x,y\n0,0\n40,30\n"} << false;
    QTest::newRow("metres beyond them") << QByteArray{"x\ty\n0\t0\n400\t300\n"} << false;
    QTest::newRow("metres by name") << QByteArray{"x_m,y_m\n5.66,52.09\n5.67,52.10\n"} << false;
}

void TestTrackReader::bareXAndY() {
    QFETCH(QByteArray, text);
    QFETCH(bool, geographic);
    const QTemporaryDir folder;
    const auto read = readTracks(pathOf(written(folder, "track.csv", text)));
    QVERIFY2(read, read ? "" : read.error().line().c_str());
    QCOMPARE(read->tracks.front().places, geographic ? TrackPlaces::Wgs84 : TrackPlaces::Local);
}

void TestTrackReader::segmentsAreTracksOfTheirOwn() {
    const QTemporaryDir folder;
    const auto read = readTracks(pathOf(written(folder, "two.gpx", R"(<gpx version="1.0"><trk><trkseg>
        <trkpt lat="52" lon="5"><time>2026-05-04T10:00:00Z</time><speed>2.5</speed><course>45</course></trkpt>
        </trkseg><trkseg><trkpt lat="52.1" lon="5"/></trkseg></trk></gpx>)")));
    QVERIFY2(read, read ? "" : read.error().line().c_str());
    QCOMPARE(read->tracks.size(), std::size_t{2});
    QCOMPARE(read->tracks[0].source, std::string{"track 1, segment 1"});
    QCOMPARE(read->tracks[0].samples[0].speedMps.value(), 2.5);
    QVERIFY(near(read->tracks[0].samples[0].headingRad.value(), kPi / 4, 1e-12));
    QVERIFY(!read->tracks[1].samples[0].timeS);
}

void TestTrackReader::logWithoutDateCountsOverMidnight() {
    const QTemporaryDir folder;
    const auto read =
        readTracks(pathOf(written(folder, "night.log",
                                  "$GPGGA,235959.00,5205.4,N,00539.6,E,1,08,0.9,1,M,1,M,,\r\n"
                                  "$GPGGA,000001.00,5205.4,S,00539.6,W,1,08,0.9,1,M,1,M,,\r\n")));
    QVERIFY2(read, read ? "" : read.error().line().c_str());
    const auto& samples = read->tracks.front().samples;
    QCOMPARE(samples.size(), std::size_t{2});
    QVERIFY(near(*samples[1].timeS - *samples[0].timeS, 2.0, 1e-9));
    QVERIFY(near(samples[1].geo.latDeg, -52.09, 1e-9));
    QVERIFY(near(samples[1].geo.lonDeg, -5.66, 1e-9));
}

void TestTrackReader::logsOfOtherFoldersStayOut() {
    const QTemporaryDir folder;
    for (const char* name : {"TASKDATA.XML", "TLG00001.XML", "TLG00001.BIN"}) {
        const QByteArray bytes = bytesOf(sample(QString{"isoxml/TASKDATA/"} + name));
        written(folder, name, bytes);
        written(folder, QString{"old/"} + name, bytes);
    }
    const auto main = readTracks(pathOf(folder.filePath("TASKDATA.XML")));
    QVERIFY(main);
    QCOMPARE(main->tracks.size(), std::size_t{1});
    const auto both = readTracks(pathOf(folder.path()));
    QVERIFY(both);
    QCOMPARE(both->tracks.size(), std::size_t{2});
    // One of its files missing is told, not failed, as long as there is another log.
    QVERIFY(QFile::remove(folder.filePath("old/TLG00001.BIN")));
    const auto one = readTracks(pathOf(folder.path()));
    QVERIFY(one);
    QCOMPARE(one->tracks.size(), std::size_t{1});
    QCOMPARE(one->notes.front().text, std::string{"TLG00001.bin is not there"});
}

// Makers name them as they like; what tells is the header with its records beside it.
void TestTrackReader::logsOfOtherNames() {
    for (const char* name : {"TLG1", "tlg000012", "Log 3", "A7"}) {
        const QTemporaryDir folder;
        const auto bytes = [](const char* file) {
            return bytesOf(sample(QString{"isoxml/TASKDATA/"} + file));
        };
        written(folder, "TASKDATA.XML", bytes("TASKDATA.XML"));
        written(folder, QString{name} + ".xml", bytes("TLG00001.XML"));
        written(folder, QString{name} + ".BIN", bytes("TLG00001.BIN"));
        // Neither is a log.
        written(folder, "GRD00001.bin", bytes("TLG00001.BIN"));
        written(folder, "GRD00001.xml", "<ISO11783_TaskData/>");
        const auto read = readTracks(pathOf(folder.path()));
        QVERIFY2(read, read ? "" : read.error().line().c_str());
        QCOMPARE(read->tracks.size(), std::size_t{1});
        QVERIFY(read->tracks.front().source.contains(name));
    }
}

// A receiver that is switched on sends what is left in its memory first.
void TestTrackReader::junkBeforeTheFirstSentence() {
    const QTemporaryDir folder;
    QByteArray junk;
    for (int i = 0; i < 1500; ++i) {
        junk += static_cast<char>(i * 37 % 256);
    }
    const auto plain = readTracks(pathOf(sample("corners_nmea.log")));
    QVERIFY(plain);
    const auto read =
        readTracks(pathOf(written(folder, "night.log", junk + bytesOf(sample("corners_nmea.log")))));
    QVERIFY2(read, read ? "" : read.error().line().c_str());
    QCOMPARE(read->format, std::string{"NMEA log"});
    QCOMPARE(read->sampleCount(), plain->sampleCount());
    QVERIFY(!readTracks(pathOf(written(folder, "junk.log", junk))));
}

void TestTrackReader::cancelled() {
    std::stop_source stop;
    stop.request_stop();
    const QTemporaryDir folder;
    QByteArray text = "lon,lat\n";
    for (int i = 0; i < 5000; ++i) {
        text += "5.66,52.09\n";
    }
    const auto read = readTracks(pathOf(written(folder, "long.csv", text)), {.stop = stop.get_token()});
    QVERIFY(!read);
    QCOMPARE(read.error().code, ErrorCode::Cancelled);
}

void TestTrackReader::realRecordings_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("tracks");
    QTest::addColumn<int>("samples");
    QTest::addColumn<double>("kilometres");  ///< as the collection's README counts them; 0 where it does not
    const auto row = [](const char* file, int tracks, int samples, double kilometres) {
        QTest::newRow(file) << file << tracks << samples << kilometres;
    };
    row("tracks/gartner_corn_2011_yieldmonitor.csv", 1, 4949, 30.6);
    row("tracks/basswood_2012_yieldmonitor.txt", 1, 4240, 0.0);
    row("tracks/isoxml_totals", 3, 4677, 0.0);
    row("formats/isoxml/dev4agriculture/AllFieldsMoved_Or_Simplified_Out.zip", 2, 12462, 33.0);
    row("tracks/isoblue_gpsd.log", 1, 0, 0.0);
    row("tracks/nmea/nmea-rtk.log", 1, 0, 0.0);
    row("tracks/nmea/ublox-f9p-hpnmea.log", 1, 0, 0.0);
    row("tracks/nmea/sirfstarv-nmea.log", 1, 0, 0.0);
    row("formats/isoxml/dev4agriculture/Another-single-ACP.zip", 0, 0, 0.0);
    row("formats/isoxml/dart/folder_test", 0, 0, 0.0);
    row("formats/isoxml/adapt/agco_c100_tc_and_jd_sprayer_900-short.zip", 0, 0, 0.0);
    // 535 points, the numbers of the README there.
    row("formats/reference/csv/path.csv", 1, 535, 0.0);
    row("formats/reference/ros/rosbag2_sqlite3", 1, 535, 0.0);
    row("formats/reference/ros/rosbag2_mcap", 1, 535, 0.0);
    for (const char* gpx : {"korita-zbevnica", "cerknicko-jezero", "around-visnjan-with-car",
                            "gpx1.0_with_all_fields", "gpx1.1_with_all_fields", "route"}) {
        QTest::newRow(gpx) << QString{"formats/gpx/gpxpy_%1.gpx"}.arg(gpx) << 0 << 0 << 0.0;
    }
}

void TestTrackReader::realRecordings() {
    QFETCH(QString, file);
    QFETCH(int, tracks);
    QFETCH(int, samples);
    QFETCH(double, kilometres);
    const QString path = test::largeData(file);
    if (!QFileInfo::exists(path)) {
        QSKIP("the collection of real recordings is not beside the project");
    }
    const auto read = readTracks(pathOf(path));
    QVERIFY2(read, read ? "" : read.error().line().c_str());
    qInfo().noquote() << QString::fromStdString(read->format) << read->tracks.size() << "tracks"
                      << read->sampleCount() << "samples";
    for (const Note& note : read->notes) {
        qInfo().noquote() << "note:" << QString::fromStdString(note.text);
    }
    QVERIFY(tracks == 0 || read->tracks.size() == static_cast<std::size_t>(tracks));
    QVERIFY(samples == 0 || read->sampleCount() == static_cast<std::size_t>(samples));
    double way = 0.0;
    for (const RecordedTrack& track : read->tracks) {
        way += lengthOf(track).si() / 1000.0;
    }
    QVERIFY2(kilometres == 0.0 || near(way, kilometres, 1.0), qPrintable(QString::number(way)));
}

FURROW_TEST(TestTrackReader);
#include "tst_track_reader.moc"
