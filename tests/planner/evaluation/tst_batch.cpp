// Many fields at once: what is written for each, going on after an end half-way, and sharing the fields.

#include "planner/evaluation/batch.h"
#include "planner/geodesy/local_frame.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stop_token>

using namespace furrow;

namespace {

QJsonObject feature(const QString& id, const QJsonArray& ring) {
    return {{"type", "Feature"},
            {"id", id},
            {"properties", QJsonObject{}},
            {"geometry", QJsonObject{{"type", "Polygon"}, {"coordinates", QJsonArray{ring}}}}};
}

/// So many metres wide and high, around a place.
QJsonArray rectangleAt(GeoPoint centre, double widthM, double heightM) {
    const GeoPolygon geo = LocalFrame::centredOn(centre)->toGeo(test::centredRectangle(widthM, heightM));
    QJsonArray ring;
    for (const GeoPoint& point : geo.outer) {
        ring << QJsonArray{point.lonDeg, point.latDeg};
    }
    ring << ring.first();
    return ring;
}

// Any number that another plan has otherwise.
const Parameter& plainSetting() {
    return **std::ranges::find(allParameters(), std::string_view{"route.skip"}, &Parameter::key);
}

/// Two fields, one that crosses itself, and one that is narrow.
QByteArray fourFields() {
    const QJsonArray bowTie{QJsonArray{5.02, 52.0}, QJsonArray{5.022, 52.001}, QJsonArray{5.022, 52.0},
                            QJsonArray{5.02, 52.001}, QJsonArray{5.02, 52.0}};
    const QJsonArray features{feature("large", rectangleAt({5.0, 52.0}, 100.0, 60.0)),
                              feature("small", rectangleAt({5.01, 52.0}, 80.0, 50.0)),
                              feature("bow-tie", bowTie),
                              feature("strip", rectangleAt({5.03, 52.0}, 90.0, 8.0))};
    return QJsonDocument{QJsonObject{{"type", "FeatureCollection"}, {"features", features}}}.toJson();
}

QByteArray read(const QString& path) {
    QFile file{path};
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray{};
}

void write(const QString& path, const QByteArray& text) {
    QFile file{path};
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text);
}

QList<QByteArray> linesOf(const QString& path) {
    QList<QByteArray> lines = read(path).split('\n');
    if (!lines.empty() && lines.back().isEmpty()) {
        lines.removeLast();
    }
    std::ranges::sort(lines);
    return lines;
}

}  // namespace

class BatchTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString fields_;

    BatchTask taskInto(const QString& out) const {
        return {.files = {fields_.toStdString()},
                .machine = findMachine("agbot").value(),
                .settings = {},
                .out = folder_.filePath(out).toStdString(),
                .formats = {},
                .shard = {},
                .smallest = {},
                .largest = {}};
    }
    QString at(const QString& out, const QString& file = QStringLiteral("batch.jsonl")) const {
        return folder_.filePath(out + "/" + file);
    }
    QMap<int, QJsonObject> records(const QString& out) const {
        QMap<int, QJsonObject> found;
        for (const QByteArray& line : linesOf(at(out))) {
            const QJsonObject object = QJsonDocument::fromJson(line).object();
            found[object["number"].toInt()] = object;
        }
        return found;
    }

    /// The one that begins so.
    QString folderOf(const QString& out, const QString& beginning) const {
        const QStringList names = QDir{folder_.filePath(out)}.entryList({beginning + "-*"}, QDir::Dirs);
        return names.size() == 1 ? at(out, names.front()) : QString{};
    }

