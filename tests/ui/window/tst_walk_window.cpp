#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/editor_window_test.h"
#include "ui/text/display.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

using namespace furrow;
using namespace furrow::test;

/// What a new user does, from nothing to files for the terminal. With FURROW_PICTURES set it is done in every
/// size, theme and some languages, for people to look at the pictures.
class TestWalkWindow : public EditorWindowTest {
    Q_OBJECT

    enum class Colours { Light = 1, Dark, Sunlight };

    QString name_;
    int number_ = 0;
    QDir folder_;
    bool isNarrow_ = false;
    QPoint centre_;  ///< of the field that is drawn

    void step(const char* what) {
        picture(QStringLiteral("walk-%1-%2-%3")
                    .arg(name_)
                    .arg(++number_, 2, 10, QLatin1Char{'0'})
                    .arg(QLatin1String{what}));
    }
    void beginAs(QSize size, int colours) {
        begin(size);
        engine_->singletonInstance<QObject*>("Furrow.Controls", "Theme")->setProperty("forced", colours);
    }
    void openStep(const QString& name) {
        item(QStringLiteral("stepsPanel"))->setProperty("openStep", name);
        if (!name.isEmpty()) {
            waitForRest(*item(QStringLiteral("step.") + name));
        }
    }

    /// Steps of a walk, up to the first in which something fails.
    void go(std::initializer_list<void (TestWalkWindow::*)()> parts) {
        for (const auto part : parts) {
            (this->*part)();
            if (QTest::currentTestFailed()) {
                return;
            }
        }
    }
    QString farmFile() const { return folder_.filePath(QStringLiteral("Home farm.furrow")); }
    /// Beside both panels there is less room than the field takes.
    void closePanel() {
        if (isNarrow_) {
            click(QStringLiteral("panelSwitch"));
        }
    }

