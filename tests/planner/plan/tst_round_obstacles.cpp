#include "planner/geometry/curve_parts.h"
#include "planner/io/check/export_check.h"
#include "planner/io/content/field_content.h"
#include "planner/io/content/plan_content.h"
#include "planner/io/delivery/checked_files.h"
#include "planner/io/formats/registry.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace furrow;

namespace {

constexpr GeoPoint kCentre{9.5, 51.5};
// The outline in the field's frame may be off from what was drawn by so much.
constexpr double kDrawnM = 1e-3;

struct Pole {
    Point middle;
    double sizeM = 1.0;
    double bufferM = 0.0;
    bool passable = false;
};

/// A rectangle with its middle at the origin, and square poles in it.
std::shared_ptr<const Field> rectangleWith(const std::vector<Pole>& poles, double widthM, double heightM) {
    FieldSource source = test::fieldSourceFromLocal({test::centredRectangle(widthM, heightM)}, kCentre);
    const auto frame = LocalFrame::centredOn(kCentre).value();
    for (const Pole& pole : poles) {
        const Point corner = pole.middle - Point{0.5 * pole.sizeM, 0.5 * pole.sizeM};
        source.obstacles.push_back({.name = "pole",
                                    .outline = frame.toGeo(test::rectangle(pole.sizeM, pole.sizeM, corner)),
                                    .passable = pole.passable,
                                    .buffer = metres(pole.bufferM)});
    }
    return std::make_shared<const Field>(Field::create(source).value());
}

std::shared_ptr<const Field> squareWith(const std::vector<Pole>& poles) {
    return rectangleWith(poles, 100.0, 100.0);
}

Settings settingsOf(std::initializer_list<std::pair<std::string_view, std::string>> more) {
    Settings settings;
    for (const auto& [key, value] :
         {std::pair<std::string_view, std::string>{"swaths.method", "fixed"}, {"swaths.angle_deg", "0"}}) {
        applySetting(settings, key, value).value();
    }
    for (const auto& [key, value] : more) {
        applySetting(settings, key, value).value();
    }
    return settings;
}

std::shared_ptr<const Plan> planOf(
    const std::shared_ptr<const Field>& field, std::string_view machine,
    std::initializer_list<std::pair<std::string_view, std::string>> more = {}) {
    const auto plan =
        makePlan({.field = field, .machine = findMachine(machine).value(), .settings = settingsOf(more)});
    if (!plan) {
        qWarning("%s %zu: %s", machine.data(), more.size(), plan.error().line().c_str());
    }
    return plan.value();
}

std::vector<Swath> swathsGoingRound(const Plan& plan) {
    std::vector<Swath> round;
    std::ranges::copy_if(plan.swaths.swaths, std::back_inserter(round), &Swath::goesRound);
    return round;
}

/// How far a swath that lies to the east gets from its track, to the left.
std::pair<double, double> asideM(const Swath& swath, double trackYM) {
    const auto [low, high] = std::ranges::minmax(middleLine(swath), {}, &Point::y);
    return {low.y - trackYM, high.y - trackYM};
}

/// The y of a track near the middle, where nothing is in the way.
double middleTrackYM(std::string_view machine) {
    const auto plain = planOf(squareWith({}), machine);
    const auto& swaths = plain->swaths.swaths;
    return swaths[swaths.size() / 2].start.y;
}

bool isClear(const Plan& plan) {
    // Twice the error of drawing a path.
    return plan.audit.minClearance && *plan.audit.minClearance > metres(-0.01);
}

QByteArray told(const Plan& plan) {
    QByteArray text =
        QByteArray::number(plan.audit.minClearance ? plan.audit.minClearance->si() : NAN) + " m clear; ";
    for (const Finding& finding : plan.findings) {
        if (finding.severity == Severity::Blocking) {
            text += QByteArray::fromStdString(std::string{finding.text}) + " ";
        }
    }
    return text;
}

}  // namespace

