#include "planner/io/content/plan_content.h"
#include "planner/io/delivery/stick_writer.h"
#include "tests/planner/io/format_cases.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <optional>

using namespace furrow;
using namespace furrow::test;

namespace {

namespace fs = std::filesystem;

const Plan& plan() {
    static const std::shared_ptr<const Plan> made = [] {
        FieldSource source = fieldWithEverything().field;
        source.parts.resize(1);
        source.obstacles.resize(1);
        return planOf(source, "power-harrow-drill");
    }();
    return *made;
}

/// A folder that stands for a stick, on which things go wrong when they are told to.
class FaultyStick : public StickVolume {
public:
    explicit FaultyStick(const fs::path& root) : root_{root}, real_{openStick(root)} {}

    int writesLeft = 1000;            ///< then it was pulled out
    int renamesLeft = 1000;           ///< then it was pulled out
    std::optional<fs::path> flips;    ///< reads back another byte of this file
    std::optional<VolumeInfo> state;  ///< instead of the folder's own
    std::stop_source* stopAtWrite = nullptr;

    Result<VolumeInfo> info() const override { return state ? Result<VolumeInfo>{*state} : real_->info(); }
    bool exists(const fs::path& path) const override { return real_->exists(path); }
    Result<void> write(const fs::path& path, std::string_view bytes) override {
        if (stopAtWrite != nullptr) {
            stopAtWrite->request_stop();
        }
        return writesLeft-- > 0 ? real_->write(path, bytes) : std::unexpected(pulledOut());
    }
    Result<std::string> read(const fs::path& path) const override {
        auto bytes = real_->read(path);
        if (bytes && flips && path.filename() == *flips) {
            bytes->back() = '?';
        }
        return bytes;
    }
    Result<void> rename(const fs::path& from, const fs::path& to) override {
        return renamesLeft-- > 0 ? real_->rename(from, to) : std::unexpected(pulledOut());
    }
    void removeAll(const fs::path& path) override { real_->removeAll(path); }
    Result<void> sync() override { return real_->sync(); }

private:
    static Error pulledOut() {
        return {.code = ErrorCode::WriteFailed,
                .what = "the stick does not answer any more",
                .where = "stick",
                .remedy = "plug it in"};
    }
    fs::path root_;
    std::unique_ptr<StickVolume> real_;
};

std::vector<std::string> filesIn(const fs::path& root) {
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator{root}) {
        if (entry.is_regular_file()) {
            files.push_back(entry.path().lexically_relative(root).string());
        }
    }
    std::ranges::sort(files);
    return files;
}

struct Setup {
    explicit Setup(std::string_view terminalId = "fendt") {
        const Terminal* terminal = findTerminal(terminalId).value();
        files = terminalFiles(*terminal, plan()).value();
        meant = {contentOf(plan(), terminal->options)};
        root = fs::path{folder.path().toStdString()};
    }
    void putOldTaskData() const {
        fs::create_directories(root / "TASKDATA");
        std::ofstream{root / "TASKDATA/TASKDATA.XML"} << "the old one";
    }
    QTemporaryDir folder;
    fs::path root;
    FormatFiles files;
    std::vector<FieldContent> meant;
};

}  // namespace

