// Projects of the window on the command line: the same plan, and what is given wins.

#include "planner/geodesy/local_frame.h"
#include "planner/io/delivery/plan_folder.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/project/field_tasks.h"
#include "planner/project/project_file.h"
#include "tests/support/field_generator.h"
#include "tests/support/furrow_cli.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

using namespace furrow;
using namespace furrow::test;

namespace {

FieldPlan planCalled(const std::string& id, const std::string& name, const char* machine,
                     std::initializer_list<std::pair<const char*, const char*>> settings) {
    FieldPlan plan{.id = id,
                   .name = name,
                   .season = "2026",
                   .machine = findMachine(machine).value(),
                   .settings = {},
                   .others = {}};
    for (const auto& [key, value] : settings) {
        if (!applySetting(plan.settings, key, value)) {
            qFatal("%s is no setting", key);
        }
    }
    return plan;
}

/// 200 by 120 m, with a headland of 20 m along its southern edge.
std::shared_ptr<const ProjectField> fieldCalled(const std::string& id, const std::string& name, double lonDeg,
                                                std::vector<FieldPlan> plans) {
    FieldSource source = fieldSourceFromLocal({centredRectangle(200.0, 120.0)}, {lonDeg, 52.0});
    source.id = source.name = name;
    source.edgeHeadlands = {{.part = 0, .ring = 0, .edge = 0, .width = metres(20.0)}};
    return std::make_shared<const ProjectField>(
        ProjectField{.id = id,
                     .source = std::make_shared<const FieldSource>(std::move(source)),
                     .plans = std::move(plans),
                     .others = {},
                     .obstacleOthers = {},
                     .gateOthers = {}});
}

Project farm() {
    Project project = Project::empty();
    project.name = "Farm";
    project.fields = {
        fieldCalled("field-1", "North", 5.0,
                    {planCalled("plan-1", "Spring", "agbot",
                                {{"swaths.method", "fixed"}, {"swaths.angle_deg", "90"}}),
                     planCalled("plan-2", "Autumn", "power-harrow-drill", {{"headland.passes", "2"}})}),
        fieldCalled("field-2", "South", 5.01, {planCalled("plan-3", "Spring", "cultivator", {})})};
    project.currentField = 0;
    project.currentPlan = 1;
    return project;
}

}  // namespace

class ProjectCliTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString farm_;
    Project project_ = farm();

    QString at(const QString& name) const { return folder_.filePath(name); }

    /// What the window plans, written as path.csv.
    QByteArray expectedPath(const FieldSource& source, const Machine& machine,
                            const Settings& settings) const {
        const auto field = std::make_shared<const Field>(Field::create(source).value());
        const auto plan = makePlan(planRequest(field, machine, settings, {}).value()).value();
        const QTemporaryDir own;
        const std::vector<std::string_view> formats{"csv"};
        writePlanFolder(*plan, own.path().toStdString(), formats).value();
        return contentsOf(own.filePath("path.csv"));
    }
    QByteArray pathBy(const QStringList& more) const {
        const Answer answer = furrowCli(
            QStringList{"plan", farm_, "--field-id", "1", "--format", "csv", "--quiet", "--out", at("plan")} +
            more);
        return answer.status == 0 || answer.status == 1 ? contentsOf(at("plan/path.csv")) : answer.all();
    }

