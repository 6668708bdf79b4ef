#include "planner/plan/method_registry.h"
#include "planner/project/project_edits.h"
#include "tests/planner/project/project_samples.h"
#include "tests/support/furrow_cli.h"
#include "tests/support/patience.h"
#include "tests/support/result_check.h"
#include "ui/project/project_files.h"

#include <QElapsedTimer>
#include <QRandomGenerator>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <cstdio>

using namespace furrow;
using namespace furrow::test;

namespace {

/// Stands for the step that made it: the headland is this wide.
Project numbered(const Project& project, int number) {
    Settings settings = project.plan().settings;
    if (!settings.set(**findParameter("headland.width_m"), 1.0 + number * 1e-3)) {
        qFatal("no such width");
    }
    return withPlan(project, project.plan().machine, settings);
}

int numberOf(const Project& project) {
    const auto width = project.plan().settings.length(**findParameter("headland.width_m"));
    return width ? static_cast<int>(std::lround((width->si() - 1.0) * 1e3)) : 0;
}

/// A document with its files, as the window has them.
struct Desk {
    Document document;
    ProjectFiles files{document};

    explicit Desk(const QString& journals = {}) {
        if (!journals.isEmpty()) {
            files.keepIn(journals);
        }
    }
    bool open(const QString& path) {
        auto opened = readProject(path.toStdU16String());
        return opened && files.open(path, std::move(*opened));
    }
    void step(int number) {
        document.change([number] { return QStringLiteral("Step %1").arg(number); },
                        numbered(*document.project(), number));
    }
};

}  // namespace

class TestProjectFiles : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> folder_;
    QString journals_;
    QString path_;

