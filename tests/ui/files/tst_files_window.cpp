// The file dialog in the window's look, with keys and mouse.

#include "tests/support/test_program.h"
#include "tests/ui/window/window_test.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

using namespace furrow;

class TestFilesWindow : public test::WindowTest {
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void opensWithKeys();
    void aTypedPathGoesIntoItsField();
    void opensSeveral();
    void savesWithTheSuggestedName();
    void asksBeforeWritingOver();
    void makesNoFolderSilently();
    void newFolder();
    void themes_data();
    void themes();

private:
    std::unique_ptr<QTemporaryDir> folder_;

    QString path(const QString& name) const { return folder_->filePath(name); }
    void put(const QString& name, const QByteArray& bytes = "x") const {
        QDir{}.mkpath(QFileInfo{path(name)}.path());
        QFile file{path(name)};
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }
    bool isOpen() const {
        const QQuickItem* list = item("files.list");
        return list != nullptr && list->isVisible();
    }
    QString told() const {
        return item("files.told")->isVisible() ? item("files.told")->property("text").toString() : QString{};
    }
    void into(const QString& folder) {
        click("files.path");
        key(Qt::Key_A, Qt::ControlModifier);
        type(folder);
        key(Qt::Key_Return);
        QTRY_COMPARE(item("files.path")->property("text").toString(), folder);
    }
    void enter(const QString& field, const QString& text) {
        click(field);
        key(Qt::Key_A, Qt::ControlModifier);
        type(text);
    }
    QString sample() const {
        return QStringLiteral(FURROW_SOURCE_DIR "/resources/sample_fields/home_field.geojson");
    }
    int fields() const { return static_cast<int>(session_->document()->project()->fields.size()); }
};

void TestFilesWindow::init() {
    QSettings{}.clear();
    folder_ = std::make_unique<QTemporaryDir>();
    put("zebra.geojson");
    put("below/inner.geojson");
    put("other.docx");
    QVERIFY(QFile::copy(sample(), path("home.geojson")));
    QVERIFY(QFile::copy(sample(), path("home 10.geojson")));
    QVERIFY(QFile::copy(sample(), path("home 9.geojson")));
    begin({1280, 800});
}

void TestFilesWindow::cleanup() {
    end();
    folder_.reset();
}

void TestFilesWindow::opensWithKeys() {
    key(Qt::Key_O, Qt::ControlModifier);
    QTRY_VERIFY(isOpen());
    into(folder_->path());
    QTRY_VERIFY(item("files.entry.below") != nullptr);
    // Folders first, names as people count; other kinds are not shown.
    QCOMPARE(item("files.entry.other.docx"), nullptr);
    QVERIFY(item("files.entry.below")->y() < item("files.entry.home 9.geojson")->y());
    QVERIFY(item("files.entry.home 9.geojson")->y() < item("files.entry.home 10.geojson")->y());
    picture("files_open");
    // Into the folder and up again, where it is the one that is at.
    item("files.list")->forceActiveFocus();
    key(Qt::Key_Home);
    key(Qt::Key_Return);
    QTRY_VERIFY(item("files.entry.inner.geojson") != nullptr);
    key(Qt::Key_Backspace);
    QTRY_VERIFY(item("files.entry.below") != nullptr);
    QTRY_COMPARE(item("files.list")->property("currentIndex").toInt(), 0);
    // By its first letters.
    type("home.");
    key(Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(fields(), 1, kPatienceMs);
    QVERIFY(!isOpen());
    // The folder is where the next one is looked for.
    key(Qt::Key_O, Qt::ControlModifier);
    QTRY_VERIFY(isOpen());
    QTRY_COMPARE(item("files.path")->property("text").toString(), folder_->path());
    QVERIFY(item("files.place." + folder_->path()) != nullptr);
    key(Qt::Key_Escape);
    QTRY_VERIFY(!isOpen());
    QCOMPARE(fields(), 1);
}

void TestFilesWindow::aTypedPathGoesIntoItsField() {
    key(Qt::Key_O, Qt::ControlModifier);
    QTRY_VERIFY(isOpen());
    into(folder_->path());
    item("files.list")->forceActiveFocus();
    key(Qt::Key_L, Qt::ControlModifier);
    QTRY_VERIFY(item("files.path")->hasActiveFocus());
    QCOMPARE(item("files.path")->property("selectedText").toString(), folder_->path());
    item("files.list")->forceActiveFocus();
    QVERIFY(sample().startsWith(u'/'));
    type(sample());
    QTRY_COMPARE(item("files.path")->property("text").toString(), sample());
    key(Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(fields(), 1, kPatienceMs);
    QVERIFY(!isOpen());
}

void TestFilesWindow::opensSeveral() {
    key(Qt::Key_O, Qt::ControlModifier);
    QTRY_VERIFY(isOpen());
    into(folder_->path());
    QTRY_VERIFY(item("files.entry.home.geojson") != nullptr);
    clickAt(middleOf(*item("files.entry.home 9.geojson")));
    clickAt(middleOf(*item("files.entry.home.geojson")), Qt::ControlModifier);
    click("files.accept");
    QTRY_COMPARE_WITH_TIMEOUT(fields(), 2, kPatienceMs);
}

void TestFilesWindow::savesWithTheSuggestedName() {
    openSample("Home Field");
    key(Qt::Key_S, Qt::ControlModifier);
    QTRY_VERIFY(isOpen());
    // The name has the keys; Return saves. The ending is added.
    QTRY_VERIFY(item("files.name")->hasActiveFocus());
    QVERIFY(item("files.name")->property("text").toString().endsWith(".furrow"));
    picture("files_save");
    enter("files.name", path("my farm"));
    key(Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path("my farm.furrow")), kPatienceMs);
    QTRY_COMPARE(session_->files()->path(), path("my farm.furrow"));
}

void TestFilesWindow::asksBeforeWritingOver() {
    openSample("Home Field");
    put("farm.furrow", "as it was");
    key(Qt::Key_S, Qt::ControlModifier);
    QTRY_VERIFY(isOpen());
    enter("files.name", path("farm"));
    key(Qt::Key_Return);
    QTRY_VERIFY2(told().contains("already there"), qPrintable(told()));
    picture("files_write_over");
    // No has the keys.
    key(Qt::Key_Return);
    QTRY_VERIFY(told().isEmpty());
    QVERIFY(isOpen());
    QFile file{path("farm.furrow")};
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray{"as it was"});
    key(Qt::Key_Return);
    QTRY_VERIFY(!told().isEmpty());
    click("files.yes");
    QTRY_COMPARE_WITH_TIMEOUT(session_->files()->path(), path("farm.furrow"), kPatienceMs);
}

