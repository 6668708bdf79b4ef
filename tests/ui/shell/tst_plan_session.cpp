#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/project/project_edits.h"
#include "planner/settings/operation.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/shell/drawn_boundary.h"
#include "ui/shell/session.h"

#include <QAbstractItemModelTester>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace furrow;
using test::drawnRectangle;

namespace {

int rowOf(const ParameterModel& model, const QString& key) {
    for (int row = 0; row < model.rowCount(); ++row) {
        if (model.data(model.index(row), ParameterModel::KeyRole).toString() == key) {
            return row;
        }
    }
    return -1;
}

/// The place of a method in its stage's list.
int methodIndex(std::string_view stageId, std::string_view methodId) {
    const std::vector<MethodInfo>& methods = stageInfo(stageId).methods;
    return static_cast<int>(std::ranges::find(methods, methodId, &MethodInfo::id) - methods.begin());
}

QVariant roleOf(const ParameterModel& model, const QString& key, int role) {
    return model.data(model.index(rowOf(model, key)), role);
}

QString figure(Session& session, int row) {
    return session.figures()->data(session.figures()->index(row), FiguresModel::ValueRole).toString();
}

/// 150 ha.
QList<QGeoCoordinate> largeRectangle() {
    return {{58.25, 22.5}, {58.25, 22.52}, {58.2615, 22.52}, {58.2615, 22.5}};
}

/// One point of the first ring, as it is dragged.
void moveVertex(Session& session, std::size_t vertex, const QGeoCoordinate& place, bool finished) {
    const Project& project = *session.document()->project();
    FieldSource source = *project.field()->source;
    source.parts.front().outer[vertex] = geoPoint(place);
    session.document()->change([] { return QStringLiteral("Move"); }, withSource(project, std::move(source)),
                               QStringLiteral("vertex"),
                               finished ? Document::Follows::Nothing : Document::Follows::More);
}

}  // namespace

