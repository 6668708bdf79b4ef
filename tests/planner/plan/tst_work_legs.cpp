// The order in which headland passes and swaths are driven, seen in whole plans.

#include "planner/io/import/boundary_import.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

using namespace furrow;

namespace {

Result<std::shared_ptr<const Plan>> plannedWith(const QString& field, const QString& machine,
                                                std::initializer_list<const char*> settings) {
    const FieldSource source =
        readBoundaries(FURROW_SOURCE_DIR "/resources/sample_fields/" + field.toStdString() + ".geojson")
            .value()
            .front();
    PlanRequest request{.field = std::make_shared<const Field>(Field::create(source).value()),
                        .machine = findMachine(machine.toStdString()).value(),
                        .settings = {}};
    for (const std::string_view setting : settings) {
        const auto at = setting.find('=');
        applySetting(request.settings, setting.substr(0, at), std::string{setting.substr(at + 1)}).value();
    }
    return makePlan(request);
}

/// Of neighbours without the implement down.
Duration waysFrom(const Path& path, std::size_t from, int step) {
    Duration sum;
    for (auto i = static_cast<std::ptrdiff_t>(from) + step; i >= 0 && i < std::ssize(path.segments);
         i += step) {
        const PathSegment& segment = path.segments[static_cast<std::size_t>(i)];
        if (segment.implementDown) {
            break;
        }
        sum += segment.duration();
    }
    return sum;
}

}  // namespace

class WorkLegsTest : public QObject {
    Q_OBJECT

private slots:
    /// The cultivator leaves pieces of inner rings between the ponds and in the corners of this field. Ring
    /// by ring it drove three and a half minutes to a pass of 25 m and on, and more than two to another.
    void shortPassesAreDrivenWhereTheMachineComesBy() {
        const auto plan = plannedWith("three_ponds", "cultivator", {"route.compare=blocked"});
        VERIFY_RESULT(plan);
        const Path& path = (*plan)->path;
        int shortPasses = 0;
        for (std::size_t i = 0; i < path.segments.size(); ++i) {
            const PathSegment& segment = path.segments[i];
            if (segment.kind == SegmentKind::HeadlandPass && segment.length() < metres(40.0)) {
                ++shortPasses;
                const Duration ways = waysFrom(path, i, -1) + waysFrom(path, i, 1);
                QVERIFY2(ways < seconds(110.0), qPrintable(QString::number(ways.si())));
            }
        }
        QVERIFY(shortPasses > 5);
    }

    void allPassesAreDrivenOnce_data() {
        QTest::addColumn<QString>("field");
        QTest::addColumn<QString>("machine");
        QTest::addColumn<QString>("order");
        for (const char* field : {"bend", "home_field", "slanted_field", "three_ponds"}) {
            for (const char* machine : {"agbot", "cultivator", "trailed-sprayer"}) {
                for (const char* order : {"before", "after"}) {
                    QTest::addRow("%s, %s, %s", field, machine, order) << field << machine << order;
                }
            }
        }
    }
    void allPassesAreDrivenOnce() {
        QFETCH(QString, field);
        QFETCH(QString, machine);
        QFETCH(QString, order);
        const std::string when = "headland.when=" + order.toStdString();
        const auto plan = plannedWith(field, machine, {"route.compare=blocked", when.c_str()});
        VERIFY_RESULT(plan);
        Length driven;
        std::vector<int> swaths;
        for (const PathSegment& segment : (*plan)->path.segments) {
            if (segment.kind == SegmentKind::HeadlandPass) {
                driven += segment.length();
            } else if (segment.kind == SegmentKind::Swath) {
                swaths.push_back(segment.number);
            }
        }
        Length laid;
        for (const HeadlandPass& pass : (*plan)->headland.drivenPasses) {
            for (const PassStretch& stretch : pass.stretches) {
                laid += stretch.working ? stretch.line.length() : Length{};
            }
        }
        // Steering makes lines shorter and longer by a little.
        COMPARE_WITHIN(driven.si(), laid.si(), 0.01 * laid.si());
        // And the swaths in the order of the route.
        std::vector<int> route;
        for (const RouteStep& step : (*plan)->route.steps) {
            route.push_back((*plan)->swaths.swaths[step.swath].number);
        }
        QCOMPARE(swaths, route);
    }
};

FURROW_TEST(WorkLegsTest);
#include "tst_work_legs.moc"
