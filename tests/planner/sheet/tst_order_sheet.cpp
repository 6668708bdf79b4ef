#include "planner/io/delivery/plan_folder.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/sheet/order_sheet.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace furrow;
using namespace furrow::test;

namespace {

/// 200 by 120 m with a pond, a wet spot and two gates, worked from west to east.
std::shared_ptr<const Plan> samplePlan() {
    FieldSource source = fieldSourceFromLocal({centredRectangle(200.0, 120.0)}, {5.0, 52.0});
    source.id = "12";
    source.name = "Große Wiese";
    const auto frame = LocalFrame::centredOn({5.0, 52.0}).value();
    source.obstacles = {{.name = "Pond",
                         .outline = frame.toGeo(rectangle(20.0, 15.0, {30.0, 10.0})),
                         .passable = false,
                         .buffer = metres(1.0),
                         .overhang = {}}};
    source.gates = {{.name = "Road", .position = frame.toGeo(Point{-100.0, 0.0}), .width = metres(6.0)},
                    {.name = "Lane", .position = frame.toGeo(Point{100.0, 0.0}), .width = metres(6.0)}};
    Settings settings;
    for (const auto& [key, text] :
         {std::pair{"swaths.method", "fixed"}, {"swaths.angle_deg", "0"}, {"headland.passes", "2"}}) {
        if (!applySetting(settings, key, text)) {
            qFatal("%s is no setting", key);
        }
    }
    PlanRequest request{.field = std::make_shared<const Field>(Field::create(source).value()),
                        .machine = findMachine("cultivator").value(),
                        .settings = settings};
    return makePlan(request).value();
}

std::filesystem::path pathOf(const QString& name) {
    return name.toStdU16String();
}

}  // namespace

class TestOrderSheet : public QObject {
    Q_OBJECT

    std::shared_ptr<const Plan> plan_;
    QTemporaryDir folder_;

    QString at(const char* name) const { return folder_.filePath(QLatin1String{name}); }

private slots:
    void initTestCase() {
        plan_ = samplePlan();
        const std::string_view formats[] = {"geojson", "csv"};
        VERIFY_RESULT(writePlanFolder(*plan_, pathOf(at("plan")), formats));
    }

    void saysWhatThePlanIs() {
        const auto sheet = orderSheet(*plan_);
        VERIFY_RESULT(sheet);
        QCOMPARE(sheet->fieldName, std::string{"Große Wiese"});
        QCOMPARE(sheet->fieldId, std::string{"12"});
        QVERIFY(sheet->machine == plan_->request.machine);
        // 200 m by 120 m, less the pond of 20 by 15 m, which is an obstacle and not a part of the boundary.
        COMPARE_WITHIN(sheet->figures.field.si(), plan_->field().area().si(), 1e-6);
        COMPARE_WITHIN(sheet->figures.field.si(), 24000.0, 400.0);
        QCOMPARE(sheet->figures.headlandPasses, 2);
        QCOMPARE(sheet->obstacles.size(), std::size_t{1});
        QCOMPARE(sheet->obstacles[0].name, std::string{"Pond"});
        COMPARE_WITHIN(area(sheet->obstacles[0].outline).si(), 300.0, 0.5);
        QCOMPARE(sheet->gates.size(), std::size_t{2});
        COMPARE_WITHIN(sheet->gates[0].place.x, -100.0, 0.01);
        COMPARE_WITHIN(area(sheet->field).si(), 24000.0, 1.0);
    }

    void passesAreWhatIsDriven() {
        const auto sheet = orderSheet(*plan_);
        VERIFY_RESULT(sheet);
        double worked = 0.0;
        int swaths = 0;
        for (const SheetPass& pass : sheet->passes) {
            worked += pass.length.si();
            if (pass.kind != SegmentKind::Swath) {
                QVERIFY(!pass.bearingDeg);
                continue;
            }
            ++swaths;
            // Along the x axis: to the east or to the west.
            const double bearing = pass.bearingDeg.value();
            QVERIFY2(std::abs(bearing - 90.0) < 0.01 || std::abs(bearing - 270.0) < 0.01,
                     qPrintable(QString::number(bearing)));
            QVERIFY(pass.number >= 1);
        }
        QCOMPARE(swaths, static_cast<int>(plan_->route.steps.size()));
        QCOMPARE(swaths, sheet->figures.swaths);
        COMPARE_WITHIN(worked, sheet->figures.working.si(), 1e-6);
        COMPARE_WITHIN(sheet->figures.time.si(), plan_->path.duration().si(), 1e-9);
        COMPARE_WITHIN(sheet->figures.workingTime.si(), plan_->path.workedDuration().si(), 1e-9);
        int turns = 0;
        for (const SheetTurns& kind : sheet->turns) {
            QVERIFY(kind.count > 0 && !kind.type.empty());
            turns += kind.count;
        }
        QVERIFY(turns > 0);
        QVERIFY(std::ranges::is_sorted(sheet->turns, std::greater{}, &SheetTurns::count));
        QCOMPARE(sheet->start, plan_->path.segments.front().samples.front().position);
        QCOMPARE(sheet->end, plan_->path.segments.back().samples.back().position);
    }

