// A recorded track over the plan in the window. The track is the plan's own path, moved by a known amount.

#include "tests/support/test_program.h"
#include "tests/ui/window/window_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTextStream>

using namespace furrow;

class TestDrivenWindow : public test::WindowTest {
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void besideThePlan();
    void badFilesAreTold();
    void followsThePlan();

private:
    DrivenTrack& track() { return *session_->driven(); }
    void waitForTrack() {
        QTRY_VERIFY_WITH_TIMEOUT(!track().isBusy() && (track().isReady() || !track().trouble().isEmpty()),
                                 kPatienceMs);
    }
    QString value(const QString& label) {
        for (const QVariant& row : track().figures()) {
            if (row.toMap().value("label").toString() == label) {
                return row.toMap().value("value").toString();
            }
        }
        return {};
    }
    /// As a CSV of places in WGS84, `shiftM` to the east, one a second.
    QString driven(const QTemporaryDir& folder, double shiftM) {
        const Plan& plan = *session_->shown()->plan();
        QFile file{folder.filePath("drive.csv")};
        if (!file.open(QIODevice::WriteOnly)) {
            return {};
        }
        QTextStream out{&file};
        out << "time_s,lon,lat\n";
        double next = 0.0;
        for (const PathSegment& segment : plan.path.segments) {
            for (const PathSample& sample : segment.samples) {
                if (sample.tS >= next) {
                    const GeoPoint place = plan.field().frame().toGeo(sample.position + Point{shiftM, 0.0});
                    out << QString::number(sample.tS, 'f', 2) << ',' << QString::number(place.lonDeg, 'f', 9)
                        << ',' << QString::number(place.latDeg, 'f', 9) << '\n';
                    next = sample.tS + 1.0;
                }
            }
        }
        return file.fileName();
    }
};

void TestDrivenWindow::init() {
    begin({1440, 900});
    openSample("Home Field");
}

void TestDrivenWindow::cleanup() {
    end();
}

void TestDrivenWindow::besideThePlan() {
    const QTemporaryDir folder;
    track().open(QUrl::fromLocalFile(driven(folder, 0.0)));
    QTRY_VERIFY(item("drivenPanel")->isVisible());
    waitForTrack();
    QVERIFY2(track().isReady(), qPrintable(track().trouble()));
    // Exactly on it.
    QCOMPARE(value("95 % are within"), QStringLiteral("0.00 m"));
    QCOMPARE(value("On the plan"), QStringLiteral("100.0 %"));
    // Half a metre beside it, and the chart and the map say so.
    track().open(QUrl::fromLocalFile(driven(folder, 0.5)));
    waitForTrack();
    QCOMPARE(value("Farthest"), QStringLiteral("0.50 m"));
    // The plan covers 99.6 %; half a metre to the east leaves a strip along one side.
    const QString covered = value("Covered").section(QStringLiteral(" · "), 1).section(u' ', 0, 0);
    QVERIFY2(covered.toDouble() > 97.0 && covered.toDouble() < 99.9, qPrintable(value("Covered")));
    picture("driven");
    const double zoom = camera()->zoomLevel();
    click("driven.course");
    QTRY_VERIFY(camera()->zoomLevel() > zoom);
    picture("driven_place");
    click("driven.farthest");
    window_->resize(1000, 640);
    QTRY_COMPARE(map()->width(), 1000.0 - 348.0 - 340.0);
    picture("driven_small");
    click("driven.close");
    QTRY_VERIFY(!item("drivenPanel")->isVisible());
    QVERIFY(!track().isActive());
}

void TestDrivenWindow::badFilesAreTold() {
    const QTemporaryDir folder;
    QFile file{folder.filePath("empty.gpx")};
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.close();
    track().open(QUrl::fromLocalFile(file.fileName()));
    waitForTrack();
    QVERIFY(!track().trouble().isEmpty() && !track().remedy().isEmpty());
    picture("driven_trouble");
    track().open(QUrl::fromLocalFile(folder.filePath("nowhere.gpx")));
    waitForTrack();
    QVERIFY(!track().trouble().isEmpty());
    // Another place on Earth.
    track().open(QUrl::fromLocalFile(driven(folder, 5000.0)));
    waitForTrack();
    QVERIFY2(track().trouble().contains("does not come"), qPrintable(track().trouble()));
    key(Qt::Key_Escape);
    QTRY_VERIFY(!item("drivenPanel")->isVisible());
}

void TestDrivenWindow::followsThePlan() {
    const QTemporaryDir folder;
    track().open(QUrl::fromLocalFile(driven(folder, 0.0)));
    waitForTrack();
    // Another field has another plan, and the track does not come there.
    session_->opener()->openSample(1);
    QTRY_VERIFY_WITH_TIMEOUT(!track().isBusy() && !track().trouble().isEmpty(), kPatienceMs);
    QVERIFY(!track().isReady());
}

FURROW_TEST_WITH(TestDrivenWindow, QGuiApplication);
#include "tst_driven_window.moc"
