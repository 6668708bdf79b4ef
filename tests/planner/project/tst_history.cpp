#include "planner/project/history.h"
#include "planner/project/project_file.h"
#include "tests/planner/project/project_samples.h"
#include "tests/support/furrow_cli.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

using namespace furrow;
using namespace furrow::test;

namespace {

std::shared_ptr<const Project> shared(Project project) {
    return std::make_shared<const Project>(std::move(project));
}

/// The sample project whose first field is called so.
std::shared_ptr<const Project> renamed(const Project& project, const std::string& name) {
    Project next = project;
    ProjectField field = *next.fields.front();
    FieldSource source = *field.source;
    source.name = name;
    field.source = std::make_shared<const FieldSource>(std::move(source));
    next.fields.front() = std::make_shared<const ProjectField>(std::move(field));
    return shared(std::move(next));
}

History sampleHistory(int steps) {
    History history;
    history.base = shared(sampleProject());
    for (int i = 0; i < steps; ++i) {
        const std::string name = "name " + std::to_string(i);
        history.steps.push_back({"Call it " + name, renamed(*history.current(), name)});
        ++history.done;
    }
    history.file = u8"/fields/Höfe/farm.furrow";
    history.savedFingerprint = "abc-3";
    history.saved = 0;
    return history;
}

void compare(const History& read, const History& expected) {
    QVERIFY(*read.base == *expected.base);
    QCOMPARE(read.steps.size(), expected.steps.size());
    for (std::size_t i = 0; i < read.steps.size(); ++i) {
        QCOMPARE(read.steps[i].text, expected.steps[i].text);
        QVERIFY(*read.steps[i].after == *expected.steps[i].after);
    }
    QCOMPARE(read.done, expected.done);
    QCOMPARE(read.file, expected.file);
    QCOMPARE(read.savedFingerprint, expected.savedFingerprint);
    QVERIFY(read.saved == expected.saved);
}

History readBack(const std::filesystem::path& path) {
    const auto journal = HistoryJournal::open(path);
    return journal ? journal->read().value_or(History{}) : History{};
}

}  // namespace

class TestHistory : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> folder_;
    std::filesystem::path path_;

private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        path_ = folder_->filePath(QStringLiteral("farm.history")).toStdU16String();
    }
    void whatIsWrittenIsReadBack() {
        const History history = sampleHistory(5);
        {
            auto journal = HistoryJournal::open(path_);
            VERIFY_RESULT(journal);
            VERIFY_RESULT(journal->write(history));
        }
        compare(readBack(path_), history);
    }
    void aLinkBesideIsNotFollowed() {
        const QString mine = folder_->filePath("mine.txt");
        QFile file{mine};
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("mine") == 4);
        file.close();
        QVERIFY(QFile::link(mine, folder_->filePath("farm.history.part")));
        const History history = sampleHistory(2);
        auto journal = HistoryJournal::open(path_);
        VERIFY_RESULT(journal);
        VERIFY_RESULT(journal->write(history));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray{"mine"});
    }
    void changesAreAppended() {
        History history = sampleHistory(2);
        {
            auto journal = HistoryJournal::open(path_);
            VERIFY_RESULT(journal);
            VERIFY_RESULT(journal->write(history));
            // Undone, then something else is done in its place, then the last step goes on.
            history.done = 1;
            VERIFY_RESULT(journal->write(history));
            history.steps.resize(1);
            history.steps.push_back({"Another", renamed(*history.current(), "another")});
            history.done = 2;
            VERIFY_RESULT(journal->write(history));
            history.steps.back() = {"Another", renamed(*history.base, "goes on")};
            VERIFY_RESULT(journal->write(history));
            history.saved = 2;
            VERIFY_RESULT(journal->write(history));
            // A step that came to nothing is taken off the end.
            history.steps.pop_back();
            history.done = 1;
            history.saved = std::nullopt;
            VERIFY_RESULT(journal->write(history));
        }
        compare(readBack(path_), history);
    }
    /// Whatever byte a crash stops at, what was whole before is there.
    void aCutOffEndIsDropped() {
        const History history = sampleHistory(3);
        std::size_t afterTwo = 0;
        {
            auto journal = HistoryJournal::open(path_);
            VERIFY_RESULT(journal);
            History two = history;
            two.steps.pop_back();
            two.done = 2;
            VERIFY_RESULT(journal->write(two));
            afterTwo = std::filesystem::file_size(path_);
            VERIFY_RESULT(journal->write(history));
        }
        const std::size_t all = std::filesystem::file_size(path_);
        for (std::size_t size = all; size-- > afterTwo; size -= size - afterTwo > 50 ? 37 : 0) {
            std::filesystem::resize_file(path_, size);
            const History read = readBack(path_);
            QVERIFY(read.base != nullptr);
            QVERIFY(*read.current() == *history.steps[1].after);
        }
        std::filesystem::resize_file(path_, 20);
        QVERIFY(readBack(path_).base == nullptr);
    }
    void aDamagedLineEndsIt() {
        {
            auto journal = HistoryJournal::open(path_);
            VERIFY_RESULT(journal);
            VERIFY_RESULT(journal->write(sampleHistory(3)));
        }
        const QString file = QString::fromStdU16String(path_.u16string());
        QByteArray bytes = contentsOf(file);
        bytes.replace("name 1", "name 7");
        writeFile(file, bytes);
        const History read = readBack(path_);
        QVERIFY(read.base != nullptr);
        QCOMPARE(read.steps.size(), std::size_t{1});
    }
    void onlyOneProgramHasIt() {
        const auto first = HistoryJournal::open(path_);
        VERIFY_RESULT(first);
        const auto second = HistoryJournal::open(path_);
        QVERIFY(!second.has_value());
        QVERIFY(second.error().what.contains("another window"));
    }
    void writtenAnewItStaysLocked() {
        auto journal = HistoryJournal::open(path_);
        VERIFY_RESULT(journal);
        VERIFY_RESULT(journal->write(sampleHistory(1)));
        VERIFY_RESULT(journal->write(sampleHistory(2)));
        QVERIFY(!HistoryJournal::open(path_).has_value());
        compare(*journal->read(), sampleHistory(2));
    }
    void longHistoriesLoseTheirBeginning() {
        const History history = sampleHistory(static_cast<int>(HistoryJournal::kMostSteps) + 7);
        {
            auto journal = HistoryJournal::open(path_);
            VERIFY_RESULT(journal);
            VERIFY_RESULT(journal->write(history));
        }
        const History read = readBack(path_);
        QCOMPARE(read.steps.size(), HistoryJournal::kMostSteps);
        QVERIFY(*read.base == *history.steps[6].after);
        QVERIFY(*read.current() == *history.current());
        QVERIFY(read.isUnsaved());
    }
};

FURROW_TEST(TestHistory);
#include "tst_history.moc"
