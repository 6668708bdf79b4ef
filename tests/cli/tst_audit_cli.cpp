#include "planner/io/delivery/plan_folder.h"
#include "planner/io/import/boundary_import.h"
#include "planner/io/plan_files/plan_reader.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/furrow_cli.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

using namespace furrow;
using test::Answer;
using test::contentsOf;
using test::furrowCli;

namespace {

std::shared_ptr<const Plan> planOf(const QString& sample, const QString& machine,
                                   const QStringList& settings = {}) {
    const auto source = readBoundaries(test::sampleField(sample).toStdString());
    Settings chosen;
    for (const QString& setting : settings) {
        applySetting(chosen, setting.section('=', 0, 0).toStdString(), setting.section('=', 1).toStdString())
            .value();
    }
    return makePlan({.field = std::make_shared<const Field>(Field::create(source->front()).value()),
                     .machine = findMachine(machine.toStdString()).value(),
                     .settings = chosen})
        .value();
}

void write(const Plan& plan, const QString& folder) {
    writePlanFolder(plan, folder.toStdString(), standardPlanFormats()).value();
}

}  // namespace

class TestAuditCli : public QObject {
    Q_OBJECT
private slots:
    // The planner's own audit and the one of the written files agree to 0.1 m² and 1 mm.
    void writtenFolderGivesTheSameFigures_data() {
        QTest::addColumn<QString>("sample");
        QTest::addColumn<QString>("machine");
        QTest::addColumn<QStringList>("settings");
        QTest::newRow("plain") << "home_field" << "agbot" << QStringList{};
        QTest::newRow("trailed") << "slanted_field" << "trailed-sprayer" << QStringList{};
        QTest::newRow("obstacles") << "three_ponds" << "mounted-drill" << QStringList{};
        QTest::newRow("on the spot") << "long_strip" << "field-robot" << QStringList{"path.method=straight"};
        for (const char* method :
             {"dubins-cc", "reeds-shepp", "reeds-shepp-cc", "fishtail", "three-point", "omega"}) {
            QTest::addRow("%s turns", method)
                << "slanted_field" << "mounted-drill" << QStringList{QStringLiteral("path.method=") + method};
        }
        QTest::newRow("large") << "great_field" << "field-robot" << QStringList{"swaths.method=longest-edge"};
        QTest::newRow("trailed, clothoids")
            << "home_field" << "trailed-sprayer" << QStringList{"path.method=dubins-cc"};
        QTest::newRow("may leave the field")
            << "bend" << "agbot" << QStringList{"path.stay_inside=false", "headland.method=none"};
    }
    void writtenFolderGivesTheSameFigures() {
        QFETCH(QString, sample);
        QFETCH(QString, machine);
        QFETCH(QStringList, settings);
        const QTemporaryDir folder;
        const auto plan = planOf(sample, machine, settings);
        write(*plan, folder.path());
        const Answer answer = furrowCli({"audit", folder.path(), "--json"});
        QVERIFY2(answer.status == 0 || answer.status == 1, answer.error);
        QCOMPARE(answer.status == 0, plan->drivable());
        const QJsonObject own =
            QJsonDocument::fromJson(contentsOf(folder.filePath("summary.json"))).object()["audit"].toObject();
        const QJsonObject read = answer.json();
        for (const QString& key : own.keys()) {
            if (key == "findings" || own[key].isNull()) {
                QCOMPARE(read.contains(key), true);
                QCOMPARE(read[key].isNull(), own[key].isNull());
                continue;
            }
            const double tolerance = key.endsWith("_m2") ? 0.1 : key.endsWith("_m") ? 1e-3 : 1e-6;
            QVERIFY2(std::abs(read[key].toDouble() - own[key].toDouble()) <= tolerance,
                     qPrintable(QStringLiteral("%1: %2, own %3")
                                    .arg(key)
                                    .arg(read[key].toDouble(), 0, 'g', 12)
                                    .arg(own[key].toDouble(), 0, 'g', 12)));
        }
        // Kind by kind the findings of the files are those of the planner's audit.
        QStringList kinds;
        for (const AuditFinding& each : plan->audit.findings) {
            kinds << QString::fromStdString(std::string{kindId(each.finding)});
        }
        QStringList readKinds;
        for (const QJsonValue& each : read["findings"].toArray()) {
            readKinds << each.toObject()["kind"].toString();
        }
        QCOMPARE(readKinds, kinds);
    }
    void bareGeoJsonGivesAreas() {
        const QTemporaryDir folder;
        const auto plan = planOf("home_field", "agbot");
        write(*plan, folder.path());
        const Answer bare = furrowCli({"audit", folder.filePath("plan.geojson"), "--json"});
        // Without a machine the working line is where the path is: some more seems missed.
        QVERIFY2(bare.status <= 1, bare.all());
        QVERIFY(std::abs(bare.json()["covered"].toDouble() - *plan->audit.coveredShare) < 0.02);
        for (const char* key :
             {"outside_m2", "min_clearance_m", "max_curvature_1pm", "covered_of_reachable"}) {
            QVERIFY2(!bare.json().contains(QLatin1String(key)), key);
        }
        const Answer with =
            furrowCli({"audit", folder.filePath("plan.geojson"), "--machine", "agbot", "--json"});
        // Headings come from the points alone: a pass along the boundary may seem centimetres outside.
        QVERIFY2(with.status <= 1, with.all());
        QVERIFY(std::abs(with.json()["covered_m2"].toDouble() - plan->audit.covered->si()) <
                plan->audit.areaError.si());
        // And where one bends along it the strip beside its neighbour is a little wider or narrower.
        QVERIFY(std::abs(with.json()["overlap_m2"].toDouble() - plan->audit.overlap->si()) <
                0.005 * plan->audit.overlap->si());
        QVERIFY(std::abs(with.json()["min_clearance_m"].toDouble() - plan->audit.minClearance->si()) < 0.06);
    }
    void aBrokenFileIsNoticed() {
        const QTemporaryDir folder;
        write(*planOf("home_field", "agbot"), folder.path());
        const QString csv = folder.filePath("path.csv");
        QList<QByteArray> lines = contentsOf(csv).split('\n');
        // On the straight of a swath: on a bend the audit allows for steering between two samples.
        qsizetype moved = 2;
        while (moved + 1 < lines.size() &&
               !(lines[moved - 1].contains(",swath,") && lines[moved + 1].contains(",swath,"))) {
            ++moved;
        }
        QList<QByteArray> cells = lines[moved].split(',');
        QVERIFY(cells.size() > 2);
        cells[2] = QByteArray::number(cells[2].toDouble() + 1.0, 'g', 17);
        lines[moved] = cells.join(',');
        test::writeFile(csv, lines.join('\n'));
        const Answer answer = furrowCli({"audit", folder.path()});
        QCOMPARE(answer.status, 1);
        QVERIFY2(answer.out.contains("jumps by 1.00 m"), answer.out);
    }
    void printsATable() {
        const QTemporaryDir folder;
        write(*planOf("home_field", "agbot"), folder.path());
        const Answer answer = furrowCli({"audit", folder.path()});
        QCOMPARE(answer.status, 0);
        for (const char* word :
             {"Covered", "Missed", "Overlap", "Outside", "Exact to", "between headland and swaths"}) {
            QVERIFY2(answer.out.contains(word), answer.out);
        }
    }

