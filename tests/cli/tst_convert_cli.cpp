#include "tests/support/furrow_cli.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

using namespace furrow::test;

class ConvertCliTest : public QObject {
    Q_OBJECT

private slots:
    /// The path of a plan is a track, and gives its field back.
    void fromATrack() {
        const QTemporaryDir folder;
        const Answer planned = furrowCli({"plan", sampleField("slanted_field"), "--machine", "cultivator",
                                          "--out", folder.path(), "--format", "gpx", "--quiet"});
        QVERIFY2(planned.status <= 1, planned.all().constData());
        const QString track = folder.filePath("path.gpx");
        const Answer answer = furrowCli({"convert", track, folder.filePath("field.geojson"), "--from-track",
                                         "auto", "--width", "6", "--json"});
        QVERIFY2(answer.status == 0, answer.all().constData());
        const QJsonObject told = answer.json();
        QCOMPARE(told["fields"].toArray().size(), 1);
        QVERIFY(told["notes"].toArray().contains("The field was worked along the track."));
        // 5.40 ha, as the field's own file says.
        const double area = told["fields"][0]["area_m2"].toDouble();
        QVERIFY2(std::abs(area - 54'000.0) < 0.02 * 54'000.0, qPrintable(QString::number(area)));
        const Answer wide = furrowCli(
            {"convert", track, folder.filePath("x.geojson"), "--from-track", "auto", "--width", "0"});
        QCOMPARE(wide.status, 3);
        QVERIFY2(wide.error.contains("out of range"), wide.error.constData());
        // Without saying what it is for, options of it mean nothing.
        QCOMPARE(furrowCli({"convert", track, folder.filePath("x.geojson"), "--width", "6"}).status, 2);
    }

    void stepsAreMadeStraight() {
        const QTemporaryDir folder;
        const QString farm = QStringLiteral(FURROW_SOURCE_DIR "/tests/data/stepped/farm.geojson");
        const QString out = folder.filePath("straight.geojson");
        const Answer kept = furrowCli({"convert", farm, out, "--json"});
        QVERIFY2(kept.status == 0 && !kept.all().contains("made straight"), kept.all().constData());
        const Answer answer = furrowCli({"convert", farm, out, "--straighten-steps", "--json"});
        QVERIFY2(answer.status == 0, answer.all().constData());
        const QJsonArray fields = answer.json()["fields"].toArray();
        // Those of the README beside the file.
        const double areas[] = {180.0 * 110.0, 240.0 * 60.0, 100.0 * 80.0};
        QCOMPARE(fields.size(), 3);
        for (qsizetype i = 0; i < 3; ++i) {
            const double area = fields[i]["area_m2"].toDouble();
            QVERIFY2(std::abs(area / areas[i] - 1.0) < 0.02, qPrintable(QString::number(area)));
        }
        const QString notes = QJsonDocument{answer.json()["notes"].toArray()}.toJson();
        QCOMPARE(notes.count("steps of about 1.5 m were made straight"), 2);
        QVERIFY(!notes.contains("'Drawn Field'"));
        QFile written{out};
        QVERIFY(written.open(QIODevice::ReadOnly));
        for (const QJsonValue& feature : QJsonDocument::fromJson(written.readAll())["features"].toArray()) {
            const qsizetype points = feature["geometry"]["coordinates"][0].toArray().size();
            QVERIFY2(points >= 5 && points <= 17, qPrintable(QString::number(points)));
        }
    }
    // The shaft lies in the half of a step that a straight outline leaves out.
    void stepsStayWhereStraightOnesAreRefused() {
        const QTemporaryDir folder;
        const QString out = folder.filePath("straight.geojson");
        const Answer answer =
            furrowCli({"convert", QStringLiteral(FURROW_SOURCE_DIR "/tests/data/stepped/shaft.geojson"), out,
                       "--straighten-steps", "--json"});
        QVERIFY2(answer.status == 0, answer.all().constData());
        QVERIFY2(answer.json()["notes"].toArray()[0].toString().contains(
                     "its steps stay; made straight, it would be refused: shaft.geojson, the boundary: a "
                     "hole lies outside the boundary"),
                 answer.all().constData());
        QFile written{out};
        QVERIFY(written.open(QIODevice::ReadOnly));
        const QJsonValue outline =
            QJsonDocument::fromJson(written.readAll())["features"][0]["geometry"]["coordinates"][0];
        QVERIFY(outline.toArray().size() > 200);
    }

    void convertsByName_data() {
        QTest::addColumn<QString>("out");
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QString>("file");
        QTest::newRow("KML") << "field.kml" << QStringList{} << "field.kml";
        QTest::newRow("KMZ in capitals") << "FIELD.KMZ" << QStringList{} << "FIELD.KMZ";
        QTest::newRow("GeoPackage") << "f.gpkg" << QStringList{} << "f.gpkg";
        QTest::newRow("shapefile") << "mine.shp" << QStringList{} << "mine.dbf";
        QTest::newRow("task data by its folder") << "TASKDATA" << QStringList{} << "TASKDATA/TASKDATA.XML";
        QTest::newRow("task data by its file") << "deep/TASKDATA.XML" << QStringList{} << "deep/TASKDATA.XML";
        QTest::newRow("older task data in a zip")
            << "t.zip" << QStringList{"--format", "isoxml-v3"} << "t.zip";
        QTest::newRow("zipped boundary") << "b.zip" << QStringList{} << "b.zip";
        QTest::newRow("AgOpenGPS") << "fields" << QStringList{"--format", "agopengps"}
                                   << "fields/Three Ponds/Boundary.txt";
        QTest::newRow("drawing") << "f.dxf" << QStringList{} << "f_EPSG32632.dxf";
    }
    void convertsByName() {
        QFETCH(QString, out);
        QFETCH(QStringList, options);
        QFETCH(QString, file);
        const QTemporaryDir folder;
        const Answer answer = furrowCli(
            QStringList{"convert", sampleField("three_ponds"), folder.filePath(out), "--json"} + options);
        QVERIFY2(answer.status == 0, answer.all().constData());
        QVERIFY2(QFile::exists(folder.filePath(file)), answer.out.constData());
        const QJsonObject told = answer.json();
        QCOMPARE(told["fields"].toArray().size(), 1);
        // And back, with the same area.
        const QString written = told["files"].toArray().first().toString();
        const Answer back = furrowCli({"convert", written, folder.filePath("back.geojson"), "--json"});
        QVERIFY2(back.status == 0, back.all().constData());
        const double area = told["fields"][0]["area_m2"].toDouble();
        const double again = back.json()["fields"][0]["area_m2"].toDouble();
        QVERIFY2(std::abs(again - area) < 1e-4 * area,
                 qPrintable(QStringLiteral("%1 and %2").arg(area).arg(again)));
    }

    void refuses_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("why");
        QTest::newRow("no ending") << QStringList{sampleField("bend"), "somewhere"} << 2
                                   << "does not say which format";
        QTest::newRow("a format of plans") << QStringList{sampleField("bend"), "x", "--format", "rosbag2"}
                                           << 2 << "cannot be written as 'rosbag2'";
        QTest::newRow("no such file") << QStringList{"/no/such.kml", "x.kml"} << 4 << "there is no such file";
        QTest::newRow("no such field")
            << QStringList{sampleField("bend"), "x.kml", "--field-id", "nobody"} << 2 << "no field 'nobody'";
    }
    void refuses() {
        QFETCH(QStringList, arguments);
        QFETCH(int, status);
        QFETCH(QString, why);
        const Answer answer = furrowCli(QStringList{"convert"} + arguments);
        QCOMPARE(answer.status, status);
        QVERIFY2(answer.error.contains(why.toUtf8()), answer.error.constData());
        QCOMPARE(answer.error.count('\n'), 1);
    }

