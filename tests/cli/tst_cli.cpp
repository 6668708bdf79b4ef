// The command line as other programs rely on it: exit statuses, one-line errors, files.

#include "tests/support/furrow_cli.h"
#include "tests/support/patience.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

// The waiting macros of QtTest narrow.
#pragma GCC diagnostic ignored "-Wconversion"

using furrow::test::Answer;
using furrow::test::contentsOf;
using furrow::test::furrowCli;
using furrow::test::sampleField;
using furrow::test::writeFile;

namespace {

constexpr char kTwoFields[] = R"({"type":"FeatureCollection","features":[
 {"type":"Feature","id":"a7","properties":{"name":"North"},"geometry":{"type":"Polygon","coordinates":
  [[[5.0,52.0],[5.002,52.0],[5.002,52.001],[5.0,52.001],[5.0,52.0]]]}},
 {"type":"Feature","id":"b8","properties":{"name":"South"},"geometry":{"type":"Polygon","coordinates":
  [[[5.0,51.99],[5.004,51.99],[5.004,51.991],[5.0,51.991],[5.0,51.99]]]}}]})";

constexpr char kBowTie[] = R"({"type":"Polygon","coordinates":
  [[[5.0,52.0],[5.002,52.001],[5.002,52.0],[5.0,52.001],[5.0,52.0]]]})";

}  // namespace

