#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/field_generator.h"
#include "tests/support/real_fields.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <memory>
#include <string>

using namespace furrow;

// Headland passes driven clockwise are as good as those driven the other way round.

namespace {

constexpr GeoPoint kCentre{9.2, 51.3};

std::shared_ptr<const Field> fieldOf(const FieldSource& source) {
    return std::make_shared<const Field>(Field::create(source).value());
}

FieldSource sampleField(const char* name) {
    return readBoundaries(std::string{FURROW_SOURCE_DIR "/resources/sample_fields/"} + name + ".geojson")
        .value()
        .front();
}

/// East for west: the frame of a field lies about its own middle, so it is mirrored there as well.
FieldSource inAMirror(FieldSource source) {
    const double about = middleOf(source.parts).lonDeg;
    const auto turn = [about](GeoRing& ring) {
        std::ranges::reverse(ring);
        for (GeoPoint& point : ring) {
            point.lonDeg = 2.0 * about - point.lonDeg;
        }
    };
    for (GeoPolygon& part : source.parts) {
        turn(part.outer);
        std::ranges::for_each(part.holes, turn);
    }
    return source;
}

/// As it comes, or with its implement so far to the left.
Machine machineOf(std::string_view id, double leftM = 0.0) {
    MachineSpec spec = findMachine(id).value().spec();
    spec.implement.lateralOffset = metres(leftM);
    return Machine::create(spec).value();
}

enum class Draft { No, Yes };

Result<std::shared_ptr<const Plan>> planOf(const FieldSource& field, const Machine& machine,
                                           std::string_view direction, std::string_view corner = "quickest",
                                           Draft draft = Draft::No) {
    Settings settings;
    applySetting(settings, "headland.direction", direction).value();
    applySetting(settings, "headland.corner", corner).value();
    return makePlan(
        {.field = fieldOf(field), .machine = machine, .settings = settings, .draft = draft == Draft::Yes});
}

double workedRoundM(const Plan& plan) {
    double sumM = 0.0;
    for (const HeadlandPass& pass : plan.headland.drivenPasses) {
        sumM += pass.length().si();
    }
    return sumM;
}

/// Of all passes, to the left: a turn for each ring round the field, one to the right for each round an
/// obstacle.
double turnedRad(const Plan& plan) {
    double sum = 0.0;
    for (const HeadlandPass& pass : plan.headland.drivenPasses) {
        for (const PassStretch& stretch : pass.stretches) {
            for (const CurvePiece& piece : stretch.line.pieces) {
                sum += 0.5 * (piece.curvature + piece.endCurvature).si() * piece.length.si();
            }
        }
    }
    return sum;
}

double coveredShare(const Plan& plan) {
    return plan.audit.covered.value() / plan.audit.workable;
}

}  // namespace

class BothWaysRoundTest : public QObject {
    Q_OBJECT

private slots:
    void everyMachineOnARectangle_data() {
        QTest::addColumn<QString>("machine");
        for (const Machine& machine : machineLibrary()) {
            QTest::newRow(machine.id().c_str()) << QString::fromStdString(machine.id());
        }
    }
    void everyMachineOnARectangle() {
        QFETCH(QString, machine);
        const FieldSource field = test::fieldSourceFromLocal({test::rectangle(400.0, 250.0)}, kCentre);
        const auto plan = planOf(field, machineOf(machine.toStdString()), "clockwise");
        VERIFY_RESULT(plan);
        for (const Finding& finding : (*plan)->findings) {
            QVERIFY2(finding.severity != Severity::Blocking, std::string{finding.text}.c_str());
        }
        const auto other = planOf(field, machineOf(machine.toStdString()), "counter-clockwise");
        VERIFY_RESULT(other);
        COMPARE_WITHIN(coveredShare(**plan), coveredShare(**other), 1e-3);
    }

    // The passes that are driven clockwise are those that a mirror shows of the field that it shows.
    void passesAsInAMirror_data() {
        QTest::addColumn<QString>("field");
        QTest::addColumn<QString>("machine");
        QTest::addColumn<double>("leftM");
        for (const char* field : {"home_field", "bend", "three_ponds", "slanted_field"}) {
            QTest::addRow("%s, robot", field) << field << "agbot" << 0.0;
            QTest::addRow("%s, plough to the left", field) << field << "plough" << 0.4;
            QTest::addRow("%s, drill", field) << field << "mounted-drill" << 0.0;
            QTest::addRow("%s, sprayer", field) << field << "trailed-sprayer" << 0.0;
        }
    }
    void passesAsInAMirror() {
        QFETCH(QString, field);
        QFETCH(QString, machine);
        QFETCH(double, leftM);
        const FieldSource source = sampleField(qPrintable(field));
        const auto left = planOf(source, machineOf(machine.toStdString(), leftM), "counter-clockwise",
                                 "quickest", Draft::Yes);
        const auto right = planOf(inAMirror(source), machineOf(machine.toStdString(), -leftM), "clockwise",
                                  "quickest", Draft::Yes);
        VERIFY_RESULT(left);
        VERIFY_RESULT(right);
        // Rings are cut and rounded from another corner on.
        COMPARE_WITHIN(workedRoundM(**right), workedRoundM(**left), 0.01 * workedRoundM(**left));
        QVERIFY(turnedRad(**right) * turnedRad(**left) < 0.0);
    }

    // What is done with them as well, as far as the same is found from the other side: room to reach into a
    // corner is not always.
    void plansAsInAMirror_data() {
        QTest::addColumn<QString>("machine");
        QTest::addColumn<double>("leftM");
        QTest::newRow("robot") << "agbot" << 0.0;
        QTest::newRow("cultivator to the left") << "cultivator" << 0.2;
        QTest::newRow("drill") << "mounted-drill" << 0.0;
        QTest::newRow("sprayer") << "trailed-sprayer" << 0.0;
    }
    void plansAsInAMirror() {
        QFETCH(QString, machine);
        QFETCH(double, leftM);
        const FieldSource source = sampleField("home_field");
        const auto left =
            planOf(source, machineOf(machine.toStdString(), leftM), "counter-clockwise", "rounded");
        const auto right =
            planOf(inAMirror(source), machineOf(machine.toStdString(), -leftM), "clockwise", "rounded");
        VERIFY_RESULT(left);
        VERIFY_RESULT(right);
        QVERIFY((*left)->drivable() && (*right)->drivable());
        // Orders and numbers of passes that are equally quick are decided by rounding, and by where a search
        // begins: one may be longer and no slower.
        COMPARE_WITHIN((*right)->path.length().si(), (*left)->path.length().si(),
                       0.03 * (*left)->path.length().si());
        COMPARE_WITHIN((*right)->path.duration().si(), (*left)->path.duration().si(),
                       0.03 * (*left)->path.duration().si());
        COMPARE_WITHIN(coveredShare(**right), coveredShare(**left), 1e-3);
    }
};

FURROW_TEST(BothWaysRoundTest);
#include "tst_both_ways_round.moc"