private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        journals_ = folder_->filePath(QStringLiteral("journals"));
        path_ = folder_->filePath(QStringLiteral("My farm.furrow"));
    }
    void savesUnderANameAndAgain() {
        Desk desk;
        QSignalSpy saved{&desk.files, &ProjectFiles::saved};
        desk.step(1);
        desk.files.save();
        QVERIFY2(!QFile::exists(path_), "it has no name yet");
        desk.files.saveAs(QUrl::fromLocalFile(folder_->filePath(QStringLiteral("My farm"))));
        QTRY_COMPARE(saved.count(), 1);
        QVERIFY(!desk.document.isModified());
        QCOMPARE(desk.files.name(), QStringLiteral("My farm"));
        desk.step(2);
        QVERIFY(desk.document.isModified());
        desk.files.save();
        QTRY_COMPARE(saved.count(), 2);
        QCOMPARE(numberOf(readProject(path_.toStdU16String())->project), 2);
    }
    void anUnwritablePlaceIsTold() {
        Desk desk;
        desk.step(1);
        writeFile(folder_->filePath(QStringLiteral("file")), "x");
        desk.files.saveAs(QUrl::fromLocalFile(folder_->filePath(QStringLiteral("file/below.furrow"))));
        QTRY_COMPARE(desk.files.trouble(), ProjectFiles::Trouble::NotSaved);
        QVERIFY(!desk.files.message().isEmpty());
        QVERIFY(!desk.files.remedy().isEmpty());
        QVERIFY(desk.document.isModified());
        desk.files.saveAs(QUrl::fromLocalFile(path_));
        QTRY_VERIFY(!desk.document.isModified());
        QCOMPARE(desk.files.trouble(), ProjectFiles::Trouble::None);
    }
    void anotherProgramsChangeIsNotWrittenOver() {
        Desk desk;
        desk.step(1);
        desk.files.saveAs(QUrl::fromLocalFile(path_));
        QTRY_VERIFY(!desk.document.isModified());
        const auto theirs = projectText(withFields(Project::empty(), {sampleSource()}));
        writeFile(path_, QByteArray::fromStdString(theirs));
        desk.step(2);
        desk.files.save();
        QTRY_COMPARE(desk.files.trouble(), ProjectFiles::Trouble::ChangedOnDisk);
        QCOMPARE(contentsOf(path_), QByteArray::fromStdString(theirs));
        QVERIFY(desk.document.isModified());
        desk.files.overwrite();
        QTRY_VERIFY(!desk.document.isModified());
        QCOMPARE(numberOf(readProject(path_.toStdU16String())->project), 2);
    }
    void undoGoesOnAfterReopening() {
        {
            Desk desk{journals_};
            desk.step(1);
            desk.step(2);
            desk.files.saveAs(QUrl::fromLocalFile(path_));
            QTRY_VERIFY(!desk.document.isModified());
        }
        Desk desk{journals_};
        QVERIFY(!desk.files.recover());
        QVERIFY(desk.open(path_));
        QCOMPARE(desk.files.trouble(), ProjectFiles::Trouble::None);
        QCOMPARE(numberOf(*desk.document.project()), 2);
        QCOMPARE(desk.document.undoText(), QStringLiteral("Step 2"));
        desk.document.undo();
        desk.document.undo();
        QCOMPARE(numberOf(*desk.document.project()), 0);
        QVERIFY2(!contentsOf(path_).contains("Step 2"), "the history is not in the project file");
    }
    void whatWasNotSavedComesBack() {
        {
            Desk desk{journals_};
            desk.step(1);
            desk.files.saveAs(QUrl::fromLocalFile(path_));
            QTRY_VERIFY(!desk.document.isModified());
            desk.step(2);
        }
        {
            Desk desk{journals_};
            QVERIFY(desk.files.recover());
            QCOMPARE(desk.files.trouble(), ProjectFiles::Trouble::Restored);
            QCOMPARE(desk.files.path(), path_);
            QCOMPARE(numberOf(*desk.document.project()), 2);
            QVERIFY(desk.document.isModified());
            desk.files.discardChanges();
            QCOMPARE(numberOf(*desk.document.project()), 1);
            QVERIFY(!desk.document.isModified());
        }
        Desk desk{journals_};
        QVERIFY(!desk.files.recover());
    }
    void workWithoutANameComesBackToo() {
        {
            Desk desk{journals_};
            desk.document.change([] { return QStringLiteral("Add"); },
                                 withFields(*desk.document.project(), {sampleSource()}));
        }
        {
            Desk desk{journals_};
            QVERIFY(desk.files.recover());
            QCOMPARE(desk.document.project()->fields.size(), std::size_t{1});
            QVERIFY(desk.files.path().isEmpty());
            desk.files.abandonChanges();
        }
        Desk desk{journals_};
        QVERIFY2(!desk.files.recover(), "it was not wanted");
    }
    void nothingDoneLeavesNothingBehind() {
        {
            Desk desk{journals_};
        }
        QVERIFY(QDir{journals_}.isEmpty());
    }
    /// The file was changed by another program after a crash with unsaved changes.
    void bothSidesAreKeptAfterACrash() {
        {
            Desk desk{journals_};
            desk.step(1);
            desk.files.saveAs(QUrl::fromLocalFile(path_));
            QTRY_VERIFY(!desk.document.isModified());
            desk.step(2);
        }
        VERIFY_RESULT(writeProject(numbered(Project::empty(), 7), path_.toStdU16String()));
        Desk desk{journals_};
        QVERIFY(desk.open(path_));
        QCOMPARE(desk.files.trouble(), ProjectFiles::Trouble::Restored);
        QCOMPARE(numberOf(*desk.document.project()), 2);
        desk.document.undo();
        QCOMPARE(numberOf(*desk.document.project()), 7);
    }
    void twoWindowsDoNotWriteOverEachOther() {
        Desk first{journals_};
        first.step(1);
        first.files.saveAs(QUrl::fromLocalFile(path_));
        QTRY_VERIFY(!first.document.isModified());
        Desk second{journals_};
        second.step(5);
        QVERIFY(!second.open(path_));
        QVERIFY(second.files.message().contains(QStringLiteral("another window")));
        QCOMPARE(numberOf(*second.document.project()), 5);
        QVERIFY2(first.open(path_), "the same window may read it again");
    }
    void oddMembersAreTold() {
        writeFile(path_, R"({"furrow_project": {"format_version": 1, "standard": {"id": "s",
            "machine": {"operating_width_m": 3, "min_turning_radius_m": 5}, "settings": {"x.y": 1}}}, "features": []})");
        Desk desk;
        QVERIFY(desk.open(path_));
        QCOMPARE(desk.files.trouble(), ProjectFiles::Trouble::Notes);
        QVERIFY(desk.files.message().contains(QStringLiteral("x.y")));
    }
    /// A crash right after the file was written, before the journal knew.
    void whatWasSavedIsKnownAgain() {
        Desk desk{journals_};
        desk.step(1);
        desk.files.saveAs(QUrl::fromLocalFile(path_));
        QTRY_VERIFY(!desk.document.isModified());
        desk.step(2);
        VERIFY_RESULT(writeProject(*desk.document.project(), path_.toStdU16String()));
        desk.step(3);
        QVERIFY(desk.open(path_));
        QCOMPARE(numberOf(*desk.document.project()), 3);
        desk.files.save();
        QTRY_VERIFY(!desk.document.isModified());
        QCOMPARE(desk.files.trouble(), ProjectFiles::Trouble::None);
    }
    /// A program that edits and saves all the time is killed at random moments: the file is whole and holds
    /// what was saved last or later, and what the journal was asked to keep is there. FURROW_KILLS sets how
    /// often.
    void aKillLosesNothing() {
        const int kills =
            qEnvironmentVariableIsSet("FURROW_KILLS") ? qEnvironmentVariableIntValue("FURROW_KILLS") : 10;
        const quint32 seed = QRandomGenerator::global()->generate();
        QRandomGenerator random{seed};
        int savedSoFar = 0;
        int keptSoFar = 0;
        for (int kill = 0; kill < kills; ++kill) {
            QProcess child;
            child.setProgram(QCoreApplication::applicationFilePath());
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.insert(QStringLiteral("FURROW_EDIT"), path_);
            environment.insert(QStringLiteral("FURROW_JOURNALS"), journals_);
            child.setProcessEnvironment(environment);
            child.start();
            QVERIFY(child.waitForStarted());
            QVERIFY(child.waitForReadyRead(30000));
            QTest::qWait(static_cast<int>(random.bounded(120U)));
            ::kill(static_cast<pid_t>(child.processId()), SIGKILL);
            QVERIFY(child.waitForFinished());
            int saved = savedSoFar;
            int kept = 0;
            for (const QByteArray& line : child.readAllStandardOutput().split('\n')) {
                if (line.startsWith("saved ") && line.endsWith('.')) {
                    saved = line.mid(6).chopped(1).toInt();
                } else if (line.startsWith("kept ") && line.endsWith('.')) {
                    kept = line.mid(5).chopped(1).toInt();
                }
            }
            const QByteArray told = QByteArray::number(kill) + " of seed " + QByteArray::number(seed);
            if (saved > 0) {
                const auto file = readProject(path_.toStdU16String());
                QVERIFY2(file.has_value(), (told + (file ? "" : file.error().line().c_str())).constData());
                QVERIFY2(numberOf(file->project) >= saved, told.constData());
            }
            savedSoFar = saved;
            Desk desk{journals_};
            const bool recovered = desk.files.recover();
            if (!recovered && QFile::exists(path_)) {
                QVERIFY2(desk.open(path_), told.constData());
            }
            QVERIFY2(numberOf(*desk.document.project()) >= std::max(saved, kept), told.constData());
            keptSoFar = std::max(keptSoFar, kept);
        }
        qInfo("killed %d times, the last save at step %d, the last journal at %d", kills, savedSoFar,
              keptSoFar);
        QVERIFY2(keptSoFar > 0, "the program was never given the time to do anything");
    }
};

