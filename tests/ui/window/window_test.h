#pragma once

#include "tests/support/patience.h"
#include "ui/edit/edit_layer.h"
#include "ui/map/map_camera.h"
#include "ui/shell/session.h"
#include "ui/shell/window_tools.h"

#include <QDir>
#include <QImage>
#include <QQmlApplicationEngine>
#include <QQuickItem>
#include <QQuickWindow>
#include <QScopeGuard>
#include <QSettings>
#include <QStandardPaths>
#include <QTest>

#include <memory>
#include <utility>

// What Qt's waiting macros expand to narrows a duration.
#pragma GCC diagnostic ignored "-Wconversion"

namespace furrow::test {

/// The whole window, with real mouse and keys. A test of it begins with an empty project.
class WindowTest : public QObject {
    Q_OBJECT

protected:
    std::unique_ptr<Session> session_;
    std::unique_ptr<QQmlApplicationEngine> engine_;
    QQuickWindow* window_ = nullptr;

    static QQuickItem* below(QQuickItem* parent, const QString& name) {
        if (parent->objectName() == name) {
            return parent;
        }
        for (QQuickItem* child : parent->childItems()) {
            if (QQuickItem* found = below(child, name)) {
                return found;
            }
        }
        return nullptr;
    }
    /// The program starts, with an empty project.
    void begin(QSize size) {
        session_ = std::make_unique<Session>();
        engine_ = std::make_unique<QQmlApplicationEngine>();
        engine_->setInitialProperties({{QStringLiteral("session"), QVariant::fromValue(session_.get())}});
        engine_->loadFromModule("Furrow.Shell", "Main");
        QVERIFY(!engine_->rootObjects().isEmpty());
        window_ = qobject_cast<QQuickWindow*>(engine_->rootObjects().first());
        window_->resize(size);
        window_->requestActivate();
        QVERIFY(QTest::qWaitForWindowActive(window_));
        QTRY_COMPARE(map()->width(), size.width() - 348.0);
    }
    /// It is gone, as if it were killed: nothing is asked or saved.
    void end() {
        engine_.reset();
        session_.reset();
    }
    /// Items made by views are children in the scene only.
    QQuickItem* item(const QString& name) const { return below(window_->contentItem(), name); }
    QPoint middleOf(const QQuickItem& of) const {
        return of.mapToScene({of.width() / 2.0, of.height() / 2.0}).toPoint();
    }
    /// The next frame is about to be drawn; all that moves has moved on.
    void nextFrame() const {
        bool moved = false;
        const auto once =
            QObject::connect(window_, &QQuickWindow::afterAnimating, window_, [&moved] { moved = true; });
        const auto disconnected = qScopeGuard([&once] { QObject::disconnect(once); });
        window_->update();
        QVERIFY(QTest::qWaitFor([&moved] { return moved; }, kPatienceMs));
    }
    /// Steps open and close in motion: a click must not go where the item was.
    void waitForRest(const QQuickItem& moving) const {
        constexpr int kFramesAtRest = 4;
        for (int atRest = 0; atRest < kFramesAtRest;) {
            const QPoint before = middleOf(moving);
            nextFrame();
            atRest = middleOf(moving) == before ? atRest + 1 : 0;
        }
    }
    /// Scrolls as the item's user would. False as long as it cannot be seen, or is in a step that opens: what
    /// that holds is in its place before there is room to scroll to it, and the step is scrolled to at last.
    static bool isScrolledTo(QQuickItem* wanted) {
        bool seen = true;
        for (QQuickItem* above = wanted->parentItem(); above != nullptr; above = above->parentItem()) {
            seen = seen && !above->property("moving").toBool();
            if (above->metaObject()->indexOfMethod("bringIntoView(QQuickItem*)") >= 0) {
                QMetaObject::invokeMethod(above, "bringIntoView", Q_ARG(QQuickItem*, wanted));
                seen = seen && above->contains(above->mapFromItem(
                                   wanted, {wanted->width() / 2.0, wanted->height() / 2.0}));
            }
        }
        return seen;
    }
    void bringIntoView(const QString& name) {
        QTRY_VERIFY2(item(name) != nullptr && item(name)->isVisible(), qPrintable(name));
        waitForRest(*item(name));
        QTRY_VERIFY2(isScrolledTo(item(name)), qPrintable(name));
        waitForRest(*item(name));
    }
    void click(const QString& name) {
        bringIntoView(name);
        QTest::mouseClick(window_, Qt::LeftButton, {}, middleOf(*item(name)));
    }
    QQuickItem* map() const { return item(QStringLiteral("editLayer")); }
    FieldEditor* editor() const { return qobject_cast<EditLayer*>(map())->editor(); }
    MapCamera* camera() const { return qobject_cast<EditLayer*>(map())->camera(); }
    QPoint onMap(const QGeoCoordinate& place) const {
        return map()->mapToScene(camera()->position(place)).toPoint();
    }
    void openSample(const QString& name) {
        const auto index = static_cast<int>(session_->opener()->sampleNames().indexOf(name));
        QVERIFY2(index >= 0, qPrintable(name));
        click(QStringLiteral("empty.sample.%1").arg(index));
        QTRY_VERIFY_WITH_TIMEOUT(isFinished(session_->planning()->state()), kPatienceMs);
    }
    void picture(const QString& name) {
        QDir{}.mkpath(QStringLiteral(FURROW_SCREENSHOT_DIR));
        QVERIFY(window_->grabWindow().save(QStringLiteral(FURROW_SCREENSHOT_DIR "/%1.png").arg(name)));
    }
    void key(int key, Qt::KeyboardModifiers modifiers = {}) const {
        QTest::keyClick(window_, static_cast<Qt::Key>(key), modifiers);
    }
    void type(const QString& text) const {
        for (const QChar letter : text) {
            QTest::keyClick(window_, letter.toLatin1());
        }
    }
    void clickAt(QPoint at, Qt::KeyboardModifiers modifiers = {}) const {
        QTest::mouseMove(window_, at);
        QTest::mouseClick(window_, Qt::LeftButton, modifiers, at);
    }
    void drag(QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {}) const {
        QTest::mouseMove(window_, from);
        QTest::mousePress(window_, Qt::LeftButton, modifiers, from);
        for (int i = 1; i <= 8; ++i) {
            QTest::mouseEvent(QTest::MouseMove, window_, Qt::NoButton, modifiers, from + (to - from) * i / 8);
        }
        QTest::mouseRelease(window_, Qt::LeftButton, modifiers, to);
    }

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        // The language is read once, when the window is prepared: an earlier run may have left another.
        nameProgram();
        QSettings{}.clear();
        prepareWindow();
    }
    void init() {
        // As on the first start: what an earlier test switched off is on again.
        QSettings{}.clear();
        begin({1280, 800});
    }
    void cleanup() { end(); }
};

}  // namespace furrow::test