    void headlandPassesAsLines() {
        const QTemporaryDir folder;
        const auto linesWith = [&folder](const QStringList& options) {
            const Answer answer = furrowCli(QStringList{"plan", sampleField("bend"), "--out", folder.path(),
                                                        "--format", "isoxml", "--quiet"} +
                                            options);
            return answer.status > 1 ? -1
                                     : contentsOf(folder.filePath("TASKDATA/TASKDATA.XML")).count("<GPN ");
        };
        const auto plain = linesWith({});
        QVERIFY(plain >= 1);
        QVERIFY(linesWith({"--headland-lines"}) > plain);
        QVERIFY(contentsOf(folder.filePath("TASKDATA/TASKDATA.XML")).contains("B=\"Headland 1\""));
    }

    void formatsAreOneList() {
        const QJsonArray formats = furrowCli({"list", "formats", "--json"}).json()["formats"].toArray();
        QSet<QString> ids;
        QStringList written;
        for (const QJsonValue& format : formats) {
            ids.insert(format["id"].toString());
            QVERIFY(!format["carries"].toString().isEmpty());
            if (format["write"].toBool()) {
                written << format["id"].toString();
            }
        }
        QCOMPARE(ids.size(), formats.size());
        const QTemporaryDir folder;
        const Answer answer = furrowCli(
            {"plan", sampleField("bend"), "--out", folder.path(), "--format", written.join(','), "--quiet"});
        QVERIFY2(answer.status == 0 || answer.status == 1, answer.all().constData());
        for (const char* file :
             {"plan.geojson", "path.csv", "TASKDATA/TASKDATA.XML", "isoxml-v3/TASKDATA/TASKDATA.XML",
              "plan.kml", "plan.kmz", "plan.gpkg", "path.gpx", "boundary.zip", "plan.waypoints", "plan.plan",
              "path.pb", "ros/nav_msgs_path.yaml", "shapefile/boundary.shp"}) {
            QVERIFY2(QFile::exists(folder.filePath(file)), file);
        }
    }

    void aTerminalGetsItsFiles() {
        const QJsonArray terminals = furrowCli({"list", "terminals", "--json"}).json()["terminals"].toArray();
        QVERIFY(terminals.size() > 20);
        const QTemporaryDir folder;
        const Answer answer =
            furrowCli({"plan", sampleField("bend"), "--out", folder.path(), "--terminal", "trimble"});
        QVERIFY2(answer.status == 0 || answer.status == 1, answer.all().constData());
        QVERIFY(answer.out.contains("Shows the boundary and the guidance lines"));
        QVERIFY(QFile::exists(folder.filePath("AgGPS/Data/Furrow/Farm/The Bend/Swaths.shp")));
        QVERIFY(!QFile::exists(folder.filePath("path.csv")));
        const Answer unknown =
            furrowCli({"plan", sampleField("bend"), "--out", folder.path(), "--terminal", "trimbel"});
        QCOMPARE(unknown.status, 2);
        QVERIFY(unknown.error.contains("did you mean 'trimble'"));
        const Answer both = furrowCli(
            {"plan", sampleField("bend"), "--out", folder.path(), "--terminal", "fendt", "--format", "csv"});
        QCOMPARE(both.status, 2);
    }
};

FURROW_TEST(ConvertCliTest);
#include "tst_convert_cli.moc"