class StickTest : public QObject {
    Q_OBJECT

private slots:
    void writesAndCompares_data() {
        QTest::addColumn<QString>("terminal");
        QTest::addColumn<QString>("file");
        QTest::addColumn<bool>("compared");
        QTest::newRow("ISOXML 4") << "fendt" << "TASKDATA/TASKDATA.XML" << true;
        QTest::newRow("ISOXML 3") << "claas-s10" << "TASKDATA/TASKDATA.XML" << true;
        QTest::newRow("holes as obstacles") << "agopengps-isoxml" << "TASKDATA/TASKDATA.XML" << true;
        QTest::newRow("AgOpenGPS") << "agopengps"
                                   << QString::fromUtf8("AgOpenGPS/Fields/Höhe & Senke/RecPath.txt") << true;
        QTest::newRow("AgGPS") << "trimble" << "AgGPS/Data/Furrow/Farm/Hoehe _ Senke/Swaths.shp" << true;
        QTest::newRow("waypoints") << "ardupilot-rover" << "plan.waypoints" << false;
    }
    void writesAndCompares() {
        QFETCH(QString, terminal);
        QFETCH(QString, file);
        QFETCH(bool, compared);
        const Setup setup{terminal.toStdString()};
        FaultyStick stick{setup.root};
        double last = 0.0;
        JobContext job;
        job.progress = [&last](double share) {
            QVERIFY(share >= last);
            last = share;
        };
        const auto report = writeToStick(stick, setup.files, setup.meant, false, job);
        VERIFY_RESULT(report);
        QCOMPARE(report->contentCompared, compared);
        QVERIFY(report->backups.empty());
        QCOMPARE(last, 1.0);
        const auto there = filesIn(setup.root);
        QVERIFY(std::ranges::contains(there, file.toStdString()));
        QCOMPARE(there.size(), setup.files.files.size());
        for (const FileToWrite& meant : setup.files.files) {
            QCOMPARE(bytesOf(setup.root / meant.path), meant.text());
        }
    }

    void keepsWhatWasThere() {
        const Setup setup;
        setup.putOldTaskData();
        FaultyStick stick{setup.root};
        QCOMPARE(stickConflicts(stick, setup.files), std::vector<fs::path>{"TASKDATA"});
        const auto refused = writeToStick(stick, setup.files, setup.meant, false);
        QVERIFY(!refused && refused.error().code == ErrorCode::Usage);
        QCOMPARE(bytesOf(setup.root / "TASKDATA/TASKDATA.XML"), std::string{"the old one"});
        for (int time = 1; time <= 2; ++time) {
            const auto report = writeToStick(stick, setup.files, setup.meant, true);
            VERIFY_RESULT(report);
            QCOMPARE(report->backups, std::vector<fs::path>{std::format("TASKDATA_backup_{}", time)});
        }
        QCOMPARE(bytesOf(setup.root / "TASKDATA_backup_1/TASKDATA.XML"), std::string{"the old one"});
        // The old one, and twice the task data with its list of links.
        QCOMPARE(filesIn(setup.root).size(), 5U);
    }

    void nothingHalfWritten_data() {
        QTest::addColumn<int>("writes");
        QTest::addColumn<int>("renames");
        QTest::addColumn<QString>("terminal");
        QTest::newRow("pulled out at once") << 0 << 1000 << "fendt";
        QTest::newRow("pulled out at the fourth file") << 3 << 1000 << "agopengps";
        QTest::newRow("before the old folder is kept") << 1000 << 0 << "fendt";
        QTest::newRow("before the new one has its name") << 1000 << 1 << "fendt";
    }
    void nothingHalfWritten() {
        QFETCH(int, writes);
        QFETCH(int, renames);
        QFETCH(QString, terminal);
        const Setup setup{terminal.toStdString()};
        setup.putOldTaskData();
        FaultyStick stick{setup.root};
        stick.writesLeft = writes;
        stick.renamesLeft = renames;
        const auto report = writeToStick(stick, setup.files, setup.meant, true);
        QVERIFY(!report && report.error().code == ErrorCode::WriteFailed);
        QVERIFY(report.error().what.contains("does not answer"));
        const auto there = filesIn(setup.root);
        // The rename back fails, too, on a stick that is gone: then the old folder has its backup name.
        const bool kept = there == std::vector<std::string>{"TASKDATA/TASKDATA.XML"} ||
                          there == std::vector<std::string>{"TASKDATA_backup_1/TASKDATA.XML"};
        QVERIFY2(kept, there.empty() ? "nothing is there" : there.front().c_str());
        QCOMPARE(bytesOf(setup.root / there.front()), std::string{"the old one"});
    }