private slots:
    void initTestCase() {
        farm_ = at("Farm.furrow");
        VERIFY_RESULT(writeProject(project_, farm_.toStdString()));
    }

    void theCurrentPlan() {
        const FieldPlan& autumn = project_.fields[0]->plans[1];
        const FieldSource& source = *project_.fields[0]->source;
        const QByteArray path = pathBy({});
        QCOMPARE(path, expectedPath(source, autumn.machine, autumn.settings));
        // The edge's own headland is in it.
        FieldSource without = source;
        without.edgeHeadlands.clear();
        QVERIFY(path != expectedPath(without, autumn.machine, autumn.settings));
    }

    void theNamedPlan() {
        const FieldPlan& spring = project_.fields[0]->plans[0];
        const QByteArray path = expectedPath(*project_.fields[0]->source, spring.machine, spring.settings);
        QCOMPARE(pathBy({"--plan-name", "Spring"}), path);
        QCOMPARE(pathBy({"--plan-name", "plan-1"}), path);
    }

    void whatIsGivenWins() {
        const FieldPlan& autumn = project_.fields[0]->plans[1];
        Settings settings = autumn.settings;
        QVERIFY(applySetting(settings, "headland.passes", "3").has_value());
        QCOMPARE(pathBy({"--machine", "agbot", "--set", "headland.passes=3"}),
                 expectedPath(*project_.fields[0]->source, findMachine("agbot").value(), settings));
    }

    // The swaths of the spring plan run north; the search for the best plan leaves them so.
    void theBestPlanKeepsWhatThePlanHasSet() {
        const Answer answer = furrowCli({"plan", farm_, "--field-id", "1", "--plan-name", "Spring", "--best",
                                         "--out", at("best"), "--json"});
        QVERIFY2(answer.status == 0, answer.all());
        const QJsonObject settings = answer.json()["settings"].toObject();
        QCOMPARE(settings["swaths.method"].toString(), QStringLiteral("fixed"));
        QCOMPARE(settings["swaths.angle_deg"].toDouble(), 90.0);
        QVERIFY(answer.json()["best"].toObject()["alternatives"].toInt() > 0);
    }

    // Of a field that is not worked on the first plan.
    void anotherField() {
        const Answer answer =
            furrowCli({"plan", farm_, "--field-id", "South", "--json", "--out", at("south")});
        QCOMPARE(answer.json()["machine"].toString().isEmpty()
                     ? answer.json()["machine"].toObject()["name"].toString()
                     : answer.json()["machine"].toString(),
                 QString::fromStdString(findMachine("cultivator").value().name()));
    }

    void wrongNames_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("message");
        QTest::newRow("no such plan") << QStringList{farm_, "--field-id", "1", "--plan-name", "Summer"}
                                      << "it has: plan-1 'Spring', plan-2 'Autumn'";
        QTest::newRow("several fields") << QStringList{farm_} << "1 North";
        QTest::newRow("no project") << QStringList{sampleField("slanted_field"), "--plan-name", "Spring"}
                                    << "only the fields of a project have plans";
    }
    void wrongNames() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, message);
        const Answer answer = furrowCli(QStringList{"plan"} + arguments + QStringList{"--out", at("none")});
        QCOMPARE(answer.status, 2);
        QVERIFY2(answer.error.contains(message.toUtf8()), answer.error.constData());
        QVERIFY(!QDir{at("none")}.exists());
    }

    void aBatchOfIt() {
        const Answer answer = furrowCli({"batch", farm_, "--out", at("batch"), "--quiet"});
        QVERIFY2(answer.status == 0 || answer.status == 1, answer.error.constData());
        QMap<QString, QString> machines;
        for (const QByteArray& line : contentsOf(at("batch/batch.jsonl")).split('\n')) {
            const QJsonObject record = QJsonDocument::fromJson(line).object();
            if (!record.isEmpty()) {
                machines[record["id"].toString()] = record["machine"].toString();
            }
        }
        const auto nameOf = [](const char* id) {
            return QString::fromStdString(findMachine(id).value().name());
        };
        QCOMPARE(machines, (QMap<QString, QString>{{"North", nameOf("power-harrow-drill")},
                                                   {"South", nameOf("cultivator")}}));
    }

    // Whatever a plan is written with, it can be read as a field again.
    void aPlanIsAField() {
        const Answer plan =
            furrowCli({"plan", sampleField("slanted_field"), "--quiet", "--set", "field.margin_m=0.5",
                       "--set", "swaths.last_pass=gap", "--format", "geojson", "--out", at("margin")});
        QVERIFY2(plan.status == 0 || plan.status == 1, plan.error.constData());
        const Answer fields = furrowCli({"list", "fields", at("margin/plan.geojson"), "--json"});
        QVERIFY2(fields.status == 0, fields.error.constData());
        QCOMPARE(fields.json()["fields"].toArray().size(), 1);
    }

    // A second plan in a folder replaces the first as a whole; files of others stay.
    void aFolderHoldsOnePlan() {
        const auto plan = [&](const QString& formats, const QStringList& more) {
            return furrowCli(QStringList{"plan", sampleField("slanted_field"), "--quiet", "--out", at("one"),
                                         "--format", formats} +
                             more)
                .status;
        };
        const auto files = [&] {
            QStringList names;
            for (const char* name : {"summary.json", "plan.geojson", "path.csv", "TASKDATA/TASKDATA.XML",
                                     "TASKDATA/LINKLIST.XML", "note.txt"}) {
                if (QFile::exists(at("one/") + name)) {
                    names << name;
                }
            }
            return names;
        };
        QCOMPARE(plan("geojson,isoxml", {}), 0);
        writeFile(at("one/note.txt"), "my own");
        QCOMPARE(files(), (QStringList{"summary.json", "plan.geojson", "TASKDATA/TASKDATA.XML",
                                       "TASKDATA/LINKLIST.XML", "note.txt"}));
        QCOMPARE(plan("csv", {"--machine", "agbot"}), 0);
        QCOMPARE(files(), (QStringList{"summary.json", "path.csv", "note.txt"}));
        QVERIFY(!QDir{at("one/TASKDATA")}.exists());
        QCOMPARE(plan("csv", {"--machine", "agbot"}), 0);
        QCOMPARE(files(), (QStringList{"summary.json", "path.csv", "note.txt"}));
    }
};

FURROW_TEST(ProjectCliTest);
#include "tst_project_cli.moc"
