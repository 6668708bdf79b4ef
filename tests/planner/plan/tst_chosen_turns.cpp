#include "planner/machine/machine_library.h"
#include "planner/plan/advice.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

using namespace furrow;

// A kind of turn is chosen for the turns between swaths; whatever else is driven takes what fits.

namespace {

constexpr GeoPoint kCentre{9.2, 51.3};

std::shared_ptr<const Field> rectangle() {
    static const auto field = std::make_shared<const Field>(
        Field::create(test::fieldSourceFromLocal({test::rectangle(400.0, 250.0)}, kCentre)).value());
    return field;
}

Result<std::shared_ptr<const Plan>> planOf(
    const Machine& machine, std::initializer_list<std::pair<std::string_view, std::string_view>> given) {
    Settings settings;
    for (const auto& [key, text] : given) {
        applySetting(settings, key, text).value();
    }
    return makePlan({.field = rectangle(), .machine = machine, .settings = settings});
}

std::vector<const Finding*> found(const Plan& plan, FindingKind kind) {
    std::vector<const Finding*> all;
    for (const Finding& finding : plan.findings) {
        if (finding.kind == kind) {
            all.push_back(&finding);
        }
    }
    return all;
}

/// "a; b": what blocks the plan.
std::string blocking(const Plan& plan) {
    std::string said;
    for (const Finding& finding : plan.findings) {
        said += finding.severity == Severity::Blocking ? std::string{finding.text} + "; " : "";
    }
    return said;
}

/// Of all ways from one swath to the next: how many are of this kind in all their segments, and how many
/// there are.
std::pair<int, int> turnsOfKind(const Plan& plan, std::string_view kind) {
    int ofKind = 0;
    int all = 0;
    const auto& segments = plan.path.segments;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const bool begins = i > 0 && segments[i - 1].kind == SegmentKind::Swath && !segments[i].implementDown;
        const PathSegment* const after = begins ? plan.path.workAfter(i) : nullptr;
        if (after == nullptr || after->kind != SegmentKind::Swath) {
            continue;
        }
        ++all;
        bool isOfKind = true;
        for (; &segments[i] != after; ++i) {
            isOfKind = isOfKind && segments[i].turnType == kind;
        }
        ofKind += isOfKind ? 1 : 0;
    }
    return {ofKind, all};
}

}  // namespace