class RoundObstaclesTest : public QObject {
    Q_OBJECT

private slots:
    // A pole of 1 m on the track of a cultivator of 6 m: it has to move by 3 m and half a metre. Nothing else
    // is moved, and it is back on its track at both ends.
    void aPoleOnATrack() {
        const double trackYM = middleTrackYM("cultivator");
        const auto plan = planOf(squareWith({{{0.0, trackYM}}}), "cultivator");
        const auto plain = planOf(squareWith({}), "cultivator");
        QCOMPARE(plan->swaths.swaths.size(), plain->swaths.swaths.size());
        QCOMPARE(plan->swaths.goneRound.size(), std::size_t{1});
        const auto round = swathsGoingRound(*plan);
        QCOMPARE(round.size(), std::size_t{1});
        const auto [right, left] = asideM(round.front(), trackYM);
        const double shiftM = std::max(left, -right);
        QVERIFY2(shiftM >= 3.5 && shiftM < 3.9, qPrintable(QString::number(shiftM)));
        QVERIFY2(std::min(left, -right) < kDrawnM, qPrintable(QString::number(std::min(left, -right))));
        COMPARE_WITHIN(round.front().start.y, trackYM, kDrawnM);
        COMPARE_WITHIN(round.front().end.y, trackYM, kDrawnM);
        // The radius is 6 m, with a tenth to spare.
        QVERIFY(sharpestBend(round.front().curve).si() <= 1.0 / 6.6 + 1e-6);
        QVERIFY2(plan->drivable() && isClear(*plan), told(*plan));
        // The headland and the mainland are those of the field without it, but for the pole.
        QCOMPARE(plan->headland.passes, plain->headland.passes);
        COMPARE_WITHIN((area(plain->headland.mainland) - area(plan->headland.mainland)).si(), 1.0, 0.01);
    }

    // Between two tracks both give way, each to its own side: by the half pole.
    void aPoleBetweenTracks() {
        const double trackYM = middleTrackYM("cultivator") + 3.0;
        const auto plan = planOf(squareWith({{{0.0, trackYM}}}), "cultivator");
        const auto round = swathsGoingRound(*plan);
        QCOMPARE(round.size(), std::size_t{2});
        const auto below = asideM(round[0], trackYM - 3.0);
        const auto above = asideM(round[1], trackYM + 3.0);
        QVERIFY2(below.first <= -0.5 && below.first > -1.0 && below.second < kDrawnM,
                 qPrintable(QString::number(below.first)));
        QVERIFY2(above.second >= 0.5 && above.second < 1.0 && above.first > -kDrawnM,
                 qPrintable(QString::number(above.second)));
        QVERIFY2(plan->drivable() && isClear(*plan), told(*plan));
    }

    // Less time and turns than around a headland of its own, and hardly less land.
    void goingRoundIsQuicker() {
        const auto field = squareWith({{{5.0, 2.0}}});
        for (const char* machine : {"cultivator", "agbot"}) {
            const auto round = planOf(field, machine);
            const auto cut = planOf(field, machine, {{"swaths.round_up_to_m", "0"}});
            QVERIFY2(round->drivable() && isClear(*round), told(*round));
            QCOMPARE(round->swaths.goneRound.size(), std::size_t{1});
            QVERIFY(cut->swaths.goneRound.empty());
            QVERIFY(round->path.turnCount() < cut->path.turnCount());
            QVERIFY(round->path.duration() < cut->path.duration());
            QVERIFY(area(round->headland.mainland) > area(cut->headland.mainland));
            // At most half a percent of a hectare beside the pole.
            QVERIFY2(
                *round->audit.coveredShare > *cut->audit.coveredShare - 0.005,
                qPrintable(QString("%1 %2").arg(*round->audit.coveredShare).arg(*cut->audit.coveredShare)));
        }
    }

    void whatCounts_data() {
        QTest::addColumn<double>("sizeM");
        QTest::addColumn<double>("bufferM");
        QTest::addColumn<bool>("passable");
        QTest::addColumn<double>("x");
        QTest::addColumn<QString>("upTo");
        QTest::addColumn<int>("gone");
        // 6 m across corners: a square of 4.2 m is 5.94 m, one of 4.3 m 6.08 m.
        QTest::newRow("as large as may be") << 4.2 << 0.0 << false << 0.0 << "auto" << 1;
        QTest::newRow("just larger") << 4.3 << 0.0 << false << 0.0 << "auto" << 0;
        QTest::newRow("larger with its buffer") << 3.0 << 1.0 << false << 0.0 << "auto" << 0;
        QTest::newRow("with a buffer") << 1.0 << 0.5 << false << 0.0 << "auto" << 1;
        QTest::newRow("larger, as the user wants") << 4.3 << 0.0 << false << 0.0 << "7" << 1;
        QTest::newRow("smaller, as the user wants") << 1.5 << 0.0 << false << 0.0 << "2" << 0;
        QTest::newRow("never") << 1.0 << 0.0 << false << 0.0 << "0" << 0;
        QTest::newRow("may be driven on") << 1.0 << 0.0 << true << 0.0 << "auto" << 0;
        QTest::newRow("on the boundary") << 1.0 << 0.0 << false << 50.0 << "auto" << 0;
        QTest::newRow("in the headland") << 1.0 << 0.0 << false << 45.0 << "auto" << 0;
    }
    void whatCounts() {
        QFETCH(double, sizeM);
        QFETCH(double, bufferM);
        QFETCH(bool, passable);
        QFETCH(double, x);
        QFETCH(QString, upTo);
        QFETCH(int, gone);
        const double trackYM = middleTrackYM("cultivator");
        // Nearer to one side of its lane, so that going round takes less.
        const auto field = squareWith({{{x, trackYM + 2.5}, sizeM, bufferM, passable}});
        const auto plan = planOf(field, "cultivator", {{"swaths.round_up_to_m", upTo.toStdString()}});
        QCOMPARE(static_cast<int>(plan->swaths.goneRound.size()), gone);
        if (gone == 0) {
            const auto cut = planOf(field, "cultivator", {{"swaths.round_up_to_m", "0"}});
            QCOMPARE(plan->swaths.swaths, cut->swaths.swaths);
            QCOMPARE(plan->path.segments.size(), cut->path.segments.size());
        } else {
            QVERIFY2(plan->drivable() && isClear(*plan), told(*plan));
        }
    }