class TestCli : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    QString twoFields() const { return writeFile(folder_.filePath("two.geojson"), kTwoFields); }
    QString bowTie() const { return writeFile(folder_.filePath("bowtie.geojson"), kBowTie); }
    QString noFolder() const { return writeFile(folder_.filePath("file"), "no folder"); }
    QString ring(const QString& name, const QByteArray& points) const {
        return writeFile(folder_.filePath(name), R"({"type":"Polygon","coordinates":[[)" + points + "]]}");
    }
    QStringList machine(const QString& name, const QByteArray& keys) const {
        return {"--machine", writeFile(folder_.filePath(name), "{" + keys + "}")};
    }
    QStringList plan(const QString& input, const QStringList& more) const {
        return QStringList{"plan", input, "--out", folder_.filePath("answers")} + more;
    }
    QStringList batch(const QString& input, const QString& folder, const QStringList& more) const {
        return QStringList{"batch", input, "--out", folder_.filePath(folder)} + more;
    }

    void addPlans() const {
        const QString field = sampleField("home_field");
        QTest::newRow("a plan") << plan(field, {}) << 0 << "Drivable  yes";
        QTest::newRow("turns outside")
            << plan(field, {"--set", "headland.method=none"}) << 1 << "leaves the field";
        QTest::newRow("no command") << QStringList{} << 2 << "subcommand";
        QTest::newRow("a command that is not there")
            << QStringList{"harvest", "fields.geojson"} << 2 << "furrow-cli";
    }
    void addBatches() const {
        const QString two = twoFields();
        QTest::newRow("a batch") << batch(two, "batch", {}) << 0 << "planned 2 (100.0 %)";
        QTest::newRow("a batch with totals for programs")
            << batch(two, "batch-json", {"--json"}) << 0 << "\"fields\": 2";
        QTest::newRow("a batch with a field that is refused")
            << batch(bowTie(), "refused", {}) << 1 << "planned 0 (0.0 %)";
        QTest::newRow("half of a batch")
            << batch(two, "half", {"--shard", "2/2"}) << 0 << "batch-2-of-2.jsonl";
        for (const char* shard : {"3/2", "0/2", "2", "1/0", "1/2/3", "a/b", "-1/2"}) {
            QTest::addRow("no shard: %s", shard) << batch(two, "batch", {"--shard", shard}) << 2 << "--shard";
        }
        QTest::newRow("a batch of no file")
            << batch(folder_.filePath("none.shp"), "batch", {}) << 4 << "none.shp";
        QTest::newRow("a batch into a file")
            << QStringList{"batch", two, "--out", noFolder() + "/batch"} << 4 << "could not";
    }
    void addOptions() const {
        const QString field = sampleField("home_field");
        QTest::newRow("an option that is not there") << plan(field, {"--fast"}) << 2 << "--fast";
        QTest::newRow("no such method")
            << plan(field, {"--set", "swaths.method=zigzag"}) << 2 << "brute-force";
        QTest::newRow("no such setting")
            << plan(field, {"--set", "headland.witdh_m=3"}) << 2 << "headland.width_m";
        QTest::newRow("no such machine") << plan(field, {"--machine", "agbott"}) << 2 << "agbot";
        QTest::newRow("no such format") << plan(field, {"--format", "dwg"}) << 2 << "geojson";
        QTest::newRow("value out of range")
            << plan(field, {"--set", "headland.width_m=-1"}) << 3 << "headland.width_m";
    }
    void addChoices() const {
        const QString two = twoFields();
        QTest::newRow("several fields") << plan(two, {}) << 2 << "South";
        QTest::newRow("by id") << plan(two, {"--field-id", "b8"}) << 0 << "South";
        QTest::newRow("by name") << plan(two, {"--field-id", "North"}) << 0 << "North";
        QTest::newRow("by number") << plan(two, {"--field-id", "2"}) << 0 << "South";
        QTest::newRow("no such field") << plan(two, {"--field-id", "9"}) << 2 << "9";
    }
    void addBadInput() const {
        QTest::newRow("bow-tie") << plan(bowTie(), {}) << 3 << "crosses itself at 5.001";
        // What else bad input gets; tst_bad_input has all of it.
        QTest::newRow("repaired") << plan(ring("open.geojson", "[5,52],[5,52.002],[5.004,52.002],[5.004,52]"),
                                          {})
                                  << 0 << "Repaired in the boundary: 1 ring did not end where it began";
        QTest::newRow("one point") << plan(ring("point.geojson", "[5,52]"), {}) << 3
                                   << "fewer than 3 different points";
        QTest::newRow("NaN") << plan(ring("nan.geojson", "[5,52],[5.002,NaN],[5.002,52.001],[5,52]"), {}) << 3
                             << "nan.geojson, part 1, point 2: a coordinate is not a number";
        QTest::newRow("longitude 200")
            << plan(ring("far.geojson", "[5,52],[200,52],[5.002,52.001],[5,52]"), {}) << 3
            << "far.geojson, part 1, point 2: 200, 52 is outside longitude";
        QTest::newRow("100 km") << plan(
                                       ring("wide.geojson", "[5,52],[5.002,52],[5.002,52.001],[5,53],[5,52]"),
                                       {})
                                << 3 << "wide.geojson, part 1, point 4: the field is more than 100 km across";
        QTest::newRow("machine fits nowhere")
            << plan(ring("tiny.geojson", "[5,52],[5.00005,52],[5.00005,52.00003],[5,52.00003],[5,52]"), {})
            << 3 << "fits nowhere into the field";
    }
    void addMachines() const {
        const QString field = sampleField("home_field");
        QTest::newRow("operating width below zero")
            << plan(field, machine("width.json", R"("operating_width_m": -3, "min_turning_radius_m": 5)"))
            << 3 << "operating_width_m: -3 m is beyond what machines have";
        QTest::newRow("radius of zero")
            << plan(field, machine("radius.json", R"("operating_width_m": 3, "min_turning_radius_m": 0)"))
            << 3 << "min_turning_radius_m: 0 m is beyond what machines have";
        QTest::newRow("machine too wide")
            << plan(sampleField("long_strip"), {"--set", "field.margin_m=40"}) << 3 << "nowhere as wide";
    }
    void addFiles() const {
        const QString field = sampleField("home_field");
        QTest::newRow("no such file") << plan(folder_.filePath("none.shp"), {}) << 4 << "none.shp";
        QTest::newRow("out is below a file")
            << QStringList{"plan", field, "--out", noFolder() + "/plan"} << 4 << "could not be written";
    }
    void addLists() const {
        QTest::newRow("list methods") << QStringList{"list", "methods"} << 0 << "reeds-shepp-cc";
        QTest::newRow("list machines") << QStringList{"list", "machines"} << 0 << "AgBot";
        QTest::newRow("list formats") << QStringList{"list", "formats"} << 0 << "GeoPackage";
        QTest::newRow("list fields") << QStringList{"list", "fields", twoFields()} << 0 << "b8";
        QTest::newRow("help") << QStringList{"plan", "--help"} << 0 << "Exit status";
    }

