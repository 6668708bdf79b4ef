#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/window_test.h"
#include "ui/shell/window_fit.h"

#include <QScreen>

using namespace furrow;

/// The window lies on the screen that it starts on, whatever it was on before, and what it holds can be
/// reached.
class TestFitWindow : public test::WindowTest {
    Q_OBJECT

private:
    /// Starts again with this remembered.
    void startWith(const QRect& remembered) {
        end();
        QSettings{}.clear();
        QSettings settings;
        settings.setValue(QStringLiteral("geometry/width"), remembered.width());
        settings.setValue(QStringLiteral("geometry/height"), remembered.height());
        settings.setValue(QStringLiteral("geometry/x"), remembered.x());
        settings.setValue(QStringLiteral("geometry/y"), remembered.y());
        settings.sync();
        session_ = std::make_unique<Session>();
        engine_ = std::make_unique<QQmlApplicationEngine>();
        engine_->setInitialProperties({{QStringLiteral("session"), QVariant::fromValue(session_.get())}});
        engine_->loadFromModule("Furrow.Shell", "Main");
        QVERIFY(!engine_->rootObjects().isEmpty());
        window_ = qobject_cast<QQuickWindow*>(engine_->rootObjects().first());
        QVERIFY(QTest::qWaitForWindowExposed(window_));
    }
    QRect screen() const { return window_->screen()->availableGeometry(); }
    /// What the user sees of an item is not outside of the window.
    bool isReachable(const QString& name) const {
        const QQuickItem* found = item(name);
        return found != nullptr && found->isVisible() &&
               QRect(QPoint{}, window_->size()).contains(middleOf(*found));
    }
    /// Resizes and waits until the map has its place.
    void become(QSize size) {
        window_->resize(size);
        QTRY_COMPARE(window_->width(), size.width());
        QTRY_COMPARE(window_->height(), size.height());
    }

private slots:
    void whatIsWantedIsFitted_data() {
        QTest::addColumn<QRect>("wanted");
        QTest::addColumn<QRect>("available");
        QTest::addColumn<QMargins>("frame");
        QTest::addColumn<QRect>("expected");
        const QRect laptop{0, 0, 1366, 728};
        const QMargins none;
        const QMargins title{1, 30, 1, 1};
        QTest::newRow("it fits") << QRect{100, 60, 900, 600} << laptop << none << QRect{100, 60, 900, 600};
        QTest::newRow("too large") << QRect{0, 0, 1440, 900} << laptop << none << QRect{0, 0, 1366, 728};
        QTest::newRow("too large with its frame")
            << QRect{0, 0, 1440, 900} << laptop << title << QRect{1, 30, 1364, 697};
        QTest::newRow("twice as large")
            << QRect{0, 0, 2880, 1800} << QRect{0, 0, 1440, 860} << none << QRect{0, 0, 1440, 860};
        QTest::newRow("a screen that is gone")
            << QRect{2000, 300, 1200, 700} << laptop << none << QRect{166, 28, 1200, 700};
        QTest::newRow("above and left")
            << QRect{-50, -20, 1000, 700} << laptop << title << QRect{1, 30, 1000, 697};
        QTest::newRow("the second screen") << QRect{1500, 100, 1000, 700} << QRect{1366, 0, 1920, 1080}
                                           << none << QRect{1500, 100, 1000, 700};
        QTest::newRow("below a bar at the top")
            << QRect{0, 0, 1000, 600} << QRect{0, 40, 1366, 728} << none << QRect{0, 40, 1000, 600};
    }
    void whatIsWantedIsFitted() {
        QFETCH(QRect, wanted);
        QFETCH(QRect, available);
        QFETCH(QMargins, frame);
        QFETCH(QRect, expected);
        QCOMPARE(fitted(wanted, available, frame), expected);
    }

    void itStartsOnTheScreen_data() {
        QTest::addColumn<QRect>("remembered");
        QTest::newRow("of a larger screen") << QRect{0, 0, 2880, 1800};
        QTest::newRow("of a screen that is gone") << QRect{5000, 4000, 1000, 700};
        QTest::newRow("left and above") << QRect{-300, -200, 1000, 700};
        QTest::newRow("larger in one way") << QRect{40, 40, 4000, 650};
    }
    void itStartsOnTheScreen() {
        QFETCH(QRect, remembered);
        startWith(remembered);
        QTRY_VERIFY2(screen().contains(window_->geometry()),
                     qPrintable(QStringLiteral("%1 x %2").arg(window_->width()).arg(window_->height())));
        QVERIFY(window_->minimumWidth() <= screen().width() && window_->minimumHeight() <= screen().height());
    }

