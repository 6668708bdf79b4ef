#include "tests/support/test_program.h"
#include "ui/trouble/crash_record.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cstdlib>
#include <exception>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace furrow;

namespace {

/// More of the stack than there is. The result is used, so that nothing is left out.
int deep(int level) {
    volatile char room[4096] = {};
    room[level % 4096] = 1;
    return level < 0 ? 0 : deep(level + 1) + room[0];
}

}  // namespace

/// A program that crashes leaves a record, whatever ends it, and ends as it would have without.
class TestCrashRecord : public QObject {
    Q_OBJECT

private slots:
    void aCrashIsRecorded_data() {
        QTest::addColumn<int>("how");
        QTest::addColumn<QByteArray>("signal");
        QTest::newRow("a place that is not there") << 0 << QByteArray{"SIGSEGV"};
        QTest::newRow("abort") << 1 << QByteArray{"SIGABRT"};
        QTest::newRow("an exception that nobody catches") << 2 << QByteArray{"SIGABRT"};
        QTest::newRow("the stack is used up") << 3 << QByteArray{"SIGSEGV"};
    }
    void aCrashIsRecorded() {
        QFETCH(int, how);
        QFETCH(QByteArray, signal);
        const QTemporaryDir folder;
        const std::string records = folder.filePath(QStringLiteral("crashes")).toStdString();
        const pid_t child = fork();
        if (child == 0) {
            // No memory image, and nothing on the test's own output.
            const rlimit none{0, 0};
            setrlimit(RLIMIT_CORE, &none);
            std::freopen("/dev/null", "w", stderr);
            crash_record::begin(records);
            crash_record::setText(R"({"furrow": "before"})");
            crash_record::setText(R"({"furrow": "now"})");
            if (how == 0) {
                volatile int* nowhere = nullptr;
                *nowhere = 1;
            } else if (how == 1) {
                std::abort();
            } else if (how == 2) {
                std::terminate();  // as an exception that nobody catches ends
            } else {
                std::_Exit(deep(0));
            }
            std::_Exit(0);
        }
        int status = 0;
        QCOMPARE(waitpid(child, &status, 0), child);
        QVERIFY(WIFSIGNALED(status));
        const QStringList files = QDir{QString::fromStdString(records)}.entryList(QDir::Files);
        QCOMPARE(files, QStringList{QStringLiteral("crash-%1.txt").arg(child)});
        QFile file{QString::fromStdString(records) + QLatin1Char('/') + files.first()};
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QList<QByteArray> lines = file.readAll().split('\n');
        QVERIFY(lines.size() > 4);
        QCOMPARE(lines[0], signal);
        QCOMPARE(lines[1], QByteArray{R"({"furrow": "now"})"});
    }
};

FURROW_TEST(TestCrashRecord);
#include "tst_crash_record.moc"
