#include "planner/io/delivery/terminals.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/window_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QUrl>

#include <memory>

using namespace furrow;

/// The export dialog in the whole window, with real mouse and keys.
class TestExportWindow : public test::WindowTest {
    Q_OBJECT

private:
    bool shown(const char* name) const { return item(name) != nullptr && item(name)->isVisible(); }
    void setTheme(int mode) {
        engine_->singletonInstance<QObject*>("Furrow.Controls", "Theme")->setProperty("forced", mode);
    }
    StickExport& stick() const { return *session_->exporter()->stick(); }
    void openOn(const QTemporaryDir& folder) {
        plugIn(folder.path());
        click("empty.sample.0");
        QTRY_VERIFY_WITH_TIMEOUT(isFinished(session_->planning()->state()), kPatienceMs);
        click("exportButton");
        click("export.onStick");
        QTRY_VERIFY(shown("stick.terminal"));
        // Not the one of an earlier run.
        stick().setTerminal(
            static_cast<int>(stick().terminalNames().indexOf(QStringLiteral("Another ISOBUS terminal"))));
        QTRY_VERIFY(shown("stick.row.0"));
    }
    /// A folder that is listed like a stick, as long as it is there.
    void plugIn(const QString& path) const {
        stick().setLister([path]() -> std::vector<StickExport::Stick> {
            if (!QFile::exists(path)) {
                return {};
            }
            return {{path, QStringLiteral("FIELDS"),
                     QStringLiteral("%1 · FAT32 · 14.9 GB free of 15.6 GB").arg(path)}};
        });
    }
    static QByteArray contentsOf(const QString& path) {
        QFile file{path};
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray{};
    }

private slots:
    void aStickIsWrittenAndWhatWasThereIsKept() {
        const QTemporaryDir folder;
        QVERIFY(QDir{folder.path()}.mkdir(QStringLiteral("TASKDATA")));
        QFile old{folder.filePath(QStringLiteral("TASKDATA/TASKDATA.XML"))};
        QVERIFY(old.open(QIODevice::WriteOnly) && old.write("the old one") > 0);
        old.close();
        openOn(folder);
        QTRY_VERIFY(shown("stick.conflict"));
        picture(QStringLiteral("stick-asks"));
        QVERIFY(!item("export.write")->isEnabled());
        click("stick.replace");
        QTRY_VERIFY(item("export.write")->isEnabled());
        click("export.write");
        QTRY_COMPARE(stick().state(), StickExport::State::Done);
        QTRY_VERIFY(shown("stick.message"));
        QVERIFY(
            item("stick.message")->property("text").toString().startsWith(QStringLiteral("Safe to unplug")));
        picture(QStringLiteral("stick-done"));
        QCOMPARE(contentsOf(folder.filePath(QStringLiteral("TASKDATA_backup_1/TASKDATA.XML"))),
                 QByteArray{"the old one"});
        QVERIFY(contentsOf(folder.filePath(QStringLiteral("TASKDATA/TASKDATA.XML"))).contains("<PFD"));
        click("export.close");
        QTRY_VERIFY(!shown("stick.message"));
    }

    void aFolderTakesThePlaceOfAStick() {
        const QTemporaryDir stickFolder;
        const QTemporaryDir folder;
        openOn(stickFolder);
        // In the place of the system's own dialog.
        stick().addFolder(QUrl::fromLocalFile(folder.path()));
        QTRY_VERIFY(shown("stick.row.1"));
        click("stick.row.0");
        QTRY_COMPARE(stick().current(), 0);
        click("stick.row.1");
        QTRY_COMPARE(stick().current(), 1);
        QTRY_VERIFY(stick().warnings().isEmpty());
        click("export.write");
        QTRY_COMPARE(stick().state(), StickExport::State::Done);
        QVERIFY(item("stick.message")->property("text").toString().startsWith(QStringLiteral("Written")));
        QVERIFY(!QDir{folder.path()}.isEmpty() && QDir{stickFolder.path()}.isEmpty());
    }

