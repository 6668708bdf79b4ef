// A field made from a recorded track, in the window: what is asked, what is shown, and what comes of it.

#include "tests/support/test_program.h"
#include "tests/ui/window/window_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTextStream>

using namespace furrow;

class TestFromTrackWindow : public test::WindowTest {
    Q_OBJECT

private slots:
    void withoutAFieldItBecomesOne();
    void withAPlanItIsAsked();
    void aClosedGpxIsABoundary();
    void troubleIsTold();
    void fromTheCommand();

private:
    FieldFromTrack& source() { return *session_->fieldFromTrack(); }
    void waitForOutline() {
        QTRY_VERIFY_WITH_TIMEOUT(source().isActive() && !source().isBusy(), kPatienceMs);
    }
    /// Places 100 m by 50 m around 5.1 east, 51.5 north; a degree of latitude has 111.26 km there, one of
    /// longitude 69.40 km.
    QString gpx(const QTemporaryDir& folder, const QString& name, const QList<QPointF>& metres, bool timed) {
        QFile file{folder.filePath(name)};
        if (!file.open(QIODevice::WriteOnly)) {
            return {};
        }
        QTextStream out{&file};
        out << "<gpx version=\"1.1\" creator=\"test\"><trk><trkseg>";
        int second = 0;
        for (const QPointF& place : metres) {
            out << QStringLiteral("<trkpt lat=\"%1\" lon=\"%2\">")
                       .arg(51.5 + place.y() / 111'260.0, 0, 'f', 9)
                       .arg(5.1 + place.x() / 69'400.0, 0, 'f', 9);
            if (timed) {
                out << QStringLiteral("<time>2026-05-04T10:%1:%2Z</time>")
                           .arg(second / 60, 2, 10, QLatin1Char('0'))
                           .arg(second % 60, 2, 10, QLatin1Char('0'));
                ++second;
            }
            out << "</trkpt>";
        }
        out << "</trkseg></trk></gpx>";
        return file.fileName();
    }
    static QList<QPointF> round() {
        QList<QPointF> places;
        for (int k = 0; k < 100; k += 5)
            places << QPointF(k, 0);
        for (int k = 0; k < 50; k += 5)
            places << QPointF(100, k);
        for (int k = 100; k > 0; k -= 5)
            places << QPointF(k, 50);
        for (int k = 50; k >= 0; k -= 5)
            places << QPointF(0, k);
        return places;
    }
    void open(const QString& path) { session_->opener()->openUrls({QUrl::fromLocalFile(path)}); }
    int fields() { return static_cast<int>(session_->document()->project()->fields.size()); }
};

void TestFromTrackWindow::withoutAFieldItBecomesOne() {
    const QTemporaryDir folder;
    open(gpx(folder, "north.gpx", round(), true));
    waitForOutline();
    QTRY_VERIFY(item("fieldFromTrackPanel")->isVisible());
    QVERIFY(!item("emptyState")->isVisible());
    QVERIFY2(source().isReady(), qPrintable(source().trouble()));
    // 100 m by 50 m.
    QCOMPARE(source().figures().first().toMap().value("value").toString(), QStringLiteral("0.50 ha"));
    QCOMPARE(item("fromTrack.kind")->property("displayText").toString(),
             QStringLiteral("As it looks: around the field"));
    picture("from_track");
    // Half of 6 m outside: 106 m by 56 m with round corners.
    click("fromTrack.width");
    key(Qt::Key_A, Qt::ControlModifier);
    type("6");
    key(Qt::Key_Return);
    click("fromTrack.half");
    waitForOutline();
    QTRY_VERIFY(source().isReady());
    QCOMPARE(source().beyond(), 3.0);
    QCOMPARE(source().figures().first().toMap().value("value").toString(), QStringLiteral("0.59 ha"));
    click("fromTrack.take");
    QTRY_COMPARE(fields(), 1);
    QVERIFY(!item("fieldFromTrackPanel")->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(isFinished(session_->planning()->state()), kPatienceMs);
    QCOMPARE(session_->farm()->fieldName(), QStringLiteral("north"));
    picture("from_track_taken");
    // One step.
    key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(fields(), 0);
}

void TestFromTrackWindow::withAPlanItIsAsked() {
    openSample("Home Field");
    const QTemporaryDir folder;
    const QString path = gpx(folder, "south.gpx", round(), true);
    open(path);
    QTRY_VERIFY(item("trackQuestion.make") != nullptr && item("trackQuestion.make")->hasActiveFocus());
    picture("track_question");
    key(Qt::Key_Escape);
    QTRY_VERIFY(!source().isAsking());
    QVERIFY(!source().isActive());
    open(path);
    QTRY_VERIFY(source().isAsking());
    click("trackQuestion.lay");
    QTRY_VERIFY(item("drivenPanel")->isVisible());
    // It is far from the plan; what else it may be is offered there.
    QTRY_VERIFY_WITH_TIMEOUT(!session_->driven()->isBusy() && !session_->driven()->trouble().isEmpty(),
                             kPatienceMs);
    picture("driven_make_field");
    click("driven.makeField");
    waitForOutline();
    QTRY_VERIFY(item("fieldFromTrackPanel")->isVisible());
    key(Qt::Key_Escape);
    QTRY_VERIFY(!source().isActive());
    QCOMPARE(fields(), 1);
    open(path);
    QTRY_VERIFY(source().isAsking() && item("trackQuestion.make")->hasActiveFocus());
    // Return takes what is offered first, and then the field.
    key(Qt::Key_Return);
    waitForOutline();
    QTRY_VERIFY(source().isReady());
    window_->resize(1000, 640);
    QTRY_COMPARE(window_->height(), 640);
    QTRY_COMPARE(item("fieldFromTrackPanel")->mapToScene({0.0, 0.0}).x(), 660.0);
    picture("from_track_small");
    key(Qt::Key_Return);
    QTRY_COMPARE(fields(), 2);
}

/// What a program drew is a boundary, as it was before.
void TestFromTrackWindow::aClosedGpxIsABoundary() {
    const QTemporaryDir folder;
    open(gpx(folder, "drawn.gpx", {{0, 0}, {100, 0}, {100, 50}, {0, 50}, {0, 0}}, false));
    QTRY_COMPARE(fields(), 1);
    QVERIFY(!source().isAsking() && !source().isActive());
}

void TestFromTrackWindow::troubleIsTold() {
    const QTemporaryDir folder;
    QList<QPointF> line;
    for (int k = 0; k < 200; k += 4) {
        line << QPointF(k, 0);
    }
    open(gpx(folder, "road.gpx", line, true));
    waitForOutline();
    QTRY_VERIFY(!source().trouble().isEmpty() && !source().remedy().isEmpty());
    QVERIFY(!item("fromTrack.take")->isEnabled());
    picture("from_track_trouble");
    click("fromTrack.cancel");
    QTRY_VERIFY(item("emptyState")->isVisible());
}

void TestFromTrackWindow::fromTheCommand() {
    const QTemporaryDir folder;
    const QString path = gpx(folder, "command.gpx", round(), true);
    key(Qt::Key_K, Qt::ControlModifier);
    type("make a field from");
    key(Qt::Key_Return);
    QTRY_VERIFY(item("files.path") != nullptr && item("files.path")->isVisible());
    click("files.path");
    key(Qt::Key_A, Qt::ControlModifier);
    type(path);
    key(Qt::Key_Return);
    waitForOutline();
    QVERIFY2(source().isReady(), qPrintable(source().trouble()));
}

FURROW_TEST_WITH(TestFromTrackWindow, QGuiApplication);
#include "tst_from_track_window.moc"
