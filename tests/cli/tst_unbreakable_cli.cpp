// What people and programs got wrong, or meant to: each row once took the program down, or was let pass.
#include "tests/support/furrow_cli.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

#include <sys/stat.h>

#include <csignal>

using namespace furrow;
using test::Answer;
using test::contentsOf;
using test::furrowCli;
using test::sampleField;
using test::writeFile;

namespace {

QByteArray machineWith(const QByteArray& member) {
    return "{\"operating_width_m\": 3, \"min_turning_radius_m\": 5, " + member + "}";
}

QByteArray brackets() {
    return QByteArray(100'000, '[') + QByteArray(100'000, ']');
}

/// A square field of a GeoJSON file.
QByteArray square(const QByteArray& name, double lon, double lat, double sizeDeg) {
    const auto point = [](double x, double y) {
        return "[" + QByteArray::number(x, 'f', 6) + "," + QByteArray::number(y, 'f', 6) + "]";
    };
    return R"({"type":"Feature","properties":{"name":")" + name +
           R"("},"geometry":{"type":"Polygon","coordinates":[[)" + point(lon, lat) + "," +
           point(lon + sizeDeg, lat) + "," + point(lon + sizeDeg, lat + sizeDeg) + "," +
           point(lon, lat + sizeDeg) + "," + point(lon, lat) + "]]}}";
}

QByteArray collection(const QByteArrayList& features) {
    return R"({"type":"FeatureCollection","features":[)" + features.join(",") + "]}";
}

/// Files below a folder, by their paths in it.
QMap<QString, QByteArray> filesIn(const QString& folder) {
    QMap<QString, QByteArray> files;
    QDirIterator each{folder, QDir::Files, QDirIterator::Subdirectories};
    while (each.hasNext()) {
        const QString path = each.next();
        files[QDir{folder}.relativeFilePath(path)] = contentsOf(path);
    }
    return files;
}

}  // namespace

class TestUnbreakableCli : public QObject {
    Q_OBJECT
private slots:
    void machineValuesHaveARange_data() {
        QTest::addColumn<QByteArray>("machine");
        QTest::addColumn<QByteArray>("told");
        QTest::newRow("raised width")
            << machineWith("\"raised_width_m\": 1e4") << QByteArray{"raised_width_m"};
        QTest::newRow("far to the side")
            << machineWith("\"implement_lateral_offset_m\": 1e5") << QByteArray{"implement_lateral_offset_m"};
        QTest::newRow("run-in") << machineWith("\"run_in_m\": 1e5") << QByteArray{"run_in_m"};
        QTest::newRow("no speed") << machineWith("\"working_speed_mps\": 1e-308")
                                  << QByteArray{"working_speed_mps"};
        QTest::newRow("millimetres")
            << QByteArray{R"({"operating_width_m": 7500, "min_turning_radius_m": 6})"}
            << QByteArray{"did you mean 7.5 m?"};
        QTest::newRow("brackets") << machineWith("\"tank_capacity\": " + brackets())
                                  << QByteArray{"too deep"};
    }
    void machineValuesHaveARange() {
        QFETCH(QByteArray, machine);
        QFETCH(QByteArray, told);
        const QTemporaryDir folder;
        const QString file = writeFile(folder.filePath("m.json"), machine);
        const Answer answer = furrowCli(
            {"plan", sampleField("slanted_field"), "--machine", file, "--out", folder.filePath("plan")},
            10'000);
        QCOMPARE(answer.status, 3);
        QVERIFY2(answer.error.contains("m.json") && answer.error.contains(told), answer.error);
        QVERIFY(!QFile::exists(folder.filePath("plan")));
    }
    // The edges of the ranges: no field needs minutes, and no file holds what is no number.
    void extremeMachinesEnd_data() {
        QTest::addColumn<QByteArray>("member");
        for (const char* member :
             {"\"raised_width_m\": 100", "\"implement_lateral_offset_m\": 50", "\"run_in_m\": 100",
              "\"working_speed_mps\": 0.01, \"turning_speed_mps\": 0.01", "\"implement_offset_m\": -50",
              "\"max_curvature_rate_1pm2\": 1e-5", "\"max_acceleration_mps2\": 0.01"}) {
            QTest::newRow(member) << QByteArray{member};
        }
    }
    void extremeMachinesEnd() {
        QFETCH(QByteArray, member);
        const QTemporaryDir folder;
        const QString file = writeFile(folder.filePath("m.json"), machineWith(member));
        const Answer answer = furrowCli(
            {"plan", sampleField("slanted_field"), "--machine", file, "--out", folder.filePath("plan")});
        QVERIFY2(answer.status == 0 || answer.status == 1 || answer.status == 3, answer.error);
        static const QRegularExpression noNumber{"(^|[,: ])-?(nan|inf)\\b",
                                                 QRegularExpression::MultilineOption};
        for (const auto& [name, bytes] : filesIn(folder.filePath("plan")).asKeyValueRange()) {
            QVERIFY2(!QString::fromUtf8(bytes).contains(noNumber), qPrintable(name));
        }
    }
    void emptyValuesAreWrongUsage() {
        const QTemporaryDir folder;
        const QString field = sampleField("slanted_field");
        QCOMPARE(furrowCli({"plan", field, "--machine", "", "--out", folder.filePath("p")}).status, 2);
        QCOMPARE(furrowCli({"batch", field, "--machine", "", "--out", folder.filePath("p")}).status, 2);
        QCOMPARE(furrowCli({"plan", field, "--settings", "", "--out", folder.filePath("p")}).status, 2);
        QCOMPARE(furrowCli({"batch", field, "--min-ha", "nan", "--out", folder.filePath("p")}).status, 2);
        QVERIFY(!QFile::exists(folder.filePath("p")));
    }
    void auditLooksAtTheMachineOfTheSummary_data() {
        QTest::addColumn<QByteArray>("value");
        QTest::addColumn<QByteArray>("told");
        QTest::newRow("kilometres") << QByteArray{"1e4"} << QByteArray{"operating_width_m"};
        QTest::newRow("micrometres") << QByteArray{"1e-6"} << QByteArray{"operating_width_m"};
        QTest::newRow("brackets") << brackets() << QByteArray{"too deep"};
    }
    void auditLooksAtTheMachineOfTheSummary() {
        QFETCH(QByteArray, value);
        QFETCH(QByteArray, told);
        const QTemporaryDir folder;
        QVERIFY(furrowCli({"plan", sampleField("slanted_field"), "--out", folder.path()}).status < 2);
        QString summary = QString::fromUtf8(contentsOf(folder.filePath("summary.json")));
        static const QRegularExpression width{"\"operating_width_m\": *[0-9.]+"};
        QVERIFY(summary.contains(width));
        summary.replace(width, "\"operating_width_m\": " + QString::fromUtf8(value));
        writeFile(folder.filePath("summary.json"), summary.toUtf8());
        const Answer answer = furrowCli({"audit", folder.path()}, 10'000);
        QCOMPARE(answer.status, 3);
        QVERIFY2(answer.error.contains("summary.json") && answer.error.contains(told), answer.error);
    }
    void auditNeedsTimes() {
        const QTemporaryDir folder;
        QVERIFY(furrowCli({"plan", sampleField("slanted_field"), "--out", folder.path()}).status == 0);
        QByteArrayList lines = contentsOf(folder.filePath("path.csv")).split('\n');
        for (qsizetype i = 1; i + 1 < lines.size(); ++i) {
            QByteArrayList cells = lines[i].split(',');
            cells[1] = "0";
            lines[i] = cells.join(',');
        }
        writeFile(folder.filePath("path.csv"), lines.join('\n'));
        const Answer answer = furrowCli({"audit", folder.path()});
        QCOMPARE(answer.status, 1);
        QVERIFY2(answer.out.contains("Time and way do not fit"), answer.out);
    }
    void aPipeThatNobodyWritesIsCancelled() {
        const QTemporaryDir folder;
        const QString pipe = folder.filePath("settings.json");
        QCOMPARE(::mkfifo(qPrintable(pipe), 0600), 0);
        QProcess process;
        process.start(test::kFurrowCli, {"plan", sampleField("slanted_field"), "--settings", pipe, "--out",
                                         folder.filePath("plan")});
        QVERIFY(process.waitForStarted());
        const QString status = QStringLiteral("/proc/%1/status").arg(process.processId());
        QVERIFY(QTest::qWaitFor([&] { return contentsOf(status).contains("Threads:\t2"); }, 5'000));
        QElapsedTimer timer;
        timer.start();
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(5'000));
        QVERIFY2(timer.elapsed() < 2'000, QByteArray::number(timer.elapsed()));
        QCOMPARE(process.exitCode(), 130);
    }
    // Files are written beside their names first. A link that waits there would lead the bytes elsewhere.
    void linksInTheFolderAreNotFollowed_data() {
        QTest::addColumn<QString>("link");
        QTest::newRow("beside a file") << "plan.geojson.part";
        QTest::newRow("beside the summary") << "summary.json.part";
        QTest::newRow("in the place of a file") << "plan.geojson";
    }
    void linksInTheFolderAreNotFollowed() {
        QFETCH(QString, link);
        const QTemporaryDir folder;
        const QString mine = writeFile(folder.filePath("mine.txt"), "mine");
        const QString out = folder.filePath("plan");
        QVERIFY(QDir{}.mkdir(out));
        QVERIFY(QFile::link(mine, out + "/" + link));
        const Answer answer =
            furrowCli({"plan", sampleField("slanted_field"), "--format", "geojson", "--out", out});
        QVERIFY2(answer.status == 0 || answer.status == 1, answer.error);
        QCOMPARE(contentsOf(mine), QByteArray{"mine"});
        QCOMPARE(filesIn(out).keys(), (QStringList{"plan.geojson", "summary.json"}));
        QVERIFY(!QFileInfo{out + "/plan.geojson"}.isSymLink());
    }
    void planningAgainLeavesNothingOfTheOldPlan() {
        const QTemporaryDir folder;
        const QStringList line{"plan", sampleField("slanted_field"), "--out", folder.path(), "--format"};
        QVERIFY(furrowCli(line + QStringList{"geojson,csv,isoxml"}).status < 2);
        QVERIFY(QFile::exists(folder.filePath("TASKDATA/TASKDATA.XML")));
        writeFile(folder.filePath("TASKDATA/mine.txt"), "mine");
        writeFile(folder.filePath("notes.csv"), "mine");
        QVERIFY(furrowCli(line + QStringList{"geojson"}).status < 2);
        QCOMPARE(filesIn(folder.path()).keys(),
                 (QStringList{"TASKDATA/mine.txt", "notes.csv", "plan.geojson", "summary.json"}));
    }
    void convertNamesWhatIsLeftOut() {
        const QTemporaryDir folder;
        const QString in =
            writeFile(folder.filePath("in.geojson"),
                      collection({square("Home", 9.0, 51.0, 0.003), square("A whole county", 10.0, 50.0, 2.0),
                                  square("Hill", 9.1, 51.0, 0.003)}));
        const QString out = folder.filePath("out.kml");
        const Answer answer = furrowCli({"convert", in, out});
        QCOMPARE(answer.status, 1);
        QVERIFY2(answer.error.contains("'A whole county' is left out"), answer.error);
        QCOMPARE(answer.error.count('\n'), 1);
        QVERIFY(contentsOf(out).contains("Home") && contentsOf(out).contains("Hill"));
        QCOMPARE(furrowCli({"convert", sampleField("slanted_field"), out}).status, 0);
    }
    void aFullDiskStopsABatch() {
        const QTemporaryDir folder;
        QByteArrayList fields;
        for (int i = 0; i < 40; ++i) {
            fields.push_back(square("F" + QByteArray::number(i), 9.0 + 0.01 * i, 51.0, 0.003));
        }
        const QString in = writeFile(folder.filePath("in.geojson"), collection(fields));
        const QString disk = folder.filePath("disk");
        QDir{}.mkdir(disk);
        // A small disk that only this process and its children see.
        const QString script =
            QStringLiteral(
                "mount -t tmpfs -o size=256k none '%1' || exit 77; '%2' batch '%3' --out '%1/out' "
                "--format geojson,csv --threads 2 2>'%4'; echo $? >'%5'; ls '%1/out' >'%6'; "
                "find '%1/out' -type d -empty | wc -l >'%7'")
                .arg(disk, test::kFurrowCli, in, folder.filePath("error"), folder.filePath("status"),
                     folder.filePath("list"), folder.filePath("empty"));
        QProcess process;
        process.start("unshare", {"--mount", "--map-root-user", "sh", "-c", script});
        if (!process.waitForFinished(60'000) || process.exitCode() == 77 || process.exitCode() == 1) {
            QSKIP("no mounts of one's own here");
        }
        QCOMPARE(contentsOf(folder.filePath("status")).trimmed(), QByteArray{"4"});
        const QByteArray error = contentsOf(folder.filePath("error"));
        QVERIFY2(error.contains("No space left"), error);
        QCOMPARE(error.count('\n'), 1);
        QVERIFY2(contentsOf(folder.filePath("list")).count('\n') < 15, contentsOf(folder.filePath("list")));
        QCOMPARE(contentsOf(folder.filePath("empty")).trimmed(), QByteArray{"0"});
    }
    // Zips tell time by two seconds.
    void theSamePlanIsTheSameBytes() {
        const QTemporaryDir folder;
        QStringList formats;
        for (const QJsonValue format : furrowCli({"list", "formats", "--json"}).json()["formats"].toArray()) {
            if (format.toObject()["write"].toBool()) {
                formats.push_back(format.toObject()["id"].toString());
            }
        }
        QVERIFY(formats.contains("geopackage") && formats.contains("kmz") &&
                formats.contains("shapefile-zip"));
        const auto written = [&](const QString& name) {
            const Answer answer = furrowCli({"plan", sampleField("long_strip"), "--format", formats.join(','),
                                             "--out", folder.filePath(name)});
            auto files = filesIn(folder.filePath(name));
            files.remove("summary.json");  // holds how long planning took
            return answer.status < 2 ? files : QMap<QString, QByteArray>{};
        };
        const auto first = written("first");
        QThread::msleep(2100);
        QVERIFY(first.size() > formats.size());
        const auto second = written("second");
        QCOMPARE(second.keys(), first.keys());
        for (const auto& [name, bytes] : first.asKeyValueRange()) {
            QVERIFY2(second[name] == bytes, qPrintable(name));
        }
    }
    void exitStatus_data() {
        QTest::addColumn<QString>("script");
        QTest::addColumn<int>("status");
        QTest::newRow("full standard output") << "\"$0\" list machines >/dev/full" << 4;
        QTest::newRow("full standard output, JSON") << "\"$0\" list methods --json >/dev/full" << 4;
        QTest::newRow("a folder as settings") << "\"$0\" plan \"$1\" --settings / --out /nowhere" << 4;
        QTest::newRow("a folder as machine") << "\"$0\" plan \"$1\" --machine /x.json --out /nowhere" << 4;
        QTest::newRow("endless settings") << "\"$0\" plan \"$1\" --settings /dev/zero --out /nowhere" << 3;
        QTest::newRow("overlap of all but a centimetre")
            << "\"$0\" plan \"$1\" --set swaths.overlap_m=2.499 --out /nowhere" << 3;
    }
    void exitStatus() {
        QFETCH(QString, script);
        QFETCH(int, status);
        QProcess process;
        process.start("sh", {"-c", script, test::kFurrowCli, sampleField("slanted_field")});
        QVERIFY(process.waitForFinished(20'000));
        const QByteArray error = process.readAllStandardError();
        QVERIFY2(process.exitCode() == status, error);
        QCOMPARE(error.count('\n'), 1);
    }
    void namesDoNotMoveTheCursor() {
        const QTemporaryDir folder;
        const QString in =
            writeFile(folder.filePath("in.geojson"),
                      collection({square("A\\u001b[31mred\\u009b2J\\u007f\\nB", 9.0, 51.0, 0.003)}));
        for (const QStringList& line :
             {QStringList{"plan", in, "--out", folder.filePath("p")}, QStringList{"list", "fields", in},
              QStringList{"plan", in, "--field-id", "none\x1b[2J", "--out", folder.filePath("p")},
              QStringList{"convert", in, folder.filePath("o.kml")},
              QStringList{"audit", folder.filePath("p")}}) {
            const Answer answer = furrowCli(line);
            QVERIFY2(!answer.all().contains('\x1b') && !answer.all().contains("\xC2\x9B") &&
                         !answer.all().contains('\x7f'),
                     answer.all());
        }
    }
    void cellsAreNoFormulas() {
        const QTemporaryDir folder;
        const QString in =
            writeFile(folder.filePath("in.geojson"),
                      collection({square("=1+1", 9.0, 51.0, 0.003), square("@SUM(A1)", 9.1, 51.0, 0.003),
                                  square("-Nord", 9.2, 51.0, 0.003)}));
        const QString table = folder.filePath("t.csv");
        QCOMPARE(furrowCli({"convert", in, table}).status, 0);
        QVERIFY2(contentsOf(table).contains("\"'=1+1\""), contentsOf(table));
        QVERIFY2(contentsOf(table).contains("\"'@SUM(A1)\""), contentsOf(table));
        const Answer back = furrowCli({"list", "fields", table});
        QVERIFY2(back.out.contains("=1+1") && back.out.contains("-Nord") && !back.out.contains("'"),
                 back.out);
    }
};

FURROW_TEST(TestUnbreakableCli);
#include "tst_unbreakable_cli.moc"
