// What the command line says where a command ends with an exception.

#include "app/cli/exit_status.h"
#include "tests/support/test_program.h"

#include <QTemporaryFile>
#include <QTest>

#include <unistd.h>

#include <cstdio>
#include <functional>
#include <new>
#include <stdexcept>

using namespace furrow;

namespace {

struct Said {
    int status = 0;
    QByteArray error;
};

/// Runs a command with standard error in a file.
Said said(const std::function<int()>& run) {
    QTemporaryFile file;
    if (!file.open()) {
        qFatal("no temporary file");
    }
    std::fflush(stderr);
    const int before = ::dup(STDERR_FILENO);
    ::dup2(file.handle(), STDERR_FILENO);
    const int status = cli::ranAndWritten(run);
    std::fflush(stderr);
    ::dup2(before, STDERR_FILENO);
    ::close(before);
    file.seek(0);
    return {status, file.readAll()};
}

}  // namespace

class TestExitStatus : public QObject {
    Q_OBJECT

private slots:
    void noMemory() {
        const Said answer = said([]() -> int { throw std::bad_alloc{}; });
        QCOMPARE(answer.status, static_cast<int>(cli::kInputRefused));
        QVERIFY2(answer.error.contains("not enough memory") && answer.error.contains("give a smaller field"),
                 answer.error);
        QVERIFY2(!answer.error.contains("bad_alloc") && answer.error.count('\n') == 1, answer.error);
    }
    void aMistakeOfFurrow() {
        const Said answer = said([]() -> int { throw std::logic_error{"three is two"}; });
        QCOMPARE(answer.status, static_cast<int>(cli::kInputRefused));
        QVERIFY2(answer.error.contains("three is two") && answer.error.contains("report"), answer.error);
    }
    void whatItReturns() {
        const Said answer = said([] { return 130; });
        QCOMPARE(answer.status, 130);
        QVERIFY(answer.error.isEmpty());
    }
};

FURROW_TEST(TestExitStatus);
#include "tst_exit_status.moc"
