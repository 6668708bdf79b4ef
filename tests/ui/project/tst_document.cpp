#include "planner/plan/method_registry.h"
#include "planner/project/project_edits.h"
#include "tests/planner/project/project_samples.h"
#include "tests/support/test_program.h"
#include "ui/project/document.h"

#include <QSignalSpy>
#include <QTest>

using namespace furrow;
using namespace furrow::test;

namespace {

Project withWidth(const Project& project, double width) {
    Settings settings = project.plan().settings;
    if (!settings.set(**findParameter("headland.width_m"), width)) {
        qFatal("no such width");
    }
    return withPlan(project, project.plan().machine, settings);
}

double widthOf(const Project& project) {
    return project.plan().settings.length(**findParameter("headland.width_m")).value_or(metres(-1.0)).si();
}

}  // namespace

class TestDocument : public QObject {
    Q_OBJECT

private slots:
    /// After undoing, every kind of change leaves an equal project; after redoing, the changed one.
    void everyChangeIsUndone_data() {
        QTest::addColumn<int>("change");
        const char* names[] = {"another source",   "another plan", "fields added", "field removed",
                               "obstacle removed", "gate removed", "plan copied",  "plan removed",
                               "field renamed",    "plan renamed"};
        for (int i = 0; i < static_cast<int>(std::size(names)); ++i) {
            QTest::newRow(names[i]) << i;
        }
    }
    void everyChangeIsUndone() {
        QFETCH(int, change);
        const Project before = showing(sampleProject(), 0, 1);
        const auto changed = [&]() -> Project {
            FieldSource moved = *before.field()->source;
            moved.parts.front().outer.front().lonDeg += 1e-4;
            switch (change) {
                case 0: return withSource(before, moved);
                case 1: return withWidth(before, 30.0);
                case 2: return withFields(before, {moved, moved});
                case 3: return withoutField(before);
                case 4: return withoutObstacle(before, 0);
                case 5: return withoutGate(before, 0);
                case 6: return withPlanCopy(before, "Rolling");
                case 7: return withoutPlan(before);
                case 8: return withFieldName(before, "Low field");
                default: return withPlanName(before, "Oats", "2027");
            }
        }();
        QVERIFY(!(changed == before));
        Document document;
        document.begin({.base = std::make_shared<const Project>(before),
                        .steps = {},
                        .done = 0,
                        .file = {},
                        .savedFingerprint = {},
                        .saved = 0});
        document.change([] { return QStringLiteral("Change"); }, changed);
        QVERIFY(*document.project() == changed);
        QVERIFY(document.isModified());
        QCOMPARE(document.undoText(), QStringLiteral("Change"));
        document.undo();
        QVERIFY(*document.project() == before);
        QVERIFY(!document.isModified());
        QVERIFY(!document.canUndo());
        document.redo();
        QVERIFY(*document.project() == changed);
    }
    void addedFieldsHaveIdsOfTheirOwn() {
        Project project = withFields(sampleProject(), {sampleSource(), sampleSource()});
        project = withPlanCopy(project, "x");
        QSet<QString> ids;
        int all = 0;
        for (const auto& field : project.fields) {
            ids << QString::fromStdString(field->id);
            ++all;
            for (const FieldPlan& plan : field->plans) {
                ids << QString::fromStdString(plan.id);
                ++all;
            }
        }
        QCOMPARE(ids.size(), all);
        QCOMPARE(project.currentField, std::size_t{2});
    }
    /// Its AB line and its split lines lie in the field they were drawn in.
    void aNewFieldTakesMachineAndSettingsButNoPlaces() {
        const Project first =
            withSplits(showing(sampleProject(), 0, 0), {{{22.5, 58.251}, {22.507, 58.251}}});
        QVERIFY(first.plan().settings.isSet(**findParameter("decomposition.split")));
        const Project project = withFields(first, {sampleSource()});
        QCOMPARE(widthOf(project), 24.5);
        QVERIFY(!project.plan().settings.isSet(**findParameter("swaths.line")));
        QVERIFY(!project.plan().settings.isSet(**findParameter("swaths.method")));
        QVERIFY(!project.plan().settings.isSet(**findParameter("decomposition.split")));
    }
    void draggingIsOneChange() {
        Document document;
        for (int i = 1; i <= 20; ++i) {
            document.change([] { return QStringLiteral("Width"); }, withWidth(*document.project(), i),
                            QStringLiteral("w"), Document::Follows::More);
            QVERIFY(document.isDragging());
        }
        document.change([] { return QStringLiteral("Width"); }, withWidth(*document.project(), 21),
                        QStringLiteral("w"));
        QVERIFY(!document.isDragging());
        document.change([] { return QStringLiteral("Width"); }, withWidth(*document.project(), 40),
                        QStringLiteral("w"));
        QCOMPARE(document.history().steps.size(), std::size_t{2});
        document.undo();
        QCOMPARE(widthOf(*document.project()), 21.0);
        document.undo();
        QCOMPARE(widthOf(*document.project()), -1.0);
        QVERIFY(!document.canUndo());
    }
    void draggingBackIsNoChange() {
        Document document;
        const Project before = *document.project();
        document.change([] { return QStringLiteral("Width"); }, withWidth(before, 5), QStringLiteral("w"),
                        Document::Follows::More);
        document.change([] { return QStringLiteral("Width"); }, before, QStringLiteral("w"));
        QVERIFY(!document.canUndo());
        QVERIFY(!document.isModified());
        document.change([] { return QStringLiteral("Nothing"); }, before);
        QVERIFY(!document.canUndo());
    }
    void anotherChangeEndsADrag() {
        Document document;
        document.change([] { return QStringLiteral("Width"); }, withWidth(*document.project(), 5),
                        QStringLiteral("w"), Document::Follows::More);
        document.change([] { return QStringLiteral("Field"); },
                        withFields(*document.project(), {sampleSource()}));
        document.undo();
        document.change([] { return QStringLiteral("Width"); }, withWidth(*document.project(), 6),
                        QStringLiteral("w"), Document::Follows::More);
        QCOMPARE(document.history().steps.size(), std::size_t{2});
        document.undo();
        QCOMPARE(widthOf(*document.project()), 5.0);
    }
    void lookingIsNoChange() {
        Document document;
        document.begin({.base = std::make_shared<const Project>(sampleProject()),
                        .steps = {},
                        .done = 0,
                        .file = {},
                        .savedFingerprint = {},
                        .saved = 0});
        QSignalSpy changed{&document, &Document::projectChanged};
        document.look(showing(*document.project(), 0, 1));
        QCOMPARE(changed.count(), 1);
        QVERIFY(!document.isModified());
        QVERIFY(!document.canUndo());
    }
    void aHistoryGoesOn() {
        Document first;
        for (int i = 1; i <= 5; ++i) {
            first.change([i] { return QStringLiteral("Step %1").arg(i); }, withWidth(*first.project(), i));
            if (i == 3) {
                first.markSaved();
            }
        }
        first.undo();
        Document second;
        QSignalSpy changed{&second, &Document::projectChanged};
        second.begin(first.history());
        QCOMPARE(changed.count(), 1);
        QCOMPARE(widthOf(*second.project()), 4.0);
        QCOMPARE(second.redoText(), QStringLiteral("Step 5"));
        QVERIFY(second.isModified());
        second.undo();
        QVERIFY(!second.isModified());
        second.redo();
        second.redo();
        QCOMPARE(widthOf(*second.project()), 5.0);
        QVERIFY(second.revert());
        QCOMPARE(widthOf(*second.project()), 3.0);
    }
};

FURROW_TEST(TestDocument);
#include "tst_document.moc"