/// What aKillLosesNothing kills.
static int editUntilKilled() {
    const QString path = qEnvironmentVariable("FURROW_EDIT");
    Desk desk{qEnvironmentVariable("FURROW_JOURNALS")};
    if (!desk.files.recover() && QFile::exists(path) && !desk.open(path)) {
        return 1;
    }
    int number = numberOf(*desk.document.project());
    if (desk.document.project()->fields.empty()) {
        desk.document.change([] { return QStringLiteral("Add"); },
                             withFields(*desk.document.project(), {sampleSource()}));
    }
    const auto tell = [](const char* what, int value) {
        std::printf("%s %d.\n", what, value);
        std::fflush(stdout);
    };
    QObject::connect(&desk.files, &ProjectFiles::saved,
                     [&] { tell("saved", numberOf(readProject(path.toStdU16String())->project)); });
    while (number < 90'000) {
        desk.step(++number);
        if (number % 3 == 0) {
            desk.files.flush();
            tell("kept", number);
        }
        if (number % 7 == 0) {
            desk.files.path().isEmpty() ? desk.files.saveAs(QUrl::fromLocalFile(path)) : desk.files.save();
        }
        if (number % 11 == 0) {
            desk.document.undo();
            desk.document.redo();
        }
        QCoreApplication::processEvents();
    }
    return 0;
}

int main(int argc, char* argv[]) {
    QCoreApplication application{argc, argv};
    if (qEnvironmentVariableIsSet("FURROW_EDIT")) {
        return editUntilKilled();
    }
    TestProjectFiles test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_project_files.moc"