    void otherBytesAreFound() {
        const Setup setup;
        setup.putOldTaskData();
        FaultyStick stick{setup.root};
        stick.flips = "TASKDATA.XML";
        const auto report = writeToStick(stick, setup.files, setup.meant, true);
        QVERIFY(!report);
        QVERIFY2(report.error().what.contains("reads back other bytes"), report.error().line().c_str());
        QCOMPARE(filesIn(setup.root), std::vector<std::string>{"TASKDATA/TASKDATA.XML"});
    }

    void otherContentIsFound() {
        const Setup setup;
        setup.putOldTaskData();
        FaultyStick stick{setup.root};
        std::vector<FieldContent> other = setup.meant;
        other[0].field.parts[0].outer[0].lonDeg -= 0.001;
        const auto report = writeToStick(stick, setup.files, other, true);
        QVERIFY(!report);
        QVERIFY2(report.error().what.contains("is not the plan"), report.error().line().c_str());
        QCOMPARE(filesIn(setup.root), std::vector<std::string>{"TASKDATA/TASKDATA.XML"});
        QCOMPARE(bytesOf(setup.root / "TASKDATA/TASKDATA.XML"), std::string{"the old one"});
    }

    void fullAndProtectedSticksAreRefused() {
        const Setup setup;
        FaultyStick stick{setup.root};
        stick.state =
            VolumeInfo{.root = setup.root, .fileSystem = "vfat", .freeBytes = 1000, .totalBytes = 1'000'000};
        const auto full = writeToStick(stick, setup.files, setup.meant, true);
        QVERIFY(!full && full.error().what.contains("MB free"));
        stick.state->freeBytes = 1'000'000'000;
        stick.state->readOnly = true;
        const auto readOnly = writeToStick(stick, setup.files, setup.meant, true);
        QVERIFY(!readOnly && readOnly.error().what.contains("write-protected"));
        QVERIFY(filesIn(setup.root).empty());
    }

    void stops() {
        const Setup setup{"agopengps"};
        FaultyStick stick{setup.root};
        std::stop_source stop;
        stick.stopAtWrite = &stop;
        JobContext job;
        job.stop = stop.get_token();
        const auto report = writeToStick(stick, setup.files, setup.meant, true, job);
        QVERIFY(!report && report.error().code == ErrorCode::Cancelled);
        QVERIFY(filesIn(setup.root).empty());
    }

    void warnsOfWhatTerminalsCannotRead_data() {
        QTest::addColumn<QString>("fileSystem");
        QTest::addColumn<int>("partitions");
        QTest::addColumn<int>("warnings");
        QTest::newRow("FAT32") << "vfat" << 1 << 0;
        QTest::newRow("NTFS by its driver") << "ntfs3" << 1 << 1;
        QTest::newRow("NTFS by ntfs-3g") << "fuseblk" << 1 << 1;
        QTest::newRow("exFAT") << "exfat" << 1 << 1;
        QTest::newRow("ext4 in two partitions") << "ext4" << 2 << 2;
        QTest::newRow("not known") << "" << 1 << 0;
    }
    void warnsOfWhatTerminalsCannotRead() {
        QFETCH(QString, fileSystem);
        QFETCH(int, partitions);
        QFETCH(int, warnings);
        const auto told = stickWarnings({.fileSystem = fileSystem.toStdString(), .partitions = partitions});
        QCOMPARE(static_cast<int>(told.size()), warnings);
    }

    void aFolderThatIsGoneIsNotMadeAnew() {
        fs::path root;
        {
            const QTemporaryDir folder;
            root = fs::path{folder.path().toStdString()};
        }
        const auto stick = openStick(root);
        QVERIFY(!stick->info());
        const auto written = stick->write("TASKDATA/TASKDATA.XML", "x");
        QVERIFY(!written && written.error().what.contains("does not answer any more"));
        QVERIFY(!fs::exists(root));
    }