private slots:
    void initTestCase() {
        fields_ = folder_.filePath("four.geojson");
        write(fields_, fourFields());
        QVERIFY(runBatch(taskInto("whole"), {}).has_value());
    }

    void aLineForEachField() {
        QCOMPARE(linesOf(at("whole")).size(), 4);
        const QMap<int, QJsonObject> all = records("whole");
        QCOMPARE(all.keys(), (QList<int>{1, 2, 3, 4}));
        const QStringList ids{"large", "small", "bow-tie", "strip"};
        const double areas[] = {6000.0, 4000.0, 0.0, 720.0};
        const double breadths[] = {60.0, 50.0, 0.0, 8.0};
        for (int i = 0; i < 4; ++i) {
            const QJsonObject record = all[i + 1];
            QCOMPARE(record["file"].toString(), QFileInfo{fields_}.canonicalFilePath());
            QVERIFY(!record["key"].toString().isEmpty());
            QCOMPARE(record["machine"].toString(), QStringLiteral("AgBot"));
            QCOMPARE(record["id"].toString(), ids[i]);
            if (ids[i] == "bow-tie") {
                QCOMPARE(record["outcome"].toString(), QStringLiteral("refused"));
                QVERIFY2(record["error"].toString().contains("crosses itself"),
                         qPrintable(record["error"].toString()));
                QVERIFY(record["folder"].toString().isEmpty() && record["covered"].isNull());
                continue;
            }
            COMPARE_WITHIN(record["area_m2"].toDouble(), areas[i], 0.1);
            COMPARE_WITHIN(record["breadth_m"].toDouble(), breadths[i], 0.01 * breadths[i] + 0.01);
            QCOMPARE(record["vertices"].toInt(), 4);
            QVERIFY(record["covered"].toDouble() > (ids[i] == "strip" ? 0.5 : 0.95) &&
                    record["covered"].toDouble() <= 1.0);
            QVERIFY(record["swaths"].toInt() > 0 && record["time_ms"].toDouble() > 0.0);
            // The plan's own summary says the same.
            QVERIFY2(record["folder"].toString().startsWith(QStringLiteral("four-0000%1-").arg(i + 1)),
                     qPrintable(record["folder"].toString()));
            const QJsonObject summary =
                QJsonDocument::fromJson(read(at("whole", record["folder"].toString() + "/summary.json")))
                    .object();
            QCOMPARE(record["covered"].toDouble(), summary["audit"]["covered"].toDouble());
            QCOMPARE(record["swaths"].toInt(), summary["swaths"]["count"].toInt());
            QCOMPARE(record["undrivable_turns"].toInt(), summary["path"]["undrivable_turns"].toInt());
            int blocking = 0;
            for (const QJsonValue& count : record["blocking"].toObject()) {
                blocking += count.toInt();
            }
            QCOMPARE(record["outcome"].toString(),
                     blocking == 0 ? QStringLiteral("drivable") : QStringLiteral("blocked"));
        }
        QCOMPARE(all[1]["outcome"].toString(), QStringLiteral("drivable"));
    }

    // Fields narrower than five widths of 2.5 m are counted apart; what was refused is with the others.
    void totals() {
        BatchTask task = taskInto("whole");
        task.resume = true;
        const auto report = runBatch(task, {});
        VERIFY_RESULT(report);
        QCOMPARE(report->records.size(), std::size_t{4});
        for (std::size_t i = 0; i < 4; ++i) {
            QCOMPARE(report->records[i].number, i + 1);
        }
        QCOMPARE(report->wide.fields, std::size_t{3});
        QCOMPARE(report->wide.planned, std::size_t{2});
        QCOMPARE(report->narrow.fields, std::size_t{1});
        QCOMPARE(report->narrow.planned, std::size_t{1});
        QMap<int, QJsonObject> all = records("whole");
        const auto coveredOf = [&](int number) { return all[number]["covered"].toDouble(); };
        COMPARE_WITHIN(report->narrow.medianCovered, coveredOf(4), 1e-12);
        COMPARE_WITHIN(report->wide.tenthCovered, std::min(coveredOf(1), coveredOf(2)), 1e-12);
        QCOMPARE(report->wide.turns, all[1]["turns"].toInt() + all[2]["turns"].toInt());
        const QJsonObject json =
            QJsonDocument::fromJson(QByteArray::fromStdString(batchJson(*report))).object();
        QCOMPARE(json["wide"]["fields"].toInt(), 3);
        QCOMPARE(json["narrow"]["fields"].toInt(), 1);
    }

    // What was planned is neither planned again nor overwritten unasked.
    void theSameAgainIsRefused() {
        const QByteArray before = read(at("whole", "batch.jsonl"));
        QVERIFY(!before.isEmpty());
        const auto again = runBatch(taskInto("whole"), {});
        QVERIFY(!again);
        QVERIFY2(again.error().remedy.text().contains("--resume"), again.error().line().c_str());
        QCOMPARE(read(at("whole", "batch.jsonl")), before);
    }

    void oneRunAtATime() {
        BatchTask task = taskInto("locked");
        std::filesystem::create_directories(task.out);
        const int other = ::open(batchRecordPath(task.out, task.shard).c_str(), O_RDWR | O_CREAT, 0666);
        QVERIFY(other >= 0 && ::flock(other, LOCK_EX | LOCK_NB) == 0);
        task.resume = true;
        const auto second = runBatch(task, {});
        QVERIFY(!second);
        QCOMPARE(second.error().what.text(), std::string{"another run is writing to this folder"});
        ::close(other);
        QVERIFY(runBatch(task, {}).has_value());
    }

    void resumePlansWhatIsMissing() {
        QVERIFY(runBatch(taskInto("resumed"), {}).has_value());
        QList<QByteArray> lines = linesOf(at("resumed"));
        const auto second = std::ranges::find_if(
            lines, [](const QByteArray& line) { return line.contains("\"number\":2,"); });
        QVERIFY(second != lines.end());
        lines.erase(second);
        write(at("resumed"), lines.join('\n') + '\n');
        const QMap<int, QJsonObject> before = records("resumed");
        const QString first = at("resumed", before[1]["folder"].toString());
        QVERIFY(QDir{first}.removeRecursively());
        QVERIFY(QDir{folderOf("resumed", "four-00002")}.removeRecursively());
        BatchTask task = taskInto("resumed");
        task.resume = true;
        const auto report = runBatch(task, {});
        VERIFY_RESULT(report);
        QCOMPARE(report->records.size(), std::size_t{4});
        // The others' lines are as they were, their time of planning too; what was done is not done again.
        const QList<QByteArray> after = linesOf(at("resumed"));
        QCOMPARE(after.size(), 4);
        for (const QByteArray& line : lines) {
            QVERIFY(after.contains(line));
        }
        QVERIFY(QFile::exists(folderOf("resumed", "four-00002") + "/summary.json"));
        QVERIFY(!QFile::exists(first));
    }

    // Ended in the middle of a line, by a signal or a full disk.
    void aCutLastLineIsRepaired() {
        QVERIFY(runBatch(taskInto("cut"), {}).has_value());
        const QByteArray whole = read(at("cut"));
        const qsizetype lastLine = whole.lastIndexOf('\n', -2) + 1;
        const QByteArray last = whole.mid(lastLine);
        for (const qsizetype kept : {qsizetype{1}, last.size() / 2, last.size() - 2}) {
            write(at("cut"), whole.left(lastLine + kept));
            BatchTask task = taskInto("cut");
            task.resume = true;
            const auto report = runBatch(task, {});
            VERIFY_RESULT(report);
            QCOMPARE(report->records.size(), std::size_t{4});
            QCOMPARE(linesOf(at("cut")).size(), 4);
            QCOMPARE(records("cut").keys(), (QList<int>{1, 2, 3, 4}));
        }
    }

    // Two farms, two machines' exports: the same name in two folders, and the same stem with another
    // extension.
    void filesOfOneNameDoNotMeet() {
        QVERIFY(QDir{folder_.path()}.mkpath("east") && QDir{folder_.path()}.mkpath("west"));
        BatchTask task = taskInto("namesakes");
        task.files.clear();
        double lon = 5.0;
        for (const char* name : {"east/one.geojson", "west/one.geojson", "west/one.json"}) {
            const QJsonArray features{feature(name, rectangleAt({lon, 52.0}, 80.0, 50.0))};
            write(folder_.filePath(name),
                  QJsonDocument{QJsonObject{{"type", "FeatureCollection"}, {"features", features}}}.toJson());
            task.files.push_back(folder_.filePath(name).toStdString());
            lon += 0.01;
        }
        // Named twice, one way or another, it is planned once.
        task.files.push_back(folder_.filePath("east/../east/one.geojson").toStdString());
        const auto report = runBatch(task, {});
        VERIFY_RESULT(report);
        QCOMPARE(report->records.size(), std::size_t{3});
        QSet<QString> folders;
        QSet<QString> ids;
        for (const BatchRecord& record : report->records) {
            const QString folder = QString::fromStdString(record.folder);
            folders << folder;
            ids << QJsonDocument::fromJson(read(at("namesakes", folder + "/summary.json")))
                       .object()["field"]
                       .toObject()["id"]
                       .toString();
        }
        QCOMPARE(folders.size(), 3);
        QCOMPARE(ids, (QSet<QString>{"east/one.geojson", "west/one.geojson", "west/one.json"}));
        task.resume = true;
        VERIFY_RESULT(runBatch(task, {}));
        QCOMPARE(linesOf(at("namesakes")).size(), 3);
    }

    void refusesOtherInputs_data() {
        QTest::addColumn<QString>("what");
        QTest::addColumn<bool>("resume");
        for (const char* what : {"machine", "settings", "formats", "file", "field", "size"}) {
            for (const bool resume : {false, true}) {
                QTest::addRow("%s%s", what, resume ? ", resumed" : "") << QString::fromLatin1(what) << resume;
            }
        }
    }
    void refusesOtherInputs() {
        QFETCH(QString, what);
        QFETCH(bool, resume);
        const QString out = QStringLiteral("mixed");
        const QString fields = folder_.filePath("mixed.geojson");
        write(fields, fourFields());
        BatchTask task = taskInto(out);
        task.files = {fields.toStdString()};
        if (!QFile::exists(at(out))) {
            VERIFY_RESULT(runBatch(task, {}));
        }
        const QByteArray before = read(at(out));
        task.resume = resume;
        if (what == "machine") {
            task.machine = findMachine("cultivator").value();
        } else if (what == "settings") {
            QVERIFY(task.settings.setText(plainSetting(), "4").has_value());
        } else if (what == "formats") {
            task.formats = {"csv"};
        } else if (what == "file") {
            task.files = {fields_.toStdString()};
        } else if (what == "field") {
            write(fields, fourFields().replace("\"small\"", "\"smaller\""));
        } else {
            task.smallest = squareMetres(1000.0);
        }
        const auto report = runBatch(task, {});
        QVERIFY(!report);
        QCOMPARE(report.error().code, ErrorCode::Usage);
        QVERIFY(report.error().remedy.contains("--out"));
        QCOMPARE(read(at(out)), before);
    }

    void resumeTakesMoreFiles() {
        const QString fields = folder_.filePath("more.geojson");
        write(fields, fourFields());
        VERIFY_RESULT(runBatch(taskInto("more"), {}));
        BatchTask task = taskInto("more");
        task.files.push_back(fields.toStdString());
        task.resume = true;
        const auto report = runBatch(task, {});
        VERIFY_RESULT(report);
        QCOMPARE(report->records.size(), std::size_t{8});
    }

    void shardsOfOtherBatchesAreRefused() {
        BatchTask task = taskInto("shards-mixed");
        task.shard = {.number = 1, .count = 2};
        VERIFY_RESULT(runBatch(task, {}));
        task.shard.number = 2;
        task.machine = findMachine("cultivator").value();
        const auto report = runBatch(task, {});
        QVERIFY(!report);
        QCOMPARE(report.error().code, ErrorCode::Usage);
    }

    void shardsHoldEveryFieldOnce() {
        QList<int> numbers;
        for (const std::size_t number : {1U, 2U}) {
            BatchTask task = taskInto("shards");
            task.shard = {.number = number, .count = 2};
            const auto report = runBatch(task, {});
            VERIFY_RESULT(report);
            const QString path = at("shards", QStringLiteral("batch-%1-of-2.jsonl").arg(number));
            QCOMPARE(QString::fromStdString(batchRecordPath(task.out, task.shard).string()), path);
            QCOMPARE(linesOf(path).size(), 2);
            QCOMPARE(report->records.size(), std::size_t{2});
            for (const BatchRecord& record : report->records) {
                numbers << static_cast<int>(record.number);
            }
        }
        std::ranges::sort(numbers);
        QCOMPARE(numbers, (QList<int>{1, 2, 3, 4}));
        QVERIFY(!QFile::exists(at("shards")));
    }

    void sizesLeftOut() {
        BatchTask task = taskInto("sizes");
        task.smallest = squareMetres(1000.0);
        task.largest = squareMetres(5000.0);
        const auto report = runBatch(task, {});
        VERIFY_RESULT(report);
        // The bow-tie encloses nothing, as its halves run round in opposite directions.
        QCOMPARE(report->records.size(), std::size_t{1});
        QCOMPARE(report->records.front().id, std::string{"small"});
    }

    void whatCannotBeRead() {
        BatchTask task = taskInto("nothing");
        task.files = {folder_.filePath("none.geojson").toStdString()};
        const auto missing = runBatch(task, {});
        QVERIFY(!missing);
        QCOMPARE(missing.error().code, ErrorCode::ReadFailed);
        write(folder_.filePath("text.geojson"), "no fields");
        task.files = {folder_.filePath("text.geojson").toStdString()};
        const auto damaged = runBatch(task, {});
        QVERIFY(!damaged);
        QVERIFY(damaged.error().code == ErrorCode::InputRefused ||
                damaged.error().code == ErrorCode::ReadFailed);
    }

    void whatCannotBeWritten() {
        write(folder_.filePath("file"), "no folder");
        const auto report = runBatch(taskInto("file/out"), {});
        QVERIFY(!report);
        QCOMPARE(report.error().code, ErrorCode::WriteFailed);
    }

    void aStoppedJobIsCancelled() {
        std::stop_source stop;
        stop.request_stop();
        const auto report = runBatch(taskInto("stopped"), {.stop = stop.get_token()});
        QVERIFY(!report);
        QCOMPARE(report.error().code, ErrorCode::Cancelled);
    }
};

FURROW_TEST(BatchTest);
#include "tst_batch.moc"