    void refuses_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("status");
        QTest::addColumn<QByteArray>("told");
        QTest::newRow("summary is no JSON")
            << "summary.json" << QByteArray{"{"} << 3 << QByteArray{"summary.json"};
        QTest::newRow("no local frame") << "summary.json" << QByteArray{"{}"} << 3 << QByteArray{"crs"};
        QTest::newRow("path without columns")
            << "path.csv" << QByteArray{"a,b\n1,2\n"} << 3 << QByteArray{"s_m"};
        QTest::newRow("empty path") << "path.csv" << QByteArray{} << 3 << QByteArray{"path.csv"};
        QTest::newRow("a number that is none")
            << "path.csv"
            << QByteArray{"s_m,t_s,x_m,y_m,lon_deg,lat_deg,heading_rad,curvature_1pm,speed_mps,gear,implement_down,segment,order,machine,level\n"
                          "0,0,nan,0,0,0,0,0,1,1,1,swath,0,0,\n"}
            << 3 << QByteArray{"line 2"};
        QTest::newRow("plan is no plan")
            << "plan.geojson" << QByteArray{"[]"} << -1 << QByteArray{"plan.geojson"};
        QTest::newRow("field without a path")
            << "plan.geojson"
            << QByteArray{R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"kind":"field"},"geometry":)"
                          R"({"type":"Polygon","coordinates":[[[9,51],[9.01,51],[9.01,51.01],[9,51]]]}}]})"}
            << 3 << QByteArray{"segments"};
    }
    void refuses() {
        QFETCH(QString, file);
        QFETCH(QByteArray, text);
        QFETCH(int, status);
        QFETCH(QByteArray, told);
        const QTemporaryDir folder;
        write(*planOf("long_strip", "agbot"), folder.path());
        test::writeFile(folder.filePath(file), text);
        const Answer answer = furrowCli({"audit", folder.path(), "--json"});
        QVERIFY2(status < 0 ? answer.status == 3 || answer.status == 4 : answer.status == status,
                 answer.error);
        QVERIFY2(answer.error.contains(told), answer.error);
        QCOMPARE(answer.error.count('\n'), 1);
        QVERIFY(answer.out.isEmpty());
    }
    void statusOfWhatIsNotThere() {
        const QTemporaryDir folder;
        QCOMPARE(furrowCli({"audit", folder.filePath("nothing")}).status, 4);
        QCOMPARE(furrowCli({"audit", folder.path()}).status, 4);
        QCOMPARE(furrowCli({"audit"}).status, 2);
        QCOMPARE(furrowCli({"audit", folder.path(), "--nonsense"}).status, 2);
    }
};

FURROW_TEST(TestAuditCli);
#include "tst_audit_cli.moc"