    void settingsThatDiffer() {
        const auto sheet = orderSheet(*plan_);
        VERIFY_RESULT(sheet);
        std::vector<std::string> keys;
        for (const SheetSetting& setting : sheet->settings) {
            keys.emplace_back(setting.parameter->key);
        }
        QVERIFY(std::ranges::contains(keys, "swaths.method"));
        // Stands among the figures.
        QVERIFY(!std::ranges::contains(keys, "headland.passes"));
        // What the operation sets by itself is nothing that was chosen.
        QVERIFY(!std::ranges::contains(keys, "headland.when"));
    }

    void theFolderSaysTheSame() {
        const auto made = orderSheet(*plan_);
        const auto read = readOrderSheet(pathOf(at("plan")));
        VERIFY_RESULT(made);
        VERIFY_RESULT(read);
        // The hash on paper is made of these bytes.
        QVERIFY(made->pathFile == read->pathFile);
        QFile file{at("plan/path.csv")};
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll().toStdString(), made->pathFile);
        QCOMPARE(read->fieldName, made->fieldName);
        QVERIFY(read->machine == made->machine);
        QVERIFY(read->settings == made->settings);
        QVERIFY(read->turns == made->turns);
        QCOMPARE(read->passes.size(), made->passes.size());
        QCOMPARE(read->figures.time, made->figures.time);
        QCOMPARE(read->figures.covered, made->figures.covered);
        QCOMPARE(read->findings.size(), made->findings.size());
        for (std::size_t i = 0; i < read->findings.size(); ++i) {
            QCOMPARE(read->findings[i].text.text(), made->findings[i].text.text());
            QCOMPARE(read->findings[i].severity, made->findings[i].severity);
        }
        QCOMPARE(read->blockingCount(), plan_->blockingCount());
    }

    void fuelByHand() {
        MachineSpec spec = findMachine("cultivator").value().spec();
        spec.fuel.reset();
        QVERIFY(!fuelLitres(Machine::create(spec).value(), seconds(7200.0), seconds(10800.0)));
        spec.fuel = FuelUse{.workingLph = 20.0, .turningLph = 10.0};
        // Two hours of work and one of turning.
        QCOMPARE(fuelLitres(Machine::create(spec).value(), seconds(7200.0), seconds(10800.0)),
                 std::optional{50.0});
    }

    void theNearestGateIsWhereToMeet() {
        auto sheet = orderSheet(*plan_);
        VERIFY_RESULT(sheet);
        sheet->start = {90.0, 5.0};
        QVERIFY(meetingPlace(*sheet) == sheet->gates[1].geo);
        sheet->start = {-90.0, 5.0};
        QVERIFY(meetingPlace(*sheet) == sheet->gates[0].geo);
        sheet->gates.clear();
        QVERIFY(meetingPlace(*sheet) == sheet->startGeo);
    }

    void badFoldersSayWhich() {
        QCOMPARE(readOrderSheet(pathOf(at("none"))).error().code, ErrorCode::ReadFailed);
        for (const char* missing : {"summary.json", "path.csv", "plan.geojson"}) {
            QTemporaryDir copy;
            for (const char* name : {"summary.json", "path.csv", "plan.geojson"}) {
                if (QLatin1String{name} != QLatin1String{missing}) {
                    QVERIFY(
                        QFile::copy(at("plan/") + QLatin1String{name}, copy.filePath(QLatin1String{name})));
                }
            }
            const auto read = readOrderSheet(pathOf(copy.path()));
            QVERIFY(!read);
            QCOMPARE(read.error().code, ErrorCode::ReadFailed);
            QVERIFY2(read.error().line().contains(missing), read.error().line().c_str());
            QFile damaged{copy.filePath(QLatin1String{missing})};
            QVERIFY(damaged.open(QIODevice::WriteOnly));
            damaged.write("{}");
            damaged.close();
            const auto again = readOrderSheet(pathOf(copy.path()));
            QVERIFY(!again);
            QCOMPARE(again.error().code, ErrorCode::InputRefused);
        }
    }
};

FURROW_TEST(TestOrderSheet);
#include "tst_order_sheet.moc"