    // Two poles that a cultivator does not fit between, along its track and across it.
    void twoPolesInOneGo_data() {
        QTest::addColumn<double>("alongM");
        QTest::addColumn<double>("acrossM");
        QTest::newRow("behind each other") << 4.0 << 0.0;
        QTest::newRow("behind each other, on both sides") << 6.0 << 1.5;
        QTest::newRow("beside each other") << 0.0 << 4.0;
        QTest::newRow("at a slant") << 8.0 << 5.0;
    }
    void twoPolesInOneGo() {
        QFETCH(double, alongM);
        QFETCH(double, acrossM);
        const double trackYM = middleTrackYM("cultivator");
        const auto plan = planOf(squareWith({{{-0.5 * alongM, trackYM - 0.5 * acrossM}},
                                             {{0.5 * alongM, trackYM + 0.5 * acrossM}}}),
                                 "cultivator");
        QVERIFY2(plan->drivable() && isClear(*plan), told(*plan));
        if (acrossM == 0.0) {
            // One way round both: it comes back to the track once.
            QCOMPARE(plan->swaths.goneRound.size(), std::size_t{2});
            QCOMPARE(swathsGoingRound(*plan).size(), std::size_t{1});
        }
    }

    // Near its end a swath has no room to come back.
    void aPoleNearTheEnd() {
        const double trackYM = middleTrackYM("cultivator");
        const auto plain = planOf(squareWith({}), "cultivator");
        const double endXM = bounds(plain->headland.mainland).max.x;
        const auto plan = planOf(squareWith({{{endXM - 3.0, trackYM}}}), "cultivator");
        QVERIFY2(plan->drivable() && isClear(*plan), told(*plan));
        QCOMPARE(plan->swaths.goneRound.size(), std::size_t{1});
        const auto round = swathsGoingRound(*plan);
        QCOMPARE(round.size(), std::size_t{1});
        QVERIFY(std::abs(round.front().end.y - trackYM) > 3.5);
        COMPARE_WITHIN(round.front().start.y, trackYM, kDrawnM);
    }

    // The figures of the set, against the audit's of what is driven: what is missed lies beside the pole.
    void coverageIsMeasuredWithTheBend() {
        const auto field = squareWith({{{5.0, 2.0}}});
        // Neither with short passes, which work what the corners leave.
        const std::initializer_list<std::pair<std::string_view, std::string>> given{
            {"swaths.ends", "centre"}, {"headland.finish", "false"}};
        const auto plan = planOf(field, "cultivator", given);
        const auto plain = planOf(squareWith({}), "cultivator", given);
        COMPARE_WITHIN(plain->swaths.coverage, 1.0, 1e-6);
        const double missedM2 = (1.0 - plan->swaths.coverage) * area(plan->headland.mainland).si();
        const double auditedM2 = (plan->audit.left - plain->audit.left).si();
        QVERIFY2(missedM2 > 1.0, qPrintable(QString::number(missedM2)));
        COMPARE_WITHIN(missedM2, auditedM2, 8.0);
        QVERIFY(plan->swaths.totalLength > plain->swaths.totalLength);
    }