/// The plan follows what is drawn, chosen and dragged.
class TestPlanSession : public QObject {
    Q_OBJECT

private slots:
    void modelsKeepTheirPromises() {
        Session session;
        QAbstractItemModelTester steps{session.planning()->steps()};
        QAbstractItemModelTester machine{session.planning()->machine()};
        QAbstractItemModelTester figures{session.figures()};
        QAbstractItemModelTester findings{session.findings()};
        QAbstractItemModelTester choices{session.opener()->choices()};
        QAbstractItemModelTester exporter{session.exporter()};
        std::vector<std::unique_ptr<QAbstractItemModelTester>> parameters;
        for (const char* step : {"field", "headland", "swaths", "decomposition", "route", "path"}) {
            parameters.push_back(std::make_unique<QAbstractItemModelTester>(
                session.planning()->steps()->parameters(QLatin1String{step})));
        }
        session.opener()->addDrawn(drawnRectangle());
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        ParameterModel* headland = session.planning()->steps()->parameters(QStringLiteral("headland"));
        headland->setChoice(rowOf(*headland, QStringLiteral("headland.method")),
                            methodIndex("headland", "none"));
        QTRY_COMPARE_WITH_TIMEOUT(session.shown()->plan()->headland.width.si(), 0.0, kPatienceMs);
        session.opener()->startNew();
        QCOMPARE(session.figures()->rowCount(), 0);
    }
    void beginsEmpty() {
        Session session;
        QCOMPARE(session.planning()->state(), PlanState::Empty);
        QVERIFY(!session.farm()->hasField());
        QVERIFY(!session.shown()->hasPlan());
        QVERIFY(session.shown()->drawing().isEmpty());
        QCOMPARE(session.planning()->steps()->rowCount(), 9);
    }
    void plansADrawnBoundary() {
        Session session;
        QSignalSpy opened{session.planning(), &Planning::fieldOpened};
        session.opener()->addDrawn(drawnRectangle());
        QCOMPARE(session.planning()->state(), PlanState::Planning);
        // It is shown at once, whatever the plan takes.
        QCOMPARE(opened.count(), 1);
        QVERIFY(session.shown()->drawing().bounds().contains(QGeoCoordinate{58.2515, 22.5035}));
        const auto step = [&session](int role) {
            return session.planning()->steps()->index(0).data(role).toString();
        };
        QCOMPARE(step(StepsModel::ChoiceRole), QStringLiteral("Field 1"));
        QVERIFY2(step(StepsModel::ResultRole).startsWith(QStringLiteral("16.")),
                 qPrintable(step(StepsModel::ResultRole)));
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        QCOMPARE(opened.count(), 2);
        QVERIFY(!session.shown()->drawing().isEmpty());
        QVERIFY(session.planning()->statusText().startsWith(QStringLiteral("Plan ready")));
        // 0.007 by 0.0035 degrees at 58.25 north are some 411 by 390 metres.
        QVERIFY(figure(session, 0).startsWith(QStringLiteral("16.")));
    }
    // A sprayer sprays; it is one step to take back. Another number of the same machine changes nothing of
    // it.
    void aMachineBringsItsOperation() {
        // What is remembered has a place of its own.
        QCoreApplication::setOrganizationName(QStringLiteral("Furrow tests"));
        QSettings{}.clear();
        Session session;
        session.opener()->addDrawn(drawnRectangle());
        const auto operation = [&session] {
            return QString::fromStdString(session.planning()->settings().choice(kOperationKind));
        };
        const auto indexOf = [](std::string_view id) {
            const auto library = machineLibrary();
            return static_cast<int>(std::ranges::find(library, id, &Machine::id) - library.begin());
        };
        QCOMPARE(operation(), QStringLiteral("tillage"));
        session.planning()->machine()->setLibraryIndex(indexOf("trailed-sprayer"));
        QCOMPARE(operation(), QStringLiteral("spraying"));
        session.document()->undo();
        QCOMPARE(operation(), QStringLiteral("tillage"));
        QCOMPARE(session.planning()->machine()->machine().id(), machineLibrary().front().id());
        session.document()->redo();
        session.planning()->apply({.key = "operation.kind", .value = "spreading"});
        QCOMPARE(operation(), QStringLiteral("spreading"));
        session.planning()->machine()->setNumber(0, 20.0);
        QCOMPARE(operation(), QStringLiteral("spreading"));
        // The next project begins with it.
        session.opener()->startNew();
        QCOMPARE(session.planning()->machine()->machine().id(), std::string{"trailed-sprayer"});
        QCOMPARE(session.planning()->machine()->machine().operatingWidth().si(), 20.0);
        // And the next start shows it before there is a field.
        Session next;
        QCOMPARE(next.planning()->machine()->machine().id(), std::string{"trailed-sprayer"});
        QSettings{}.clear();
        QCoreApplication::setOrganizationName({});
    }
    // A machine that was fitted to one's own is kept, comes again in another session, and goes.
    void ownMachinesComeAgain() {
        const QTemporaryDir folder;
        {
            Session session;
            session.keepIn(folder.path());
            session.opener()->addDrawn(drawnRectangle());
            MachineModel& machine = *session.planning()->machine();
            const int count = static_cast<int>(machine.library().size());
            machine.setNumber(0, 7.3);
            QVERIFY(machine.isChanged() && !machine.isOwn());
            machine.keepAs(QStringLiteral(" Our cultivator "));
            QVERIFY(machine.isOwn() && !machine.isChanged());
            QCOMPARE(machine.name(), QStringLiteral("Our cultivator"));
            QCOMPARE(machine.library().size(), count + 1);
            QCOMPARE(machine.libraryIndex(), count);
            // The same name is the same machine.
            machine.setNumber(0, 7.4);
            machine.keepAs(QStringLiteral("Our cultivator"));
            QCOMPARE(machine.library().size(), count + 1);
        }
        Session again;
        again.keepIn(folder.path());
        MachineModel& machine = *again.planning()->machine();
        QCOMPARE(machine.library().last(), QStringLiteral("Our cultivator"));
        machine.setLibraryIndex(static_cast<int>(machine.library().size()) - 1);
        QCOMPARE(machine.machine().operatingWidth().si(), 7.4);
        machine.forget();
        QVERIFY(!machine.isOwn());
        QVERIFY(!machine.library().contains(QStringLiteral("Our cultivator")));
        QCOMPARE(machine.machine().operatingWidth().si(), 7.4);
    }
    void everyMachineHasAnOperation() {
        for (const Machine& machine : machineLibrary()) {
            Settings settings;
            QVERIFY2(settings.setText(kOperationKind, std::string{usualOperation(machine)}),
                     machine.id().c_str());
        }
    }
    void aNumberChangesThePlan() {
        Session session;
        session.opener()->addDrawn(drawnRectangle());
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        ParameterModel* headland = session.planning()->steps()->parameters(QStringLiteral("headland"));
        const QString width = QStringLiteral("headland.width_m");
        QVERIFY(roleOf(*headland, width, ParameterModel::AutoTextRole)
                    .toString()
                    .startsWith(QStringLiteral("auto · ")));
        headland->setNumber(rowOf(*headland, width), 30.0);
        QTRY_COMPARE_WITH_TIMEOUT(session.shown()->plan()->headland.width.si(), 30.0, kPatienceMs);
        QCOMPARE(roleOf(*headland, width, ParameterModel::AutoTextRole).toString(), QString{});
        QCOMPARE(roleOf(*headland, width, ParameterModel::ValueRole).toDouble(), 30.0);
        // At most one of width and passes is given: the later one counts.
        headland->setNumber(rowOf(*headland, QStringLiteral("headland.passes")), 2.0);
        QTRY_COMPARE_WITH_TIMEOUT(session.shown()->plan()->headland.passes, 2, kPatienceMs);
        QVERIFY(!roleOf(*headland, width, ParameterModel::AutoTextRole).toString().isEmpty());
        headland->setAuto(rowOf(*headland, QStringLiteral("headland.passes")));
        QTRY_VERIFY_WITH_TIMEOUT(
            session.planning()->settings() == Settings{} || session.shown()->plan()->headland.passes != 2,
            kPatienceMs);
    }
    void directionsAreBearings_data() {
        QTest::addColumn<double>("bearing");
        QTest::addColumn<double>("degreesFromEast");
        QTest::newRow("north") << 0.0 << 90.0;
        QTest::newRow("east") << 90.0 << 0.0;
        QTest::newRow("north-east") << 45.0 << 45.0;
        QTest::newRow("south-east") << 135.0 << 135.0;
    }
    void directionsAreBearings() {
        QFETCH(double, bearing);
        QFETCH(double, degreesFromEast);
        Session session;
        session.opener()->addDrawn(drawnRectangle());
        ParameterModel* swaths = session.planning()->steps()->parameters(QStringLiteral("swaths"));
        swaths->setChoice(rowOf(*swaths, QStringLiteral("swaths.method")), methodIndex("swaths", "fixed"));
        const int row = rowOf(*swaths, QStringLiteral("swaths.angle_deg"));
        QVERIFY(row >= 0);
        swaths->setNumber(row, bearing);
        QCOMPARE(swaths->data(swaths->index(row), ParameterModel::ValueRole).toDouble(), bearing);
        QTRY_VERIFY_WITH_TIMEOUT(
            session.shown()->plan() &&
                std::abs(inDegrees(session.shown()->plan()->swaths.heading) - degreesFromEast) < 1e-6,
            kPatienceMs);
    }
    // Also over a choice that was made before.
    void anOperationBringsItsDefaults() {
        Session session;
        ParameterModel* field = session.planning()->steps()->parameters(QStringLiteral("field"));
        const int row = rowOf(*field, QStringLiteral("operation.kind"));
        QVERIFY(row >= 0);
        const Parameter& when = *findParameter("headland.when").value();
        ParameterModel* headland = session.planning()->steps()->parameters(QStringLiteral("headland"));
        headland->setChoice(rowOf(*headland, QStringLiteral("headland.when")), 1);
        QCOMPARE(session.planning()->settings().choice(when), std::string{"after"});
        field->setChoice(row, 5);  // harvest
        QCOMPARE(session.planning()->settings().choice(when), std::string{"before"});
        field->setChoice(row, 1);  // sowing
        QCOMPARE(session.planning()->settings().choice(when), std::string{"after"});
    }
    void onlyParametersOfTheMethodAreShown() {
        Session session;
        ParameterModel* swaths = session.planning()->steps()->parameters(QStringLiteral("swaths"));
        swaths->setChoice(0, methodIndex("swaths", "brute-force"));
        QVERIFY(rowOf(*swaths, QStringLiteral("swaths.step_deg")) >= 0);
        QCOMPARE(rowOf(*swaths, QStringLiteral("swaths.angle_deg")), -1);
        swaths->setChoice(0, methodIndex("swaths", "fixed"));
        QCOMPARE(rowOf(*swaths, QStringLiteral("swaths.step_deg")), -1);
        QVERIFY(rowOf(*swaths, QStringLiteral("swaths.angle_deg")) >= 0);
    }
    void aDraggedVertexIsFollowed() {
        Session session;
        session.opener()->addDrawn(drawnRectangle());
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        const double before = session.shown()->plan()->field().area().si();
        for (int i = 1; i <= 30; ++i) {
            moveVertex(session, 1, QGeoCoordinate{58.25, 22.507 + i * 1e-4}, false);
            QCoreApplication::processEvents();
        }
        const QGeoCoordinate last{58.25, 22.511};
        moveVertex(session, 1, last, true);
        QTRY_VERIFY_WITH_TIMEOUT(session.shown()->plan()->field().area().si() > before * 1.2, kPatienceMs);
        const std::vector<WorldPoint>& ring = session.shown()->drawing().geometry()->rings.front().points;
        QVERIFY(
            std::ranges::any_of(ring, [&](WorldPoint p) { return coordinate(p).distanceTo(last) < 0.01; }));
    }
    void aDragShowsDraftsAndTheWholePlanWhenItIsLetGo() {
        Session session;
        session.opener()->addDrawn(drawnRectangle());
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        QVERIFY(!session.shown()->isDraft());
        const double heading = session.shown()->plan()->swaths.heading.si();
        const QString covered = figure(session, 7);
        moveVertex(session, 1, QGeoCoordinate{58.25, 22.5085}, false);
        QTRY_VERIFY_WITH_TIMEOUT(session.shown()->isDraft(), kPatienceMs);
        QVERIFY(session.planning()->statusText().startsWith(QStringLiteral("Draft")));
        QCOMPARE(session.shown()->plan()->swaths.heading.si(), heading);
        QCOMPARE(figure(session, 7), QStringLiteral("–"));
        QVERIFY(!session.shown()->drawing().isEmpty());
        moveVertex(session, 1, QGeoCoordinate{58.25, 22.5086}, true);
        QTRY_VERIFY_WITH_TIMEOUT(!session.shown()->isDraft(), kPatienceMs);
        QCOMPARE(session.planning()->state(), PlanState::Ready);
        QVERIFY(session.shown()->plan()->audit.coveredShare.has_value());
        QVERIFY(figure(session, 7) != QStringLiteral("–"));
        // Ended without another change, as when the tool is changed.
        moveVertex(session, 1, QGeoCoordinate{58.25, 22.5090}, false);
        QTRY_VERIFY_WITH_TIMEOUT(session.shown()->isDraft(), kPatienceMs);
        session.document()->endDrag();
        QTRY_VERIFY_WITH_TIMEOUT(!session.shown()->isDraft(), kPatienceMs);
        QCOMPARE(session.planning()->state(), PlanState::Ready);
    }
    // A field whose plan takes longer than its draft anywhere: 150 ha with a machine of 2.5 m.
    void aLargeFieldIsOpenedWithAFirstPlanAndThenTheFinishedOne() {
        Session session;
        struct Shown {
            bool finished;
            PlanState state;
            bool exported;
            QString status;
        };
        std::vector<Shown> all;
        connect(session.shown(), &ShownPlan::planChanged, this, [&] {
            if (session.shown()->hasPlan()) {
                all.push_back({!session.shown()->isDraft(), {}, false, {}});
            }
        });
        connect(session.planning(), &Planning::stateChanged, this, [&] {
            if (!all.empty() && all.back().status.isEmpty()) {
                all.back().state = session.planning()->state();
                all.back().exported = session.exporter()->refusal().isEmpty();
                all.back().status = session.planning()->statusText();
            }
        });
        std::vector<double> shares;
        connect(session.planning(), &Planning::progressChanged, this, [&] {
            if (session.planning()->state() == PlanState::Planning) {
                shares.push_back(session.planning()->progress());
            }
        });
        session.opener()->addDrawn(largeRectangle());
        QTRY_VERIFY_WITH_TIMEOUT(isFinished(session.planning()->state()), kPatienceMs);
        QVERIFY(all.size() >= 2);
        QVERIFY(!session.shown()->isDraft());
        for (std::size_t i = 0; i + 1 < all.size(); ++i) {
            QVERIFY(!all[i].finished);
            // Something to look at: it stays in the window until it is finished.
            QCOMPARE(all[i].state, PlanState::Planning);
            QVERIFY(!all[i].exported);
            QVERIFY2(all[i].status.startsWith(QStringLiteral("First plan")), qPrintable(all[i].status));
        }
        QVERIFY(all.back().finished);
        QVERIFY(session.exporter()->refusal().isEmpty());
        // The bar goes on, and never back. It is told a few times a second: how often depends on the
        // computer.
        QVERIFY(std::ranges::is_sorted(shares));
        shares.erase(std::ranges::unique(shares).begin(), shares.end());
        QVERIFY2(shares.size() > 2, qPrintable(QString::number(shares.size())));
    }
    void whileALongPlanIsMadeAFirstOneIsShown() {
        Session session;
        session.opener()->addDrawn(drawnRectangle());
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        // 9,000 headings take longer than a draft anywhere, also after a plan that was quick.
        ParameterModel* swaths = session.planning()->steps()->parameters(QStringLiteral("swaths"));
        swaths->setChoice(rowOf(*swaths, QStringLiteral("swaths.method")),
                          methodIndex("swaths", "brute-force"));
        swaths->setNumber(rowOf(*swaths, QStringLiteral("swaths.step_deg")), 0.02);
        QTRY_VERIFY_WITH_TIMEOUT(session.shown()->isDraft(), kPatienceMs);
        QCOMPARE(session.planning()->state(), PlanState::Planning);
        QVERIFY(!session.exporter()->refusal().isEmpty());
        QVERIFY(!session.printing()->refusal().isEmpty());
        QVERIFY(!session.review()->refusal().isEmpty());
        QVERIFY(!session.drive()->isAvailable());
        QVERIFY(session.planning()->statusText().startsWith(QStringLiteral("First plan")));
        const auto check = [&session](int role) {
            return session.planning()->steps()->index(7).data(role).toString();
        };
        QCOMPARE(check(StepsModel::ChoiceRole), QStringLiteral("First plan, being improved"));
        QCOMPARE(session.planning()->steps()->index(4).data(StepsModel::StatusRole).toInt(),
                 static_cast<int>(StepsModel::Status::Old));
        // Another change while it is made: the first plan of this one, then the finished one.
        ParameterModel* headland = session.planning()->steps()->parameters(QStringLiteral("headland"));
        headland->setNumber(rowOf(*headland, QStringLiteral("headland.width_m")), 30.0);
        QTRY_COMPARE_WITH_TIMEOUT(session.shown()->plan()->headland.width.si(), 30.0, kPatienceMs);
        QVERIFY(session.shown()->isDraft());
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        QVERIFY(!session.shown()->isDraft());
        QVERIFY(session.exporter()->refusal().isEmpty());
        // Stopped with a first plan on the map: it is none.
        headland->setNumber(rowOf(*headland, QStringLiteral("headland.width_m")), 20.0);
        QTRY_VERIFY_WITH_TIMEOUT(session.shown()->isDraft(), kPatienceMs);
        session.planning()->cancel();
        QCOMPARE(session.planning()->state(), PlanState::OutOfDate);
        QVERIFY(!session.exporter()->refusal().isEmpty());
        // What is undone is planned again, and shown with a first plan before.
        session.document()->undo();
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        QVERIFY(!session.shown()->isDraft());
        QCOMPARE(session.shown()->plan()->headland.width.si(), 30.0);
    }
    void aBoundaryThatCrossesItselfIsToldWithItsPlace() {
        Session session;
        session.opener()->addDrawn({{58.25, 22.5}, {58.2535, 22.507}, {58.25, 22.507}, {58.2535, 22.5}});
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Failed, kPatienceMs);
        QVERIFY(!session.problem()->text().isEmpty());
        QVERIFY(session.problem()->place().isValid());
        QVERIFY(!session.shown()->hasPlan());
        QVERIFY2(!session.shown()->drawing().isEmpty(), "the boundary is still drawn");
        // Put right by dragging a vertex.
        moveVertex(session, 1, {58.25, 22.5075}, false);
        moveVertex(session, 2, {58.2535, 22.507}, true);
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
    }
    void eachPlanHasItsMachine() {
        Session session;
        session.opener()->addDrawn(drawnRectangle());
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        session.farm()->addPlan(QStringLiteral("Harvest"));
        session.planning()->machine()->setLibraryIndex(4);
        QTRY_COMPARE_WITH_TIMEOUT(session.shown()->plan()->request.machine.name(),
                                  session.planning()->machine()->library().at(4).toStdString(), kPatienceMs);
        session.farm()->renamePlan(QStringLiteral("Oats"), QStringLiteral("2027"));
        QCOMPARE(session.farm()->plans().at(1), QStringLiteral("Oats · 2027"));
        session.farm()->setCurrentPlan(0);
        QCOMPARE(session.planning()->machine()->libraryIndex(), 0);
        QTRY_COMPARE_WITH_TIMEOUT(session.shown()->plan()->request.machine.name(),
                                  session.planning()->machine()->library().at(0).toStdString(), kPatienceMs);
        session.farm()->removePlan();
        QCOMPARE(session.farm()->plans().size(), 1);
        QCOMPARE(session.planning()->machine()->libraryIndex(), 4);
    }
    void anotherMachineGivesAnotherPlan() {
        Session session;
        session.opener()->addDrawn(drawnRectangle());
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        const std::size_t swaths = session.shown()->plan()->swaths.swaths.size();
        for (int row = 0; row < session.planning()->machine()->rowCount(); ++row) {
            if (session.planning()
                    ->machine()
                    ->data(session.planning()->machine()->index(row), MachineModel::KeyRole)
                    .toString() == QStringLiteral("operating_width_m")) {
                session.planning()->machine()->setNumber(row, 6.0);
            }
        }
        QVERIFY(session.planning()->machine()->isChanged());
        QTRY_VERIFY_WITH_TIMEOUT(session.shown()->plan()->swaths.swaths.size() < swaths, kPatienceMs);
        session.planning()->machine()->reset();
        QVERIFY(!session.planning()->machine()->isChanged());
        QTRY_COMPARE_WITH_TIMEOUT(session.shown()->plan()->swaths.swaths.size(), swaths, kPatienceMs);
    }
    void whatIsPlannedAlreadyIsNotPlannedAgain() {
        Session session;
        session.opener()->addDrawn(drawnRectangle());
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        const auto before = session.shown()->plan();
        session.planning()->machine()->setLibraryIndex(3);
        QCOMPARE(session.planning()->state(), PlanState::Planning);
        // Undone before the other plan is there.
        session.document()->undo();
        QCOMPARE(session.planning()->state(), PlanState::Ready);
        QCOMPARE(session.shown()->plan(), before);
        QVERIFY(session.exporter()->refusal().isEmpty());
        session.document()->redo();
        QCOMPARE(session.planning()->state(), PlanState::Planning);
        QVERIFY(!session.exporter()->refusal().isEmpty());
        QTRY_VERIFY_WITH_TIMEOUT(isFinished(session.planning()->state()), kPatienceMs);
        QCOMPARE(session.shown()->plan()->request.machine.name(),
                 session.planning()->machine()->machine().name());
    }
    void anotherPlanOfTheFieldIsNotTheOneThatIsShown() {
        Session session;
        session.opener()->addDrawn(drawnRectangle());
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        session.farm()->addPlan(QStringLiteral("Harvest"));
        // A copy asks for the same.
        QCOMPARE(session.planning()->state(), PlanState::Ready);
        QVERIFY(session.exporter()->heading().endsWith(QStringLiteral("Harvest")));
        session.planning()->machine()->setLibraryIndex(4);
        QTRY_VERIFY_WITH_TIMEOUT(isFinished(session.planning()->state()), kPatienceMs);
        session.farm()->setCurrentPlan(0);
        QCOMPARE(session.planning()->state(), PlanState::Planning);
        session.planning()->cancel();
        QCOMPARE(session.planning()->state(), PlanState::OutOfDate);
        QVERIFY(!session.exporter()->refusal().isEmpty());
        QCOMPARE(session.exporter()->heading(), QString{});
    }
    void askedForAgainIsPlanning() {
        Session session;
        session.opener()->addDrawn(drawnRectangle());
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        session.planning()->planAgain();
        QCOMPARE(session.planning()->state(), PlanState::Planning);
        session.planning()->cancel();
        // The plan is still the one of what the panels show.
        QCOMPARE(session.planning()->state(), PlanState::Ready);
    }
    void eachBlockingFindingHasAStep_data() {
        QTest::addColumn<FindingKind>("kind");
        QTest::addColumn<QString>("step");
        QTest::newRow("a gate") << FindingKind::Gate << "field";
        QTest::newRow("missed land") << FindingKind::Missed << "swaths";
        QTest::newRow("a swath is not driven") << FindingKind::DroppedSwath << "swaths";
        QTest::newRow("a headland pass is not driven") << FindingKind::DroppedPass << "headland";
        QTest::newRow("outside") << FindingKind::Outside << "path";
        QTest::newRow("obstacle") << FindingKind::Obstacle << "path";
        QTest::newRow("not drivable") << FindingKind::Undrivable << "path";
    }
    void eachBlockingFindingHasAStep() {
        QFETCH(FindingKind, kind);
        QFETCH(QString, step);
        Session session;
        session.opener()->addDrawn(drawnRectangle());
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        Plan plan = *session.shown()->plan();
        plan.findings = {{.severity = Severity::Blocking,
                          .kind = kind,
                          .place = {},
                          .text = "There is something.",
                          .suggestion = {}},
                         {.severity = Severity::Note,
                          .kind = FindingKind::HeadlandNotWorked,
                          .place = {},
                          .text = "And this.",
                          .suggestion = {}}};
        StepsModel steps;
        steps.show({.field = &plan.field(),
                    .machine = plan.request.machine,
                    .settings = plan.request.settings,
                    .plan = &plan,
                    .state = PlanState::Problems});
        for (int row = 0; row < steps.rowCount(); ++row) {
            const QString id = steps.index(row).data(StepsModel::StepIdRole).toString();
            const bool warned = id == step || id == QStringLiteral("check") || id == QStringLiteral("export");
            QCOMPARE(steps.index(row).data(StepsModel::StatusRole).toInt(),
                     static_cast<int>(warned ? StepsModel::Status::Warning : StepsModel::Status::Good));
            QCOMPARE(steps.index(row)
                         .data(StepsModel::ResultRole)
                         .toString()
                         .contains(QStringLiteral("1 problem")),
                     id == step);
        }
        QCOMPARE(steps.index(7).data(StepsModel::ChoiceRole).toString(), QStringLiteral("1 problem"));
        QCOMPARE(steps.index(7).data(StepsModel::ResultRole).toString(), QStringLiteral("1 note"));
    }
    void cancelKeepsThePlanBefore() {
        Session session;
        session.opener()->addDrawn(drawnRectangle());
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        const auto before = session.shown()->plan();
        ParameterModel* headland = session.planning()->steps()->parameters(QStringLiteral("headland"));
        headland->setNumber(rowOf(*headland, QStringLiteral("headland.width_m")), 30.0);
        session.planning()->cancel();
        QCOMPARE(session.planning()->state(), PlanState::OutOfDate);
        QCOMPARE(session.shown()->plan(), before);
        // It is not of what the panels show: it stays in the window.
        QVERIFY(!session.exporter()->refusal().isEmpty());
        const QTemporaryDir folder;
        session.exporter()->writeTo(folder.filePath(QStringLiteral("out")));
        QCOMPARE(session.exporter()->state(), ExportModel::State::Idle);
        session.planning()->planAgain();
        QTRY_COMPARE_WITH_TIMEOUT(session.shown()->plan()->headland.width.si(), 30.0, kPatienceMs);
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
    }
};

FURROW_TEST(TestPlanSession);
#include "tst_plan_session.moc"