    /// The names and bytes go through FAT32 unchanged, put there and taken from there by mtools.
    void namesFitFat32() {
        const QTemporaryDir folder;
        const QString image = folder.filePath("stick.img");
        QFile file{image};
        QVERIFY(file.open(QIODevice::WriteOnly) && file.resize(qint64{40} << 20));
        file.close();
        if (run("mkfs.vfat", {"-F", "32", image}).status != 0 ||
            QStandardPaths::findExecutable("mcopy").isEmpty()) {
            QSKIP("needs mkfs.vfat and mcopy");
        }
        for (const char* terminal : {"fendt", "agopengps", "trimble"}) {
            const Setup setup{terminal};
            FaultyStick stick{setup.root};
            VERIFY_RESULT(writeToStick(stick, setup.files, setup.meant, true));
            const QString top = QDir{QString::fromStdString(setup.root.string())}
                                    .entryList(QDir::Dirs | QDir::NoDotAndDotDot)
                                    .first();
            const Printed there = run(
                "mcopy",
                {"-s", "-i", image, QString::fromStdString((setup.root / top.toStdString()).string()), "::"});
            QVERIFY2(there.status == 0, there.error.constData());
            const QString back = folder.filePath(terminal);
            QVERIFY(QDir{}.mkpath(back));
            const Printed again = run("mcopy", {"-s", "-i", image, "::" + top, back});
            QVERIFY2(again.status == 0, again.error.constData());
            for (const FileToWrite& meant : setup.files.files) {
                QCOMPARE(bytesOf(fs::path{back.toStdString()} / meant.path), meant.text());
            }
        }
    }

    /// A real FAT32 file system in an image, where this machine lets us mount one.
    void realFat32() {
        const QTemporaryDir folder;
        const QString image = folder.filePath("stick.img");
        const QString mount = folder.filePath("mount");
        QVERIFY(QDir{}.mkpath(mount));
        QFile file{image};
        QVERIFY(file.open(QIODevice::WriteOnly) && file.resize(qint64{40} << 20));
        file.close();
        if (run("mkfs.vfat", {"-F", "32", image}).status != 0 ||
            run("mount", {"-o", "loop,utf8", image, mount}).status != 0) {
            QSKIP("needs mkfs.vfat and the right to mount an image");
        }
        struct Unmount {
            QString mount;
            ~Unmount() { run("umount", {mount}); }
        } const unmount{mount};
        const Setup setup;
        const auto stick = openStick(mount.toStdString());
        const auto info = stick->info();
        VERIFY_RESULT(info);
        QCOMPARE(info->fileSystem, std::string{"vfat"});
        QVERIFY(info->freeBytes > 30'000'000 && info->freeBytes < 40 << 20);
        QVERIFY(stickWarnings(*info).empty());
        for (int time = 0; time < 2; ++time) {
            const auto report = writeToStick(*stick, setup.files, setup.meant, true);
            VERIFY_RESULT(report);
            QCOMPARE(report->backups.size(), static_cast<std::size_t>(time));
        }
        // Full: what is there stays.
        std::ofstream{fs::path{mount.toStdString()} / "filler"} << std::string(info->freeBytes, 'x');
        const auto full = writeToStick(*stick, setup.files, setup.meant, true);
        QVERIFY(!full && full.error().code == ErrorCode::WriteFailed);
        QVERIFY(fs::exists(fs::path{mount.toStdString()} / "TASKDATA/TASKDATA.XML"));
        QVERIFY(!fs::exists(fs::path{mount.toStdString()} / "FURROW.TMP"));
        // Write-protected.
        QCOMPARE(run("mount", {"-o", "remount,ro", mount}).status, 0);
        const auto readOnly = writeToStick(*stick, setup.files, setup.meant, true);
        QVERIFY(!readOnly && readOnly.error().what.contains("write-protected"));
    }
};

FURROW_TEST(StickTest);
#include "tst_stick.moc"