    // Dozens of poles in generated fields, for machines of every kind: nothing is touched, nothing is blocked
    // that would not be if all were cut, and where poles are not closer to each other than bends are long
    // most are gone round.
    void fieldsFullOfPoles_data() {
        QTest::addColumn<QString>("machine");
        QTest::addColumn<double>("widthM");
        QTest::addColumn<int>("poles");
        QTest::addColumn<double>("leastShare");
        QTest::newRow("robot, dozens") << "agbot" << 200.0 << 24 << 0.5;
        QTest::newRow("mounted, dozens") << "cultivator" << 300.0 << 24 << 0.2;
        QTest::newRow("mounted, some") << "cultivator" << 400.0 << 6 << 0.6;
        QTest::newRow("trailed, some") << "trailed-sprayer" << 500.0 << 4 << 0.4;
    }
    void fieldsFullOfPoles() {
        QFETCH(QString, machine);
        QFETCH(double, widthM);
        QFETCH(int, poles);
        QFETCH(double, leastShare);
        constexpr std::uint64_t kSeed = 7400;
        const Machine driving = findMachine(machine.toStdString()).value();
        // Poles lie well inside of the headland.
        const double heightM = 100.0 + 8.0 * driving.operatingWidth().si();
        std::mt19937_64 random{kSeed};
        std::size_t gone = 0;
        for (int i = 0; i < 2; ++i) {
            std::vector<Pole> all;
            for (int k = 0; k < poles; ++k) {
                all.push_back({{test::uniform(random, 60.0 - 0.5 * widthM, 0.5 * widthM - 60.0),
                                test::uniform(random, -45.0, 45.0)},
                               test::uniform(random, 0.2, 1.0)});
            }
            const auto field = rectangleWith(all, widthM, heightM);
            const auto plan = planOf(field, machine.toStdString());
            const QByteArray which = QStringLiteral("seed %1, field %2: ").arg(kSeed).arg(i).toUtf8();
            if (!plan->drivable()) {
                const auto cut = planOf(field, machine.toStdString(), {{"swaths.round_up_to_m", "0"}});
                VERIFY_TOLD(!cut->drivable(), which + told(*plan));
            } else {
                VERIFY_TOLD(isClear(*plan), which + told(*plan));
            }
            gone += plan->swaths.goneRound.size();
            for (const Swath& swath : plan->swaths.swaths) {
                VERIFY_TOLD(
                    sharpestBend(swath.curve) <= Curvature::fromSi(1.0 / driving.minTurningRadius().si()),
                    which);
            }
            // Cells are the mainland, poles left out.
            double cellsM2 = 0.0;
            for (const Cell& cell : plan->cells.cells) {
                cellsM2 += area(cell.outline).si();
            }
            VERIFY_TOLD(std::abs(cellsM2 / area(plan->headland.mainland).si() - 1.0) < 1e-6, which);
        }
        const double share = static_cast<double>(gone) / (2.0 * poles);
        QVERIFY2(share >= leastShare, qPrintable(QString::number(share)));
    }

    // What terminals get: the line of every swath that goes round is one of its own.
    void exportsPassTheirChecks_data() {
        QTest::addColumn<QString>("format");
        for (const Format& format : formats()) {
            if (format.writes()) {
                QTest::addRow("%s", format.id.data())
                    << QString::fromUtf8(format.id.data(), static_cast<qsizetype>(format.id.size()));
            }
        }
    }
    void exportsPassTheirChecks() {
        QFETCH(QString, format);
        const auto plan = planOf(squareWith({{{5.0, 2.0}}, {{-20.0, -14.0}, 0.6}}), "cultivator");
        QCOMPARE(plan->swaths.goneRound.size(), std::size_t{2});
        const std::vector fields{contentOf(*plan, {})};
        const ExportJob job{.fields = fields, .plan = plan.get(), .options = {}, .job = {}};
        const auto info = std::ranges::find(formats(), format.toStdString(), &Format::id);
        const auto written = checkedFiles(*info, job);
        VERIFY_RESULT(written);
        const ExportChecks checks = checkExport(*info, job, written->files);
        QVERIFY2(checks.problems.empty(),
                 checks.problems.empty() ? "" : std::string{checks.problems.front()}.c_str());
        const auto own = std::ranges::count_if(fields.front().lines, [](const GuidanceLine& line) {
            return line.name.starts_with("Swath ") && line.kind == GuidanceKind::Curve && !line.repeats;
        });
        QCOMPARE(own, static_cast<std::ptrdiff_t>(swathsGoingRound(*plan).size()));
    }
};

FURROW_TEST(RoundObstaclesTest);
#include "tst_round_obstacles.moc"