class ChosenTurnsTest : public QObject {
    Q_OBJECT

private slots:
    void everyKindOnARectangle_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("machine");
        for (const MethodInfo& kind : stageInfo("path").methods) {
            for (const char* machine : {"agbot", "cultivator", "plough", "trailed-sprayer", "field-robot"}) {
                QTest::addRow("%s, %s", std::string{kind.id}.c_str(), machine)
                    << QString::fromUtf8(kind.id.data(), static_cast<qsizetype>(kind.id.size())) << machine;
            }
        }
    }
    void everyKindOnARectangle() {
        QFETCH(QString, kind);
        QFETCH(QString, machine);
        const Machine driven = findMachine(machine.toStdString()).value();
        const std::string id = kind.toStdString();
        const auto plan = planOf(driven, {{"path.method", id}});
        VERIFY_RESULT(plan);
        const auto notes = found(**plan, FindingKind::TurnKind);
        if (id == "straight" && !driven.spec().tractor.canTurnInPlace) {
            // Nothing but what was asked for is in the way, and the finding brings what mends it.
            const auto advised = withAdvice(*plan, {});
            VERIFY_RESULT(advised);
            const auto jumps = found(**advised, FindingKind::HeadingJump);
            QCOMPARE(jumps.size(), std::size_t{1});
            QCOMPARE(std::ranges::count((*plan)->findings, Severity::Blocking, &Finding::severity), 1);
            QVERIFY(std::string{jumps.front()->text}.contains("path.method"));
            QVERIFY(jumps.front()->change.has_value());
            const auto mended = planOf(driven, {{jumps.front()->change->key, jumps.front()->change->value}});
            VERIFY_RESULT(mended);
            QVERIFY2((*mended)->drivable(), blocking(**mended).c_str());
            return;
        }
        QVERIFY2((*plan)->drivable(), blocking(**plan).c_str());
        if (id == "best-feasible") {
            QVERIFY(notes.empty());
            return;
        }
        const auto [ofKind, all] = turnsOfKind(**plan, id);
        QVERIFY(all > 0);
        QCOMPARE(notes.size(), std::size_t(ofKind < all ? 1 : 0));
        if (!notes.empty()) {
            const std::string said = notes.front()->text;
            QVERIFY2(said.contains("path.method") &&
                         said.contains(std::to_string(all - ofKind) + " of " + std::to_string(all)),
                     said.c_str());
            QCOMPARE(notes.front()->change, (std::optional{SettingChange{"path.method", "best-feasible"}}));
        }
    }

    // Swaths 6 m apart and a radius of 6 m: an omega fits between all of them, a U turn, which needs 12 m,
    // between none.
    void oneThatFitsIsKept() {
        const Machine cultivator = findMachine("cultivator").value();
        const std::initializer_list<std::pair<std::string_view, std::string_view>> snug{
            {"path.method", "omega"},
            {"swaths.method", "longest-edge"},
            {"route.method", "boustrophedon"},
            {"headland.width_m", "24"}};
        const auto omega = planOf(cultivator, snug);
        VERIFY_RESULT(omega);
        const auto [omegas, all] = turnsOfKind(**omega, "omega");
        QCOMPARE(omegas, all);
        const auto u = planOf(
            cultivator,
            {{"path.method", "u"}, {"swaths.method", "longest-edge"}, {"route.method", "boustrophedon"}});
        VERIFY_RESULT(u);
        QCOMPARE(turnsOfKind(**u, "u").first, 0);
        const auto said = found(**u, FindingKind::TurnKind);
        QCOMPARE(said.size(), std::size_t{1});
        QVERIFY(std::string{said.front()->text}.contains("cannot be driven between these swaths"));
    }

    // What trails is not pushed back: kinds that reverse say so, and forward turns take their place.
    void whatCannotReverseSaysSo_data() {
        QTest::addColumn<QString>("kind");
        for (const char* kind : {"reeds-shepp", "reeds-shepp-cc", "fishtail", "three-point"}) {
            QTest::newRow(kind) << kind;
        }
    }
    void whatCannotReverseSaysSo() {
        QFETCH(QString, kind);
        const auto plan = planOf(findMachine("slurry-tanker").value(), {{"path.method", kind.toStdString()}});
        VERIFY_RESULT(plan);
        QVERIFY2((*plan)->drivable(), blocking(**plan).c_str());
        const auto said = found(**plan, FindingKind::TurnKind);
        QCOMPARE(said.size(), std::size_t{1});
        QVERIFY(std::string{said.front()->text}.contains("This machine cannot reverse."));
        QCOMPARE((*plan)->path.reversedLength(), Length{});
    }

    // Curvature that goes on smoothly from swath to swath and from pass to pass.
    void smoothSteeringStaysSmooth() {
        const auto plan = planOf(findMachine("cultivator").value(), {{"path.method", "reeds-shepp-cc"}});
        VERIFY_RESULT(plan);
        int smooth = 0;
        int all = 0;
        for (const PathSegment& segment : (*plan)->path.segments) {
            if (segment.kind == SegmentKind::Turn && !segment.turnType.empty()) {
                ++all;
                smooth += segment.turnType.ends_with("-cc") ? 1 : 0;
            }
        }
        QVERIFY2(all > 40 && smooth > 0.9 * all, qPrintable(QStringLiteral("%1 of %2").arg(smooth).arg(all)));
    }

    // Where nothing has to stay inside, the kind is kept everywhere, as in the paper.
    void mayLeaveTheField() {
        const auto plan = planOf(findMachine("cultivator").value(),
                                 {{"path.method", "fishtail"}, {"path.stay_inside", "false"}});
        VERIFY_RESULT(plan);
        QVERIFY(found(**plan, FindingKind::TurnKind).empty());
        for (const PathSegment& segment : (*plan)->path.segments) {
            QVERIFY(segment.turnType != "combined" && segment.turnType != "reeds-shepp" &&
                    segment.turnType != "omega");
        }
    }
};

FURROW_TEST(ChosenTurnsTest);
#include "tst_chosen_turns.moc"
