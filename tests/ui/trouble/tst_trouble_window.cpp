#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/editor_window_test.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

using namespace furrow;

/// What the user sees after a crash, and the report of a problem.
class TestTroubleWindow : public test::EditorWindowTest {
    Q_OBJECT

private:
    static void write(const QString& path, const QByteArray& text) {
        QFile file{path};
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(text), text.size());
    }

private slots:
    void aCrashIsToldOnce() {
        const QTemporaryDir folder;
        QVERIFY(QDir{folder.path()}.mkpath(QStringLiteral("crashes")));
        write(folder.filePath(QStringLiteral("crashes/crash-7.txt")), "SIGSEGV\n{}\nframes\n");
        session_->keepIn(folder.path());
        QTRY_VERIFY(shows(QStringLiteral("crashNotice")));
        const auto place = [&](const char* name) {
            const QQuickItem* const of = item(QString::fromUtf8(name));
            return of->mapRectToScene(QRectF{0.0, 0.0, of->width(), of->height()});
        };
        QTRY_VERIFY(!place("crashNotice").intersects(place("emptyState")));
        picture(QStringLiteral("crash_told"));
        click(QStringLiteral("crashNotice.report"));
        QTRY_VERIFY(shows(QStringLiteral("trouble.save")));
        waitForRest(*item(QStringLiteral("trouble.save")));
        picture(QStringLiteral("trouble_report"));
        QVERIFY(!shows(QStringLiteral("crashNotice")));
        key(Qt::Key_Escape);
        // The next start says nothing of it, and the report still has it.
        end();
        begin({1280, 800});
        session_->keepIn(folder.path());
        QVERIFY(!session_->trouble()->hasCrashed());
        const QJsonArray crashes = QJsonDocument::fromJson(session_->trouble()->text())
                                       .object()
                                       .value(QStringLiteral("crashes"))
                                       .toArray();
        QCOMPARE(crashes.size(), 1);
        QVERIFY(crashes.first().toString().startsWith(QStringLiteral("SIGSEGV")));
    }
    void theReportHoldsTheFieldAndNoNames() {
        DRAW_FIELD();
        session_->farm()->renameField(QStringLiteral("Secret Meadow"));
        session_->farm()->renamePlan(QStringLiteral("Hidden plan"), QStringLiteral("1999"));
        ready();
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("report.json"));
        session_->trouble()->save(QUrl::fromLocalFile(file));
        QVERIFY2(!session_->trouble()->hasFailed(), qPrintable(session_->trouble()->outcome()));
        QFile written{file};
        QVERIFY(written.open(QIODevice::ReadOnly));
        const QByteArray text = written.readAll();
        QVERIFY(!text.contains("Secret") && !text.contains("Hidden") && !text.contains("1999"));
        const QJsonObject report = QJsonDocument::fromJson(text).object();
        QCOMPARE(report.value(QStringLiteral("furrow")).toString(), QStringLiteral(FURROW_VERSION));
        const QJsonArray features =
            report.value(QStringLiteral("project")).toObject().value(QStringLiteral("features")).toArray();
        QCOMPARE(features.size(), 1);
        const QJsonArray ring = features.first()
                                    .toObject()
                                    .value(QStringLiteral("geometry"))
                                    .toObject()
                                    .value(QStringLiteral("coordinates"))
                                    .toArray()
                                    .first()
                                    .toArray();
        // Four corners, and the first one again.
        QCOMPARE(ring.size(), 5);
        QCOMPARE(report.value(QStringLiteral("findings")).toArray().size(), session_->findings()->count());
        // Where it cannot be written, the reason is told.
        session_->trouble()->save(
            QUrl::fromLocalFile(folder.filePath(QStringLiteral("no/such/folder.json"))));
        QVERIFY(session_->trouble()->hasFailed());
        QVERIFY(!session_->trouble()->outcome().isEmpty());
    }
    void itIsInTheMenu() {
        key(Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(item(QStringLiteral("palette.field"))->hasActiveFocus());
        type(QStringLiteral("report a problem"));
        QTRY_VERIFY(shows(QStringLiteral("palette.row.0")));
        key(Qt::Key_Return);
        QTRY_VERIFY(shows(QStringLiteral("trouble.save")));
    }
};

FURROW_TEST_WITH(TestTroubleWindow, QGuiApplication);
#include "tst_trouble_window.moc"