private slots:
    void summaryHasEveryKey() {
        const QTemporaryDir folder;
        const Answer answer =
            furrowCli({"plan", sampleField("home_field"), "--out", folder.filePath("plan"), "--json"});
        QCOMPARE(answer.status, 0);
        const QJsonObject top = answer.json();
        QVERIFY(!top.isEmpty());
        for (const char* key : {"field", "crs", "machine", "machines", "operation", "settings", "headland",
                                "swaths", "route", "path", "audit", "timing_ms", "version"}) {
            QVERIFY2(top.contains(QLatin1String(key)), key);
        }
        const auto hasAll = [&](const char* object, const QStringList& keys) {
            for (const QString& key : keys) {
                QVERIFY2(top[QLatin1String(object)].toObject().contains(key), qPrintable(key));
            }
        };
        hasAll("field", {"id", "area_m2"});
        hasAll("headland", {"width_m", "passes", "mainland_ratio"});
        hasAll("swaths",
               {"count", "total_length_m", "heading_deg", "proved", "coverage", "overlap_m2", "shift_m"});
        hasAll("route", {"method", "objective", "length_in_place_m", "cost", "non_working_cost",
                         "lower_bound", "gap", "gap_total"});
        const QJsonObject route = top["route"].toObject();
        const double nonWorking = route["non_working_cost"].toDouble();
        const double bound = route["lower_bound"].toDouble();
        QVERIFY(bound > 0.0 && bound <= nonWorking + 1e-6);
        COMPARE_WITHIN(route["gap"].toDouble(), nonWorking / bound - 1.0, 1e-9);
        const double working = route["cost"].toDouble() - nonWorking;
        COMPARE_WITHIN(route["gap_total"].toDouble(), route["cost"].toDouble() / (working + bound) - 1.0,
                       1e-9);
        hasAll("path", {"length_m", "turn_length_m", "transfer_length_m", "reverse_length_m", "time_s",
                        "turns", "undrivable_turns"});
        hasAll("audit",
               {"covered_m2", "covered", "covered_of_reachable", "missed_m2", "overlap_m2",
                "overlap_headland_m2", "outside_m2", "min_clearance_m", "max_curvature_1pm",
                "max_curvature_rate_1pm2", "max_position_jump_m", "max_heading_jump_rad", "findings"});
        // 2.5 m wide: four passes give the room to turn in.
        QCOMPARE(top["headland"].toObject()["width_m"].toDouble(), 10.0);
        QCOMPARE(contentsOf(folder.filePath("plan/summary.json")), answer.out);
    }

    // Another machine drives where the plan of the drill has its tramlines.
    void tramlinesBecomeRows() {
        const QTemporaryDir folder;
        const Answer drill = furrowCli({"plan", sampleField("home_field"), "--set", "swaths.tramline_every=8",
                                        "--out", folder.filePath("drill"), "--quiet"});
        QVERIFY(drill.status == 0 || drill.status == 1);
        const auto swathsOf = [&](const QString& plan, bool tramlinesOnly) {
            QList<QJsonObject> swaths;
            const QJsonDocument json =
                QJsonDocument::fromJson(contentsOf(folder.filePath(plan + "/plan.geojson")));
            for (const QJsonValue feature : json["features"].toArray()) {
                const QJsonObject properties = feature["properties"].toObject();
                if (properties["kind"].toString() == "swath" &&
                    (!tramlinesOnly || properties["tramline"].toBool())) {
                    swaths << feature["geometry"].toObject();
                }
            }
            return swaths;
        };
        const auto tramlines = swathsOf("drill", true);
        QVERIFY(tramlines.size() > 2 && tramlines.size() * 6 < swathsOf("drill", false).size());
        const Answer sprayer =
            furrowCli({"plan", sampleField("home_field"), "--set", "swaths.method=rows", "--set",
                       "swaths.rows=" + folder.filePath("drill/plan.geojson"), "--set", "swaths.ends=centre",
                       "--set", "headland.passes=2", "--out", folder.filePath("sprayer"), "--quiet"});
        QVERIFY2(sprayer.status == 0 || sprayer.status == 1, sprayer.error.constData());
        const auto rows = swathsOf("sprayer", false);
        QVERIFY(rows.size() >= tramlines.size());
        // Each on one of them: the middle of a row lies on the straight between a tramline's ends.
        for (const QJsonObject& row : rows) {
            const QJsonArray ends = row["coordinates"].toArray();
            const double lon = 0.5 * (ends.first()[0].toDouble() + ends.last()[0].toDouble());
            const double lat = 0.5 * (ends.first()[1].toDouble() + ends.last()[1].toDouble());
            const bool isOnOne = std::ranges::any_of(tramlines, [&](const QJsonObject& tramline) {
                const QJsonArray line = tramline["coordinates"].toArray();
                const double cosine = std::cos(lat * M_PI / 180.0);
                const double x = (line.last()[0].toDouble() - line.first()[0].toDouble()) * cosine;
                const double y = line.last()[1].toDouble() - line.first()[1].toDouble();
                const double px = (lon - line.first()[0].toDouble()) * cosine;
                const double py = lat - line.first()[1].toDouble();
                return std::abs(x * py - y * px) / std::hypot(x, y) * 111e3 < 0.01;
            });
            QVERIFY(isOnOne);
        }
    }

    void rowsThatAreNotThere() {
        const QTemporaryDir folder;
        const Answer none =
            furrowCli({"plan", sampleField("home_field"), "--set", "swaths.method=rows", "--set",
                       "swaths.rows=" + folder.filePath("none.geojson"), "--out", folder.filePath("plan")});
        QCOMPARE(none.status, 4);
        const Answer heights =
            furrowCli({"plan", sampleField("home_field"), "--set", "swaths.method=contour", "--set",
                       "swaths.elevation=" + sampleField("home_field"), "--out", folder.filePath("plan")});
        QCOMPARE(heights.status, 4);
        const Answer nothing = furrowCli({"plan", sampleField("home_field"), "--set", "swaths.method=rows",
                                          "--out", folder.filePath("plan")});
        QCOMPARE(nothing.status, 2);
    }

    void operationsSetWhatIsNotGiven() {
        const QTemporaryDir folder;
        const Answer answer =
            furrowCli({"plan", sampleField("home_field"), "--operation", "sowing", "--set",
                       "swaths.overlap_m=0.05", "--out", folder.filePath("plan"), "--json"});
        QVERIFY(answer.status == 0 || answer.status == 1);
        const QJsonObject top = answer.json();
        QCOMPARE(top["operation"].toString(), QStringLiteral("sowing"));
        QCOMPARE(top["tank"].toString(), QStringLiteral("empties"));
        QCOMPARE(top["operation_sets"].toObject(),
                 (QJsonObject{{"headland.when", "after"}, {"route.traversal", "headland"}}));
        QCOMPARE(top["settings"].toObject()["headland.when"].toString(), QStringLiteral("after"));
        QCOMPARE(top["settings"].toObject()["swaths.overlap_m"].toDouble(), 0.05);
    }

    void filesHoldThePlan() {
        const QTemporaryDir folder;
        QCOMPARE(furrowCli({"plan", sampleField("home_field"), "--out", folder.path(), "--quiet"}).status, 0);
        QMap<QString, int> kinds;
        const QJsonObject plan =
            QJsonDocument::fromJson(contentsOf(folder.filePath("plan.geojson"))).object();
        QList<QJsonObject> path;
        for (const QJsonValue feature : plan["features"].toArray()) {
            const QJsonObject properties = feature["properties"].toObject();
            ++kinds[properties["kind"].toString()];
            if (properties["kind"] == "path") {
                path << properties;
            }
        }
        QCOMPARE(kinds["field"], 1);
        QCOMPARE(kinds["mainland"], 1);
        QCOMPARE(kinds["headland"], 1);
        QVERIFY(kinds["swath"] > 10);
        // Worked stretches in turn with the ways between them, which have a line for each gear.
        int worked = 0;
        int ways = 0;
        for (qsizetype i = 0; i < path.size(); ++i) {
            QCOMPARE(path[i]["order"].toInt(), static_cast<int>(i));
            if (path[i]["implement_down"].toBool()) {
                ++worked;
                QVERIFY(i == 0 || !path[i - 1]["implement_down"].toBool());
            } else if (i > 0 && path[i - 1]["implement_down"].toBool()) {
                ++ways;
            } else {
                QVERIFY(i > 0 && path[i]["gear"].toInt() == -path[i - 1]["gear"].toInt());
            }
        }
        QCOMPARE(worked, kinds["swath"] + kinds["headland_pass"]);
        QCOMPARE(ways, worked - 1);
        QVERIFY(path.last()["implement_down"].toBool());
        const QList<QByteArray> rows = contentsOf(folder.filePath("path.csv")).trimmed().split('\n');
        QCOMPARE(rows.front(),
                 QByteArray("s_m,t_s,x_m,y_m,lon_deg,lat_deg,heading_rad,curvature_1pm,speed_mps,gear,"
                            "implement_down,segment,order,machine,level"));
        double before = -1.0;
        for (const QByteArray& row : rows.mid(1)) {
            const QList<QByteArray> cells = row.split(',');
            QCOMPARE(cells.size(), 15);
            QVERIFY(cells[0].toDouble() >= before);
            before = cells[0].toDouble();
        }
        QVERIFY(QFile::exists(folder.filePath("TASKDATA/TASKDATA.XML")));
        QVERIFY(QDir{folder.path()}.entryList({"*.part"}).isEmpty());
    }

    void sameFilesOnAnyNumberOfThreads() {
        const QTemporaryDir folder;
        for (const char* threads : {"1", "2", "8"}) {
            QCOMPARE(furrowCli({"plan", sampleField("slanted_field"), "--threads", threads, "--out",
                                folder.filePath(threads)})
                             .status < 2,
                     true);
        }
        for (const char* file : {"plan.geojson", "path.csv", "TASKDATA/TASKDATA.XML"}) {
            const QByteArray one =
                contentsOf(folder.filePath(QStringLiteral("1/%1").arg(QLatin1String(file))));
            QVERIFY(!one.isEmpty());
            QCOMPARE(contentsOf(folder.filePath(QStringLiteral("2/%1").arg(QLatin1String(file)))), one);
            QCOMPARE(contentsOf(folder.filePath(QStringLiteral("8/%1").arg(QLatin1String(file)))), one);
        }
    }

    void answers_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("says");
        addPlans();
        addBatches();
        addOptions();
        addChoices();
        addBadInput();
        addMachines();
        addFiles();
        addLists();
    }
    void answers() {
        QFETCH(QStringList, arguments);
        QFETCH(int, status);
        QFETCH(QString, says);
        const Answer answer = furrowCli(arguments);
        QVERIFY2(answer.status == status, answer.all());
        QVERIFY2(answer.all().contains(says.toUtf8()), answer.all());
        if (status > 1) {
            // One line, and nothing on standard output.
            QCOMPARE(answer.error.trimmed().count('\n'), 0);
            QVERIFY(answer.out.isEmpty());
        }
    }

    // As the README runs it: the shards that GNU parallel starts are together what one run does, and going on
    // from them has nothing left to plan.
    void shardsInParallel() {
        const QString two = writeFile(folder_.filePath("two.geojson"), kTwoFields);
        const QString out = folder_.filePath("shards");
        QProcess parallel;
        parallel.start("parallel",
                       QStringList{furrow::test::kFurrowCli, "batch", two, "--out", out, "--shard", "{}/2",
                                   "--threads", "1", "--quiet", ":::", "1", "2"});
        if (!parallel.waitForStarted()) {
            QSKIP("GNU parallel is not installed");
        }
        QVERIFY(parallel.waitForFinished(120'000));
        QVERIFY2(parallel.exitCode() == 0, parallel.readAllStandardError());
        const auto linesOf = [](const QString& record) {
            QStringList lines;
            for (const QByteArray& line : contentsOf(record).trimmed().split('\n')) {
                QJsonObject one = QJsonDocument::fromJson(line).object();
                one.remove("time_ms");
                lines << QJsonDocument{one}.toJson(QJsonDocument::Compact);
            }
            return lines;
        };
        // A run on several threads writes its lines as the fields are done.
        const auto inOrder = [](QStringList lines) {
            lines.sort();
            return lines;
        };
        const Answer whole = furrowCli({"batch", two, "--out", folder_.filePath("whole"), "--quiet"});
        QCOMPARE(whole.status, 0);
        const QStringList all = inOrder(linesOf(folder_.filePath("whole/batch.jsonl")));
        QCOMPARE(all.size(), 2);
        QCOMPARE(inOrder(linesOf(out + "/batch-1-of-2.jsonl") + linesOf(out + "/batch-2-of-2.jsonl")), all);
        const QByteArray before = contentsOf(out + "/batch-1-of-2.jsonl");
        QCOMPARE(furrowCli({"batch", two, "--out", out, "--shard", "1/2", "--resume", "--quiet"}).status, 0);
        QCOMPARE(contentsOf(out + "/batch-1-of-2.jsonl"), before);
    }

    void progressIsToldInLines() {
        const QTemporaryDir folder;
        const Answer told = furrowCli(
            {"plan", sampleField("home_field"), "--out", folder.filePath("told"), "--progress", "--json"});
        QVERIFY2(told.status == 0, told.all());
        QVERIFY(!told.json().isEmpty());
        const QList<QByteArray> lines = told.error.trimmed().split('\n');
        QCOMPARE(lines.last(), QByteArray{"progress 100 %"});
        int before = 0;
        int values = 0;
        int compared = 0;
        int drafts = 0;
        int asked = 0;
        for (const QByteArray& line : lines) {
            if (line.startsWith("first plan after ")) {
                // Before all planning: a tenth of the work is reading.
                QVERIFY2(line.contains(", a draft: ") && before <= 10 && asked == 0, told.all());
                ++drafts;
            } else if (line.startsWith("plan as asked after ")) {
                QVERIFY2(line.contains(" swaths · ") && compared == 0, told.all());
                ++asked;
            } else if (line.startsWith("compared ")) {
                QVERIFY2(line.startsWith("compared " + QByteArray::number(++compared) + " of "), told.all());
                QVERIFY2(line.split(' ').last().toInt() >= compared, told.all());
            } else {
                QVERIFY2(line.startsWith("progress ") && line.endsWith(" %"), told.all());
                const int percent = line.mid(9).chopped(2).toInt();
                QVERIFY2(percent > before && percent <= 100, told.all());
                before = percent;
                ++values;
            }
        }
        QCOMPARE(drafts, 1);
        QCOMPARE(asked, 1);
        // The kinds of corner are compared at the least.
        QVERIFY2(compared >= 1, told.all());
        QVERIFY2(values > 20, told.all());
        // The draft is to look at: what is written is the plan.
        const Answer silent =
            furrowCli({"plan", sampleField("home_field"), "--out", folder.filePath("silent"), "--quiet"});
        QCOMPARE(silent.status, 0);
        QVERIFY(silent.error.isEmpty());
        QCOMPARE(contentsOf(folder.filePath("told/plan.geojson")),
                 contentsOf(folder.filePath("silent/plan.geojson")));
    }

    void bestPlanTellsWhatChoicesAreWorth() {
        const QTemporaryDir folder;
        const QStringList line{"plan",  sampleField("bend"), "--machine", "cultivator",
                               "--set", "headland.passes=3", "--out",     folder.filePath("best")};
        const Answer asked = furrowCli(line + QStringList{"--json"});
        QVERIFY2(asked.status == 0, asked.all());
        QVERIFY(!asked.json().contains("best"));
        const Answer answer = furrowCli(line + QStringList{"--best", "--json"});
        QVERIFY2(answer.status == 0, answer.all());
        const QJsonObject best = answer.json()["best"].toObject();
        QVERIFY(best["time_s"].toDouble() < best["time_asked_s"].toDouble());
        QVERIFY(answer.json()["path"].toObject()["time_s"].toDouble() <
                asked.json()["path"].toObject()["time_s"].toDouble());
        QVERIFY(!best["taken"].toArray().isEmpty());
        QVERIFY(best["taken"].toArray()[0].toObject()["saves_s"].toDouble() > 0.0);
        // What is given stays and is not tried.
        QCOMPARE(answer.json()["settings"].toObject()["headland.passes"].toInt(), 3);
        for (const char* list : {"taken", "others"}) {
            for (const QJsonValue tried : best[list].toArray()) {
                QVERIFY(tried.toObject()["choice"].toString() != QStringLiteral("headland"));
            }
        }
        const Answer told = furrowCli(line + QStringList{"--best"});
        QVERIFY2(told.out.contains("\nBest      ") && told.out.contains("\n  taken   "), told.all());
    }

    void listsAreJsonObjects() {
        for (const char* what : {"methods", "machines", "formats"}) {
            const Answer answer = furrowCli({"list", what, "--json"});
            QCOMPARE(answer.status, 0);
            QVERIFY(!answer.json().isEmpty());
        }
    }

    void interruptLeavesNothing() {
        const QTemporaryDir folder;
        QProcess process;
        // A thousandth of a degree on a large field: far more work than the signal takes to arrive.
        process.start(furrow::test::kFurrowCli,
                      {"plan", sampleField("great_field"), "--set", "swaths.method=brute-force", "--set",
                       "swaths.step_deg=0.01", "--out", folder.filePath("plan")});
        QVERIFY(process.waitForStarted());
        // Blocked in every thread from the first lines on; until then the signal would just end the program.
        const QString status = QStringLiteral("/proc/%1/status").arg(process.processId());
        QTRY_VERIFY(contentsOf(status).contains("Threads:\t2") || contentsOf(status).contains("Threads:\t3"));
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(30'000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 130);
        QVERIFY(!QFile::exists(folder.filePath("plan/plan.geojson")));
    }
};

FURROW_TEST(TestCli);
#include "tst_cli.moc"