void TestFilesWindow::makesNoFolderSilently() {
    openSample("Home Field");
    key(Qt::Key_S, Qt::ControlModifier);
    QTRY_VERIFY(isOpen());
    enter("files.name", path("not/there/farm"));
    key(Qt::Key_Return);
    QTRY_VERIFY2(told().contains("There is no folder"), qPrintable(told()));
    QVERIFY(!QDir{path("not")}.exists());
    picture("files_no_folder");
    click("files.no");
    QVERIFY(!QDir{path("not")}.exists());
    QVERIFY(isOpen());
    key(Qt::Key_Return);
    click("files.yes");
    QTRY_VERIFY(QDir{path("not/there")}.exists());
    QTRY_COMPARE(item("files.name")->property("text").toString(), QStringLiteral("farm"));
    key(Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path("not/there/farm.furrow")), kPatienceMs);
}

void TestFilesWindow::newFolder() {
    openSample("Home Field");
    key(Qt::Key_S, Qt::ControlModifier);
    QTRY_VERIFY(isOpen());
    into(folder_->path());
    click("files.newFolder");
    QTRY_VERIFY(item("files.folderName") != nullptr && item("files.folderName")->hasActiveFocus());
    type("season");
    key(Qt::Key_Return);
    QTRY_VERIFY(QDir{path("season")}.exists());
    QTRY_COMPARE(item("files.path")->property("text").toString(), path("season"));
    // Up with the mouse, back with two clicks.
    click("files.up");
    QTRY_VERIFY(item("files.entry.season") != nullptr);
    QTest::mouseDClick(window_, Qt::LeftButton, {}, middleOf(*item("files.entry.season")));
    QTRY_VERIFY(item("files.path") == nullptr || item("files.path")->property("text") == path("season"));
    QVERIFY2(isOpen(), "a folder is looked into, nothing is saved");
    click("files.cancel");
    QTRY_VERIFY(!isOpen());
    QVERIFY(session_->files()->path().isEmpty());
}

void TestFilesWindow::themes_data() {
    QTest::addColumn<int>("mode");
    QTest::newRow("light") << 1;
    QTest::newRow("dark") << 2;
    QTest::newRow("sunlight") << 3;
}

void TestFilesWindow::themes() {
    QFETCH(int, mode);
    auto* theme = engine_->singletonInstance<QObject*>("Furrow.Controls", "Theme");
    theme->setProperty("forced", mode);
    window_->resize(1000, 640);
    QTRY_COMPARE(window_->height(), 640);
    key(Qt::Key_O, Qt::ControlModifier);
    QTRY_VERIFY(isOpen());
    into(folder_->path());
    QTRY_VERIFY(item("files.entry.home.geojson") != nullptr);
    clickAt(middleOf(*item("files.entry.home.geojson")));
    // By size, the largest first.
    click("files.bySize");
    QTRY_VERIFY(item("files.entry.zebra.geojson")->y() > item("files.entry.home.geojson")->y());
    picture(QStringLiteral("files_%1").arg(QTest::currentDataTag()));
    theme->setProperty("forced", 0);
}

FURROW_TEST_WITH(TestFilesWindow, QGuiApplication);
#include "tst_files_window.moc"