    void machineAndHeadland() {
        openStep(QStringLiteral("machine"));
        click(QStringLiteral("machine.library"));
        key(Qt::Key_Down);
        key(Qt::Key_Down);
        QTRY_COMPARE(item(QStringLiteral("machine.library"))
                         ->property("popup")
                         .value<QObject*>()
                         ->property("opacity")
                         .toDouble(),
                     1.0);
        step("machines");
        key(Qt::Key_Return);
        QTRY_COMPARE(session_->planning()->machine()->libraryIndex(), 2);
        ready();
        step("machine");
        openStep(QStringLiteral("headland"));
        enter(QStringLiteral("headland.width_m"), QStringLiteral("20m"));
        QTRY_COMPARE(steps(), std::size_t{3});
        ready();
        step("headland");
    }
    void edgeWithItsOwnHeadland() {
        const QPoint along = cornerOnMap(1) - cornerOnMap(0);
        clickAt(cornerOnMap(0) + along / 4);
        QTRY_COMPARE(editor()->selection().kind, Selection::Kind::Edge);
        if (isNarrow_) {
            // There is no room for it until it is asked for.
            key(Qt::Key_Return);
        }
        QTRY_VERIFY(shows(QStringLiteral("inspector")));
        enter(QStringLiteral("inspector.number.2"), QStringLiteral("30m"));
        QTRY_COMPARE(source().edgeHeadlands.size(), std::size_t{1});
        QCOMPARE(source().edgeHeadlands.front().width.si(), 30.0);
        QCOMPARE(steps(), std::size_t{4});
        ready();
        step("edge-headland");
        closePanel();
    }
    void obstacle() {
        click(QStringLiteral("obstacleTool"));
        for (const QPoint corner : {QPoint{-60, -40}, QPoint{10, -50}, QPoint{20, 30}, QPoint{-50, 40}}) {
            clickAt(centre_ + corner);
        }
        QTest::mouseMove(window_, centre_ + QPoint{-120, 10});
        step("obstacle-drawing");
        key(Qt::Key_Return);
        QTRY_COMPARE(source().obstacles.size(), std::size_t{1});
        if (isNarrow_) {
            key(Qt::Key_Return);
        }
        QTRY_VERIFY(shows(QStringLiteral("inspector")));
        ready();
        enter(QStringLiteral("inspector.number.1"), QStringLiteral("4m"));
        QTRY_COMPARE(source().obstacles.front().buffer.si(), 4.0);
        click(QStringLiteral("inspector.passable"));
        QTRY_VERIFY(source().obstacles.front().passable);
        click(QStringLiteral("inspector.passable"));
        QTRY_VERIFY(!source().obstacles.front().passable);
        ready();
        step("obstacle");
        closePanel();
    }
    void gateLineAndSplit() {
        click(QStringLiteral("gateTool"));
        clickAt(centre_ + QPoint{0, 148});
        QTRY_COMPARE(source().gates.size(), std::size_t{1});
        ready();
        step("gate");

        click(QStringLiteral("guideTool"));
        clickAt(centre_ + QPoint{-150, 100});
        clickAt(centre_ + QPoint{-150, -100});
        key(Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(
            session_->shown()->plan() &&
                std::abs(std::cos(session_->shown()->plan()->swaths.heading.si())) < 0.01,
            kPatienceMs);
        ready();
        step("ab-line");

        click(QStringLiteral("splitTool"));
        clickAt(centre_ + QPoint{90, -170});
        clickAt(centre_ + QPoint{110, 170});
        key(Qt::Key_Return);
        QTRY_COMPARE(steps(), std::size_t{11});
        ready();
        step("split");
    }
    void changesUndoneAndRedone() {
        drag(cornerOnMap(1), cornerOnMap(1) + QPoint{40, -30});
        const QPoint quarter = cornerOnMap(3) + (cornerOnMap(0) - cornerOnMap(3)) / 4;
        drag(quarter, quarter + QPoint{-20, 0});
        QCOMPARE(steps(), std::size_t{13});
        ready();
        step("changed");

        for (int i = 0; i < 10; ++i) {
            key(Qt::Key_Z, Qt::ControlModifier);
        }
        QVERIFY(source().obstacles.empty() && source().gates.empty() && source().edgeHeadlands.empty());
        QCOMPARE(session_->planning()->machine()->libraryIndex(), 2);
        ready();
        step("ten-undone");
        for (int i = 0; i < 5; ++i) {
            key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        }
        QCOMPARE(source().obstacles.size(), std::size_t{1});
        QCOMPARE(source().obstacles.front().buffer.si(), 4.0);
        QCOMPARE(source().edgeHeadlands.size(), std::size_t{1});
        QVERIFY(source().gates.empty());
        ready();
        step("five-redone");
    }
    void saved() {
        session_->files()->saveAs(QUrl::fromLocalFile(farmFile()));
        QTRY_VERIFY(!session_->document()->isModified());
        QTRY_COMPARE(item(QStringLiteral("projectName"))->property("text").toString(),
                     QStringLiteral("Home farm"));
        QVERIFY(!shows(QStringLiteral("modifiedMark")));
        step("saved");
    }
    /// After one more change; the next start has it.
    void killedAndRestored() {
        QFETCH(QSize, size);
        QFETCH(int, colours);
        drag(cornerOnMap(2), cornerOnMap(2) + QPoint{30, 20});
        const auto last = session_->document()->project();
        end();
        beginAs(size, colours);
        session_->keepIn(folder_.filePath(QStringLiteral("kept")));
        QVERIFY(session_->files()->recover());
        QVERIFY(*session_->document()->project() == *last);
        QTRY_VERIFY(shows(QStringLiteral("filesNotice")));
        ready();
        step("restored");
        click(QStringLiteral("filesNotice.keep"));
        QTRY_VERIFY(!shows(QStringLiteral("filesNotice")));
        key(Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY(!session_->document()->isModified());
        session_->opener()->startNew();
        step("recent");
        session_->opener()->open(farmFile());
        QTRY_VERIFY(session_->farm()->hasField());
        QVERIFY(*session_->document()->project() == *last);
        ready();
        step("reopened");
    }
    void exported() {
        key(Qt::Key_E, Qt::ControlModifier);
        click(QStringLiteral("export.inFolder"));
        QTRY_VERIFY(shows(QStringLiteral("export.folder")));
        item(QStringLiteral("export.folder"))->setProperty("text", folder_.filePath(QStringLiteral("out")));
        click(QStringLiteral("export.write"));
        QTRY_COMPARE(session_->exporter()->state(), ExportModel::State::Done);
        QVERIFY(QFile::exists(folder_.filePath(QStringLiteral("out/plan.geojson"))));
        QCOMPARE(session_->exporter()->problems().join(QLatin1Char{'\n'}), QString{});
        step("exported");
        key(Qt::Key_Escape);
    }

    void drawByKeys(Qt::Key tool, const std::vector<std::pair<const char*, const char*>>& ways) {
        map()->forceActiveFocus();
        key(tool);
        QTRY_VERIFY(shows(QStringLiteral("drawingHint")));
        editor()->leave();
        key(Qt::Key_Space);
        QTRY_COMPARE(editor()->sketchCount(), 1);
        for (const auto& [length, bearing] : ways) {
            enterWay(QString::fromLatin1(length), QString::fromLatin1(bearing));
        }
        map()->forceActiveFocus();
        key(Qt::Key_Return);
    }
    void fieldAndMachineByKeys() {
        drawByKeys(Qt::Key_B, {{"400", "90"}, {"300", "180"}, {"400", "270"}});
        if (QTest::currentTestFailed()) {
            return;
        }
        QTRY_VERIFY(session_->farm()->hasField());
        ready();

        openStep(QStringLiteral("machine"));
        item(QStringLiteral("machine.library"))->forceActiveFocus(Qt::TabFocusReason);
        key(Qt::Key_Space);
        key(Qt::Key_Down);
        key(Qt::Key_Down);
        key(Qt::Key_Return);
        QTRY_COMPARE(session_->planning()->machine()->libraryIndex(), 2);
        ready();
    }
    void edgeByKeys() {
        // The first edge, the one after it, and back.
        map()->forceActiveFocus();
        key(Qt::Key_E);
        QTRY_COMPARE(editor()->selection().kind, Selection::Kind::Edge);
        QCOMPARE(editor()->selection().index, std::size_t{0});
        key(Qt::Key_E);
        QCOMPARE(editor()->selection().index, std::size_t{1});
        key(Qt::Key_Comma);
        QCOMPARE(editor()->selection().kind, Selection::Kind::Edge);
        QCOMPARE(editor()->selection().index, std::size_t{0});
        key(Qt::Key_Return);
        QTRY_VERIFY(item(QStringLiteral("inspector.number.0"))->hasActiveFocus());
        item(QStringLiteral("inspector.number.2"))->forceActiveFocus(Qt::TabFocusReason);
        key(Qt::Key_A, Qt::ControlModifier);
        type(QStringLiteral("30m"));
        key(Qt::Key_Return);
        QTRY_COMPARE(source().edgeHeadlands.size(), std::size_t{1});
        QCOMPARE(source().edgeHeadlands.front().width.si(), 30.0);
        ready();
    }
    void obstacleAndGateByKeys() {
        // The view lies where the field begins, its upper left corner: the obstacle goes to the lower right
        // of that.
        map()->forceActiveFocus();
        key(Qt::Key_Escape);
        QTRY_VERIFY(!editor()->hasSelection());
        const QGeoCoordinate begun = camera()->center();
        for (const Qt::Key way : {Qt::Key_Right, Qt::Key_Right, Qt::Key_Down, Qt::Key_Down}) {
            key(way);
        }
        QTRY_VERIFY(camera()->center().longitude() > begun.longitude() &&
                    camera()->center().latitude() < begun.latitude());
        drawByKeys(Qt::Key_O, {{"30", "90"}, {"30", "180"}, {"30", "270"}});
        if (QTest::currentTestFailed()) {
            return;
        }
        QTRY_COMPARE(source().obstacles.size(), std::size_t{1});
        ready();
        key(Qt::Key_Escape);
        key(Qt::Key_G);
        QTRY_COMPARE(editor()->tool(), FieldEditor::Tool::Gate);
        editor()->leave();
        key(Qt::Key_Space);
        QTRY_COMPARE(source().gates.size(), std::size_t{1});
        ready();
        step("by-keys");
    }
    void undoneAndRedoneByKeys() {
        const std::size_t all = steps();
        const auto before = session_->document()->project();
        for (std::size_t i = 0; i < all; ++i) {
            key(Qt::Key_Z, Qt::ControlModifier);
        }
        QTRY_VERIFY(!session_->farm()->hasField());
        for (std::size_t i = 0; i < all; ++i) {
            key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        }
        QTRY_VERIFY(*session_->document()->project() == *before);
        ready();
    }
    void exportedByKeys() {
        session_->files()->saveAs(QUrl::fromLocalFile(farmFile()));
        QTRY_VERIFY(!session_->document()->isModified());
        key(Qt::Key_E, Qt::ControlModifier);
        QTRY_VERIFY(shows(QStringLiteral("export.inFolder")));
        item(QStringLiteral("export.inFolder"))->forceActiveFocus(Qt::TabFocusReason);
        key(Qt::Key_Space);
        QTRY_VERIFY(shows(QStringLiteral("export.folder")));
        item(QStringLiteral("export.folder"))->forceActiveFocus(Qt::TabFocusReason);
        key(Qt::Key_A, Qt::ControlModifier);
        type(folder_.filePath(QStringLiteral("out")));
        item(QStringLiteral("export.write"))->forceActiveFocus(Qt::TabFocusReason);
        key(Qt::Key_Space);
        QTRY_COMPARE(session_->exporter()->state(), ExportModel::State::Done);
        QVERIFY(QFile::exists(folder_.filePath(QStringLiteral("out/plan.geojson"))));
        QCOMPARE(session_->exporter()->problems().join(QLatin1Char{'\n'}), QString{});
        key(Qt::Key_Escape);
    }

private slots:
    void theWalk_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<int>("colours");
        QTest::addColumn<QString>("language");
        QTest::addColumn<int>("units");
        const auto row = [](const char* name, QSize size, Colours colours, const char* language = "en",
                            furrow::Display::Units units = furrow::Display::Metric) {
            QTest::newRow(name) << size << static_cast<int>(colours) << QString::fromLatin1(language)
                                << static_cast<int>(units);
        };
        row("1440-light", {1440, 900}, Colours::Light);
        if (!qEnvironmentVariableIsSet("FURROW_PICTURES")) {
            return;
        }
        row("1440-dark", {1440, 900}, Colours::Dark);
        row("1440-sunlight", {1440, 900}, Colours::Sunlight);
        row("1000-light", {1000, 700}, Colours::Light);
        row("1000-dark", {1000, 700}, Colours::Dark);
        row("1000-sunlight", {1000, 700}, Colours::Sunlight);
        row("1920-light", {1920, 1200}, Colours::Light);
        row("1920-dark", {1920, 1200}, Colours::Dark);
        row("1920-sunlight", {1920, 1200}, Colours::Sunlight);
        row("1000-de", {1000, 700}, Colours::Light, "de");
        row("1000-fr", {1000, 700}, Colours::Dark, "fr");
        row("1440-imperial", {1440, 900}, Colours::Light, "en", furrow::Display::Imperial);
    }
    void theWalk() {
        QFETCH(QSize, size);
        QFETCH(int, colours);
        QFETCH(QString, language);
        QFETCH(int, units);
        name_ = QString::fromUtf8(QTest::currentDataTag());
        number_ = 0;
        furrow::Display::instance().force(language, static_cast<furrow::Display::Units>(units));
        end();
        const QTemporaryDir folder;
        folder_ = QDir{folder.path()};
        isNarrow_ = size.width() < 1200;
        beginAs(size, colours);
        session_->keepIn(folder.filePath(QStringLiteral("kept")));
        step("empty");

        DRAW_FIELD();
        step("drawn");
        centre_ = middle();
        go({&TestWalkWindow::machineAndHeadland, &TestWalkWindow::edgeWithItsOwnHeadland,
            &TestWalkWindow::obstacle, &TestWalkWindow::gateLineAndSplit,
            &TestWalkWindow::changesUndoneAndRedone, &TestWalkWindow::saved,
            &TestWalkWindow::killedAndRestored, &TestWalkWindow::exported});
        if (QTest::currentTestFailed()) {
            return;
        }
        furrow::Display::instance().force(QStringLiteral("en"), furrow::Display::Metric);
    }
    /// The same without a mouse. That Tab reaches every control is tested with these.
    void byKeysAlone() {
        name_ = QStringLiteral("keys");
        number_ = 0;
        const QTemporaryDir folder;
        folder_ = QDir{folder.path()};
        session_->keepIn(folder.filePath(QStringLiteral("kept")));
        camera()->centreOn(QGeoCoordinate{58.2515, 22.5035}, 16.0, false);
        go({&TestWalkWindow::fieldAndMachineByKeys, &TestWalkWindow::edgeByKeys,
            &TestWalkWindow::obstacleAndGateByKeys, &TestWalkWindow::undoneAndRedoneByKeys,
            &TestWalkWindow::exportedByKeys});
    }
};

FURROW_TEST_WITH(TestWalkWindow, QGuiApplication);
#include "tst_walk_window.moc"
