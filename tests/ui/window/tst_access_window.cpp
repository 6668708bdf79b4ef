#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/window_test.h"

#include <QAccessible>
#include <QFile>
#include <QSet>
#include <QTemporaryDir>

using namespace furrow;
using namespace furrow::test;

/// The window for those who use no mouse, read no screen, or work with a finger in a glove.
class TestAccessWindow : public WindowTest {
    Q_OBJECT

    static bool isControl(const QQuickItem& item) {
        return item.inherits("QQuickAbstractButton") || item.inherits("QQuickTextInput") ||
               item.inherits("QQuickTextEdit") || item.inherits("QQuickSlider") ||
               item.inherits("QQuickComboBox");
    }
    /// Every control that is seen below an item.
    static void collect(QQuickItem* below, std::vector<QQuickItem*>& controls) {
        if (!below->isVisible()) {
            return;
        }
        if (isControl(*below) && below->isEnabled() && below->width() > 0.0) {
            controls.push_back(below);
        }
        // A combo box shows itself; what it is made of is no control of its own.
        if (!below->inherits("QQuickComboBox")) {
            for (QQuickItem* child : below->childItems()) {
                collect(child, controls);
            }
        }
    }
    static QString described(const QQuickItem& item) {
        return QStringLiteral("%1 \"%2\" %3x%4")
            .arg(QLatin1String{item.metaObject()->className()}, item.objectName())
            .arg(item.width())
            .arg(item.height());
    }
    void check(const char* page) {
        std::vector<QQuickItem*> controls;
        collect(window_->contentItem(), controls);
        QVERIFY(!controls.empty());
        QStringList unnamed;
        QStringList small;
        for (QQuickItem* control : controls) {
            QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(control);
            if (accessible == nullptr || accessible->text(QAccessible::Name).isEmpty()) {
                unnamed << described(*control);
            }
            // 9 mm at 96 pixels an inch.
            const auto* mask = qobject_cast<QQuickItem*>(control->containmentMask());
            if ((mask != nullptr ? mask->height() : control->height()) < 34.0) {
                small << described(*control);
            }
        }
        QVERIFY2(unnamed.isEmpty(),
                 qPrintable(QStringLiteral("%1, without a name: %2")
                                .arg(QLatin1String{page}, unnamed.join(QStringLiteral("; ")))));
        QVERIFY2(small.isEmpty(),
                 qPrintable(QStringLiteral("%1, too small: %2")
                                .arg(QLatin1String{page}, small.join(QStringLiteral("; ")))));
    }

private slots:
    void everyControlHasANameAndRoomForAFinger() {
        check("empty");
        openSample(QStringLiteral("Home Field"));
        check("plan");
        for (int row = 0; row < session_->planning()->steps()->rowCount(); ++row) {
            const QString step = session_->planning()
                                     ->steps()
                                     ->data(session_->planning()->steps()->index(row), StepsModel::StepIdRole)
                                     .toString();
            item(QStringLiteral("stepsPanel"))->setProperty("openStep", step);
            waitForRest(*item(QStringLiteral("step.") + step));
            check(qPrintable(step));
        }
        click(QStringLiteral("layersTool"));
        check("layers");
        key(Qt::Key_L, Qt::ControlModifier);
        key(Qt::Key_K, Qt::ControlModifier);
        check("palette");
        key(Qt::Key_Escape);
        key(Qt::Key_F1, Qt::ControlModifier);
        check("keys");
        key(Qt::Key_Escape);
        click(QStringLiteral("exportButton"));
        QTRY_VERIFY(item(QStringLiteral("export.write")) != nullptr &&
                    item(QStringLiteral("export.write"))->isVisible());
        check("export");
        key(Qt::Key_Escape);
    }
    void theTabKeyReachesEverythingAndComesBack() {
        openSample(QStringLiteral("Home Field"));
        key(Qt::Key_Tab);
        QSet<QString> reached;
        QQuickItem* first = window_->activeFocusItem();
        int steps = 0;
        do {
            reached << window_->activeFocusItem()->objectName();
            QVERIFY2(window_->activeFocusItem()->isVisible(),
                     qPrintable(described(*window_->activeFocusItem())));
            key(Qt::Key_Tab);
            ++steps;
        } while (window_->activeFocusItem() != first && steps < 200);
        QVERIFY2(steps < 200, "the tab key runs in no circle");
        for (const char* name : {"openButton", "exportButton", "searchButton", "themeSwitch", "drawTool",
                                 "layersTool", "step.headland", "editLayer", "finding.0"}) {
            QVERIFY2(reached.contains(QLatin1String{name}),
                     qPrintable(QStringLiteral("%1 is not among %2")
                                    .arg(QLatin1String{name}, QStringList{reached.values()}.join(u' '))));
        }
    }
    // Neither the fields of a file to choose from, nor what is said of the outline.
    void theTourCoversNothing() {
        window_->resize(1366, 768);
        click(QStringLiteral("searchButton"));
        type(QStringLiteral("tour"));
        key(Qt::Key_Return);
        QTRY_VERIFY(item(QStringLiteral("tour"))->isVisible());
        session_->opener()->openUrls(
            {QUrl::fromLocalFile(QStringLiteral(FURROW_SOURCE_DIR "/tests/data/stepped/farm.geojson"))});
        QTRY_COMPARE(session_->planning()->state(), PlanState::Choosing);
        QTRY_VERIFY(!item(QStringLiteral("tour"))->isVisible());
        session_->opener()->chooseAll();
        const auto placeOf = [this](const char* name) {
            const QQuickItem& of = *item(QLatin1String{name});
            return QRectF{of.mapToScene({}), of.size()};
        };
        for (const QSize size : {QSize{1366, 768}, {1000, 700}}) {
            window_->resize(size);
            QTRY_COMPARE(window_->size(), size);
            QTRY_VERIFY(item(QStringLiteral("tour"))->isVisible() &&
                        item(QStringLiteral("outlineSteps"))->isVisible());
            waitForRest(*item(QStringLiteral("outlineSteps")));
            picture(QStringLiteral("steps-tour-%1").arg(size.width()));
            QVERIFY(!placeOf("outlineSteps").intersects(placeOf("tour.card")));
            QVERIFY(placeOf("mapPage").contains(placeOf("outlineSteps")));
            QVERIFY(placeOf("outlineSteps").contains(placeOf("outlineSteps.close")));
        }
    }
    /// The bar of what is drawn has all buttons in view, also beside the tour.
    void theTourLeavesTheDrawingBarFree() {
        click(QStringLiteral("searchButton"));
        type(QStringLiteral("tour"));
        key(Qt::Key_Return);
        QTRY_VERIFY(item(QStringLiteral("tour"))->isVisible());
        const auto placeOf = [this](const char* name) {
            const QQuickItem& of = *item(QLatin1String{name});
            return QRectF{of.mapToScene({}), of.size()};
        };
        map()->forceActiveFocus();
        key(Qt::Key_B);
        QTRY_VERIFY(item(QStringLiteral("drawingHint"))->isVisible());
        for (const QSize size : {QSize{1440, 900}, {1366, 768}, {1000, 700}}) {
            window_->resize(size);
            QTRY_COMPARE(window_->size(), size);
            for (const int points : {0, 1}) {
                while (editor()->sketchCount() < points) {
                    clickAt(map()->mapToScene({100.0, 400.0}).toPoint());
                }
                waitForRest(*item(QStringLiteral("drawingHint")));
                waitForRest(*item(QStringLiteral("tour.card")));
                picture(QStringLiteral("tour-drawing-%1-%2").arg(size.width()).arg(points));
                QVERIFY(item(QStringLiteral("tour.card"))->isVisible());
                QVERIFY(!placeOf("drawingHint").intersects(placeOf("tour.card")));
                QVERIFY(placeOf("mapPage").contains(placeOf("drawingHint")));
                QVERIFY(placeOf("mapPage").contains(placeOf("tour.card")));
            }
            editor()->removeLastPoint();
        }
    }
    /// What to do without a field and what happened stand beside or above each other.
    void theFirstCardLeavesTheNoticesFree() {
        const QTemporaryDir folder;
        QFile file{folder.filePath(QStringLiteral("broken.mbtiles"))};
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("no tiles") > 0);
        file.close();
        session_->imagery()->add({file.fileName()});
        QTRY_VERIFY(item(QStringLiteral("imageryNotice"))->isVisible());
        const auto placeOf = [this](const char* name) {
            const QQuickItem& of = *item(QLatin1String{name});
            return QRectF{of.mapToScene({}), of.size()};
        };
        for (const QSize size : {QSize{1440, 900}, {1280, 800}, {1200, 700}, {1000, 700}, {900, 600}}) {
            window_->resize(size);
            QTRY_COMPARE(window_->size(), size);
            waitForRest(*item(QStringLiteral("emptyState")));
            picture(QStringLiteral("empty-notice-%1").arg(size.width()));
            QVERIFY(item(QStringLiteral("emptyState"))->isVisible());
            QVERIFY(!placeOf("emptyState").intersects(placeOf("imageryNotice")));
            QVERIFY(placeOf("mapPage").contains(placeOf("emptyState")));
            QVERIFY(placeOf("mapPage").contains(placeOf("imageryNotice")));
        }
    }
    void escapeClosesTheLayers() {
        openSample(QStringLiteral("Home Field"));
        for (const char* place : {"editLayer", "step.headland", "layersTool"}) {
            item(QLatin1String{place})->forceActiveFocus(Qt::TabFocusReason);
            key(Qt::Key_L, Qt::ControlModifier);
            QTRY_VERIFY(item(QStringLiteral("layersPanel"))->isVisible());
            key(Qt::Key_Escape);
            QTRY_VERIFY2(!item(QStringLiteral("layersPanel"))->isVisible(), place);
        }
        // One after the other: the guide first.
        key(Qt::Key_L, Qt::ControlModifier);
        key(Qt::Key_F1);
        QTRY_VERIFY(item(QStringLiteral("guidePanel"))->isVisible());
        key(Qt::Key_Escape);
        QTRY_VERIFY(!item(QStringLiteral("guidePanel"))->isVisible());
        QVERIFY(item(QStringLiteral("layersPanel"))->isVisible());
        key(Qt::Key_Escape);
        QTRY_VERIFY(!item(QStringLiteral("layersPanel"))->isVisible());
    }
    void theTourIsTakenAndLeft() {
        click(QStringLiteral("searchButton"));
        type(QStringLiteral("tour"));
        key(Qt::Key_Return);
        QTRY_VERIFY(item(QStringLiteral("tour"))->isVisible());
        check("tour");
        picture(QStringLiteral("tour-begun"));
        // Both stand beside each other, or the tour alone.
        const auto placeOf = [this](const char* name) {
            const QQuickItem& of = *item(QLatin1String{name});
            return QRectF{of.mapToScene({}), of.size()};
        };
        const QSize before = window_->size();
        for (const auto& [size, hasRoom] :
             {std::pair{QSize{1366, 768}, true}, {QSize{1000, 700}, false}, {before, true}}) {
            window_->resize(size);
            QTRY_COMPARE(window_->size(), size);
            QTRY_COMPARE(item(QStringLiteral("emptyState"))->isVisible(), hasRoom);
            waitForRest(*item(QStringLiteral("emptyState")));
            picture(QStringLiteral("tour-%1").arg(size.width()));
            QVERIFY(!hasRoom || !placeOf("emptyState").intersects(placeOf("tour.card")));
        }
        const auto isDone = [this](int task) {
            return item(QStringLiteral("tour.task.%1").arg(task))->property("isDone").toBool();
        };
        QVERIFY(!isDone(0));
        // A sample for who has no field.
        click(QStringLiteral("tour.task.0"));
        QTRY_COMPARE_WITH_TIMEOUT(session_->planning()->state(), PlanState::Ready, kPatienceMs);
        QCOMPARE(session_->farm()->fieldName(), QStringLiteral("Home Field"));
        QTRY_VERIFY(isDone(0) && !isDone(1));
        // Beside a field the next thing only: the whole list would cover it.
        const QSize large{1440, 900};
        window_->resize(large);
        QTRY_VERIFY(item(QStringLiteral("tour"))->width() > 1100.0);
        waitForRest(*item(QStringLiteral("tour.card")));
        QTRY_VERIFY(placeOf("tour.card").height() < 150.0);
        picture(QStringLiteral("tour-field"));
        window_->resize(before);
        QTRY_COMPARE(window_->size(), before);
        // The machine's step opens; another machine ticks it off.
        click(QStringLiteral("tour.task.1"));
        QTRY_VERIFY(item(QStringLiteral("machine.library")) != nullptr &&
                    item(QStringLiteral("machine.library"))->isVisible());
        picture(QStringLiteral("tour-machine"));
        session_->planning()->machine()->setLibraryIndex(5);
        QTRY_VERIFY(isDone(1) && !isDone(2));
        QTRY_VERIFY_WITH_TIMEOUT(isFinished(session_->planning()->state()), kPatienceMs);
        // A corner is dragged.
        const GeoPoint corner = session_->document()->project()->field()->source->parts.front().outer.front();
        const QPoint at = onMap(QGeoCoordinate{corner.latDeg, corner.lonDeg});
        drag(at, at + QPoint{14, 12});
        QTRY_VERIFY(isDone(2) && !isDone(3));
        QTRY_VERIFY_WITH_TIMEOUT(isFinished(session_->planning()->state()), kPatienceMs);
        // A field that is not there any more is no field.
        const int changes = static_cast<int>(session_->document()->history().steps.size());
        for (int i = 0; i < changes; ++i) {
            key(Qt::Key_Z, Qt::ControlModifier);
        }
        QTRY_VERIFY(!session_->farm()->hasField() && !isDone(0));
        for (int i = 0; i < changes; ++i) {
            session_->document()->redo();
        }
        QTRY_VERIFY(isDone(0));
        QTRY_VERIFY_WITH_TIMEOUT(isFinished(session_->planning()->state()), kPatienceMs);
        // Looked at, nothing is written.
        click(QStringLiteral("tour.task.3"));
        QTRY_VERIFY(item(QStringLiteral("export.close")) != nullptr &&
                    item(QStringLiteral("export.close"))->isVisible());
        key(Qt::Key_Escape);
        QTRY_VERIFY(item(QStringLiteral("export.close")) == nullptr ||
                    !item(QStringLiteral("export.close"))->isVisible());
        QVERIFY(!isDone(3));
        const QTemporaryDir folder;
        click(QStringLiteral("tour.task.3"));
        QTRY_VERIFY(item(QStringLiteral("export.close")) != nullptr &&
                    item(QStringLiteral("export.close"))->isVisible());
        click(QStringLiteral("export.inFolder"));
        session_->exporter()->writeTo(folder.path());
        QTRY_VERIFY_WITH_TIMEOUT(isDone(3), kPatienceMs);
        key(Qt::Key_Escape);
        QTRY_COMPARE(item(QStringLiteral("tour.title"))->property("text").toString(),
                     QStringLiteral("That is all"));
        picture(QStringLiteral("tour-done"));
        click(QStringLiteral("tour.leave"));
        QTRY_VERIFY(!item(QStringLiteral("tour"))->isVisible());
    }
    void picturesOfEveryTheme_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("mode");
        QTest::addColumn<QSize>("size");
        for (const QSize size : {QSize{1440, 900}, QSize{1000, 700}}) {
            for (const auto& [name, mode] : {std::pair{"light", 1}, {"dark", 2}, {"sunlight", 3}}) {
                const QString row = QStringLiteral("%1-%2").arg(QLatin1String{name}).arg(size.width());
                QTest::newRow(qPrintable(row)) << row << mode << size;
            }
        }
    }
    /// For people to look at.
    void picturesOfEveryTheme() {
        QFETCH(QString, name);
        QFETCH(int, mode);
        QFETCH(QSize, size);
        engine_->singletonInstance<QObject*>("Furrow.Controls", "Theme")->setProperty("forced", mode);
        window_->resize(size);
        openSample(QStringLiteral("Three Ponds"));
        picture(QStringLiteral("plan-") + name);
        click(QStringLiteral("layersTool"));
        item(QStringLiteral("layerSwitches"))->setProperty("coverage", true);
        item(QStringLiteral("layerSwitches"))->setProperty("overlap", true);
        item(QStringLiteral("layerSwitches"))->setProperty("wheels", true);
        QTRY_VERIFY(item(QStringLiteral("layersPanel"))->isVisible());
        picture(QStringLiteral("layers-") + name);
        click(QStringLiteral("layersPanel.close"));
        item(QStringLiteral("stepsPanel"))->setProperty("openStep", QStringLiteral("swaths"));
        waitForRest(*item(QStringLiteral("step.swaths")));
        picture(QStringLiteral("swaths-") + name);
    }
};

FURROW_TEST_WITH(TestAccessWindow, QGuiApplication);
#include "tst_access_window.moc"