    void theTerminalDecidesTheFiles() {
        const QTemporaryDir folder;
        openOn(folder);
        // The first of the list is AgOpenGPS: chosen by keys, as without a mouse.
        click("stick.terminal");
        QTest::keyClick(window_, Qt::Key_Home);
        QTest::keyClick(window_, Qt::Key_Return);
        QTRY_COMPARE(stick().terminal(), 0);
        QVERIFY(item("stick.shows")->property("text").toString().contains(QStringLiteral("recorded path")));
        click("export.write");
        QTRY_COMPARE(stick().state(), StickExport::State::Done);
        const QStringList fields = QDir{folder.filePath(QStringLiteral("AgOpenGPS/Fields"))}.entryList(
            QDir::Dirs | QDir::NoDotAndDotDot);
        QCOMPARE(fields.size(), 1);
        QVERIFY(QFile::exists(
            folder.filePath(QStringLiteral("AgOpenGPS/Fields/%1/RecPath.txt").arg(fields.first()))));
        picture(QStringLiteral("stick-agopengps"));
    }

    void aStickThatIsGoneIsTold() {
        auto folder = std::make_unique<QTemporaryDir>();
        const QString path = folder->path();
        openOn(*folder);
        stick().setSearching(false);  // so that it is still in the list
        folder.reset();
        QVERIFY(!QFile::exists(path));
        click("export.write");
        QTRY_COMPARE(stick().state(), StickExport::State::Failed);
        QTRY_VERIFY(shown("stick.problem"));
        picture(QStringLiteral("stick-gone"));
        QVERIFY(!QFile::exists(path));
    }

    void aStickThatIsPulledOutLeavesTheList() {
        auto folder = std::make_unique<QTemporaryDir>();
        openOn(*folder);
        folder.reset();
        QTRY_VERIFY(shown("stick.none"));
        QVERIFY(!item("export.write")->isEnabled());
    }

    void picturesOfEveryTheme_data() {
        QTest::addColumn<int>("mode");
        QTest::addColumn<QSize>("size");
        QTest::addColumn<QString>("name");
        QTest::newRow("light, smallest") << 1 << QSize{1000, 700} << "light-1000";
        QTest::newRow("dark, smallest") << 2 << QSize{1000, 700} << "dark-1000";
        QTest::newRow("light, small") << 1 << QSize{1280, 800} << "light-1280";
        QTest::newRow("dark, small") << 2 << QSize{1280, 800} << "dark-1280";
        QTest::newRow("light, usual") << 1 << QSize{1440, 900} << "light-1440";
        QTest::newRow("dark, usual") << 2 << QSize{1440, 900} << "dark-1440";
        QTest::newRow("light, large") << 1 << QSize{1920, 1200} << "light-1920";
        QTest::newRow("dark, large") << 2 << QSize{1920, 1200} << "dark-1920";
    }
    void picturesOfEveryTheme() {
        QFETCH(int, mode);
        QFETCH(QSize, size);
        QFETCH(QString, name);
        window_->resize(size);
        QTRY_COMPARE(window_->width(), size.width());
        setTheme(mode);
        const QTemporaryDir folder;
        openOn(folder);
        waitForRest(*item("export.write"));
        picture(QStringLiteral("stick-") + name);
        click("export.write");
        QTRY_COMPARE(stick().state(), StickExport::State::Done);
        QVERIFY(stick().checks() > 5);
        QCOMPARE(stick().problems(), QStringList{});
        QTRY_VERIFY(shown("export.checked"));
        waitForRest(*item("export.write"));
        picture(QStringLiteral("done-") + name);
        click("export.inFolder");
        QTRY_VERIFY(shown("export.folder"));
        waitForRest(*item("export.write"));
        // Everything that can be pressed is inside the window.
        for (const char* button : {"export.write", "export.close", "export.choose", "export.format.0"}) {
            QVERIFY2(QRect(QPoint{}, size).contains(middleOf(*item(button))), button);
        }
        picture(QStringLiteral("files-") + name);
        setTheme(0);
    }
};

FURROW_TEST_WITH(TestExportWindow, QGuiApplication);
#include "tst_export_window.moc"