    void everythingCanBeReached_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("1366 x 768, with bars") << QSize{1366, 700};
        QTest::newRow("1280 x 720, with bars") << QSize{1280, 650};
        QTest::newRow("1920 x 1080 at 200 %") << QSize{960, 540};
        QTest::newRow("1366 x 768 at 200 %") << QSize{683, 384};
    }
    void everythingCanBeReached() {
        QFETCH(QSize, size);
        const QString name = QStringLiteral("%1x%2").arg(size.width()).arg(size.height());
        window_->setMinimumSize({});
        become(size);
        for (const char* button : {"empty.open", "empty.draw", "openButton"}) {
            // The button of the bar gives way where there is little room.
            QTRY_VERIFY2(isReachable(QLatin1String{button}) ||
                             (size.width() < 720 && qstrcmp(button, "openButton") == 0),
                         button);
        }
        picture(QStringLiteral("fit-%1-empty").arg(name));
        key(Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(isReachable(QStringLiteral("palette.row.1")));
        picture(QStringLiteral("fit-%1-palette").arg(name));
        key(Qt::Key_Escape);
        QTRY_VERIFY(!isReachable(QStringLiteral("palette.row.1")));
        session_->opener()->openSample(
            static_cast<int>(session_->opener()->sampleNames().indexOf(QStringLiteral("Slanted Field"))));
        QTRY_VERIFY_WITH_TIMEOUT(isFinished(session_->planning()->state()), kPatienceMs);
        for (const char* button : {"exportButton", "undoButton", "statusChip", "scaleBar", "stepsSwitch"}) {
            QTRY_VERIFY2(isReachable(QLatin1String{button}), button);
        }
        picture(QStringLiteral("fit-%1").arg(name));
        key(Qt::Key_E, Qt::ControlModifier);
        QTRY_VERIFY(isReachable(QStringLiteral("export.write")));
        waitForRest(*item(QStringLiteral("export.write")));
        for (const char* button : {"export.write", "export.close", "export.onStick", "export.heading"}) {
            QVERIFY2(isReachable(QLatin1String{button}), button);
        }
        picture(QStringLiteral("fit-%1-export").arg(name));
        key(Qt::Key_Escape);
        QTRY_VERIFY(!isReachable(QStringLiteral("export.write")));
        key(Qt::Key_F1, Qt::ControlModifier);
        QTRY_VERIFY(item(QStringLiteral("keysDialog.close")) != nullptr &&
                    item(QStringLiteral("keysDialog.close"))->hasActiveFocus());
        waitForRest(*item(QStringLiteral("keysDialog.close")));
        picture(QStringLiteral("fit-%1-keys").arg(name));
        for (int i = 0; i < 5; ++i) {
            key(Qt::Key_PageDown);
        }
        QTRY_VERIFY(isReachable(QStringLiteral("keysDialog.close")));
        click(QStringLiteral("keysDialog.close"));
        QTRY_VERIFY(!isReachable(QStringLiteral("keysDialog.close")));
        key(Qt::Key_Comma, Qt::ControlModifier);
        QTRY_VERIFY(item(QStringLiteral("preferences.close")) != nullptr &&
                    item(QStringLiteral("preferences.close"))->isVisible());
        waitForRest(*item(QStringLiteral("preferences.close")));
        item(QStringLiteral("preferences.close"))->forceActiveFocus(Qt::TabFocusReason);
        QTRY_VERIFY(isReachable(QStringLiteral("preferences.close")));
        picture(QStringLiteral("fit-%1-preferences").arg(name));
        click(QStringLiteral("preferences.close"));
        QTRY_VERIFY(!isReachable(QStringLiteral("preferences.close")));
        // The last step: scrolled to by keys, and what it leads to. In a small window the steps are a drawer.
        const bool drawer = size.width() < 860;
        QCOMPARE(isReachable(QStringLiteral("stepsPanel")), !drawer);
        if (drawer) {
            key(Qt::Key_F7);
            QTRY_VERIFY(isReachable(QStringLiteral("stepsPanel")));
            picture(QStringLiteral("fit-%1-steps").arg(name));
        }
        item(QStringLiteral("step.check"))->forceActiveFocus(Qt::TabFocusReason);
        QTRY_VERIFY(isReachable(QStringLiteral("step.check")));
        picture(QStringLiteral("fit-%1-check").arg(name));
        key(Qt::Key_Space);
        QTRY_VERIFY(isReachable(QStringLiteral("figure.Area")) || isReachable(QStringLiteral("finding.0")) ||
                    isReachable(QStringLiteral("noFindings")));
    }
};

FURROW_TEST_WITH(TestFitWindow, QGuiApplication);
#include "tst_fit_window.moc"
