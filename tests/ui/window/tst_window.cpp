#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/frame_clock.h"
#include "tests/ui/window/next_frame.h"
#include "tests/ui/window/window_test.h"

#include <QDragEnterEvent>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMimeData>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <ctime>

using namespace furrow;
using namespace furrow::test;

class TestWindow : public WindowTest {
    Q_OBJECT

private slots:
    void aNumberInThePanelChangesThePlan() {
        openSample(QStringLiteral("Home Field"));
        click(QStringLiteral("step.headland"));
        click(QStringLiteral("headland.width_m"));
        QTRY_VERIFY(item(QStringLiteral("headland.width_m"))->hasActiveFocus());
        QTest::keyClick(window_, Qt::Key_A, Qt::ControlModifier);
        for (const char key : {'2', '0', ',', '5'}) {
            QTest::keyClick(window_, key);
        }
        QTest::keyClick(window_, Qt::Key_Return);
        const Parameter& width = *findParameter("headland.width_m").value();
        QTRY_VERIFY(session_->planning()->settings().value(width) == SettingValue{20.5});
        QTest::keyClick(window_, Qt::Key_Up);
        QTRY_VERIFY(session_->planning()->settings().value(width) == SettingValue{21.0});
        // Eight passes of 2.5 m go into it.
        QTRY_COMPARE(session_->shown()->plan()->headland.width.si(), 20.0);
        click(QStringLiteral("headland.width_m.auto"));
        QTRY_VERIFY(session_->shown()->plan()->headland.width.si() < 20.0);
        picture(QStringLiteral("headland"));
    }
    /// As where Qt draws without OpenGL.
    void aMapWithoutOpenGLIsTold() {
        QQuickItem* const notice = item(QStringLiteral("drawingNotice"));
        QVERIFY(!notice->isVisible());
        notice->setProperty("api", QSGRendererInterface::Software);
        QTRY_VERIFY(notice->isVisible());
        picture(QStringLiteral("without-opengl"));
        click(QStringLiteral("drawingNotice.close"));
        QTRY_VERIFY(!notice->isVisible());
    }
    void aBoundaryIsDrawnByClicks() {
        camera()->centreOn(QGeoCoordinate{58.2515, 22.5035}, 16.0, false);
        click(QStringLiteral("drawTool"));
        QTRY_VERIFY(item(QStringLiteral("drawingHint"))->isVisible());
        const QPoint middle = middleOf(*map());
        for (const QPoint offset :
             {QPoint{-200, -150}, QPoint{220, -140}, QPoint{200, 160}, QPoint{-190, 150}}) {
            QTest::mouseMove(window_, middle + offset);
            QTest::mouseClick(window_, Qt::LeftButton, {}, middle + offset);
        }
        picture(QStringLiteral("drawing"));
        QTest::keyClick(window_, Qt::Key_Return);
        QTRY_COMPARE(session_->planning()->state(), PlanState::Ready);
        QCOMPARE(session_->shown()->plan()->field().vertexCount(), std::size_t{4});
        // 400 by 300 pixels at zoom 16 and 58.25 north (1.257 m a pixel).
        QVERIFY(std::abs(inHectares(session_->shown()->plan()->field().area()) -
                         0.5 * (420 + 390) * 300 * 1.257 * 1.257 / 1e4) < 0.5);
    }
    void escapeGivesDrawingUp() {
        click(QStringLiteral("drawTool"));
        QTest::mouseClick(window_, Qt::LeftButton, {}, middleOf(*map()) + QPoint{-300, 250});
        QTRY_COMPARE(editor()->sketchCount(), 1);
        QTest::keyClick(window_, Qt::Key_Escape);
        QTRY_VERIFY(!item(QStringLiteral("drawingHint"))->isVisible());
        QVERIFY(!session_->farm()->hasField());
    }
    void aVertexIsDragged() {
        openSample(QStringLiteral("Home Field"));
        const double before = session_->shown()->plan()->field().area().si();
        const WorldPoint vertex = session_->shown()->drawing().geometry()->rings.front().points.front();
        const QPoint from = onMap(coordinate(vertex));
        const QPoint outwards = from - middleOf(*map());
        QTest::mouseMove(window_, from);
        QTest::mousePress(window_, Qt::LeftButton, {}, from);
        const QGeoCoordinate centre = camera()->center();
        for (int i = 1; i <= 10; ++i) {
            QTest::mouseMove(window_, from + outwards * i / 60);
            QTRY_VERIFY(editor()->isDragging());
        }
        QTest::mouseRelease(window_, Qt::LeftButton, {}, from + outwards / 6);
        QTRY_VERIFY(session_->shown()->plan() &&
                    session_->shown()->plan()->field().area().si() > before * 1.01);
        QTRY_COMPARE(session_->planning()->state(), PlanState::Ready);
        QCOMPARE(camera()->center(), centre);
    }
    /// Prints how evenly frames come and how far the plan is behind while a vertex of the largest sample is
    /// dragged.
    void draggingAVertexOfALargeField() {
        openSample(QStringLiteral("Great Field"));
        const PlanGeometry& geometry = *session_->shown()->drawing().geometry();
        const QPoint from = onMap(coordinate(geometry.rings.front().points.front()));
        const QPoint inwards = middleOf(*map()) - from;
        QSignalSpy plans{session_->shown(), &ShownPlan::planChanged};
        QTest::mouseMove(window_, from);
        QTest::mousePress(window_, Qt::LeftButton, {}, from);
        const std::clock_t begin = std::clock();
        FrameClock frames{*window_};
        constexpr int kMoves = 120;
        for (int i = 1; i <= kMoves; ++i) {
            frames.move(from + inwards * i / (3 * kMoves));
        }
        const double used = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        qInfo("%lld drafts, %.0f ms of processor time; %s", static_cast<long long>(plans.count()), used,
              qPrintable(frames.text()));
        QTest::mouseRelease(window_, Qt::LeftButton, {}, from + inwards / 3);
        QVERIFY(frames.frames() > 0);
        QTRY_VERIFY_WITH_TIMEOUT(session_->shown()->hasPlan() && !session_->shown()->isDraft() &&
                                     session_->planning()->state() == PlanState::Ready,
                                 kPatienceMs);
    }
    void theMapIsPannedAndZoomed() {
        openSample(QStringLiteral("Home Field"));
        const QPoint middle = middleOf(*map());
        const QGeoCoordinate under = camera()->coordinateAt(map()->mapFromScene(middle));
        QTest::mousePress(window_, Qt::LeftButton, {}, middle);
        QTest::mouseMove(window_, middle + QPoint{40, 10});
        QTest::mouseMove(window_, middle + QPoint{90, 30});
        QTest::mouseRelease(window_, Qt::LeftButton, {}, middle + QPoint{90, 30});
        QVERIFY(under.distanceTo(camera()->coordinateAt(map()->mapFromScene(middle + QPoint{90, 30}))) < 0.5);
        const double zoom = camera()->zoomLevel();
        QTest::wheelEvent(window_, middle, QPoint{0, 120});
        QTRY_VERIFY(camera()->zoomLevel() > zoom + 0.4);
        click(QStringLiteral("fitTool"));
        QTRY_VERIFY(std::abs(camera()->zoomLevel() - zoom) < 1e-6);
    }
    void exportWritesAFolder() {
        openSample(QStringLiteral("Home Field"));
        const QTemporaryDir folder;
        click(QStringLiteral("exportButton"));
        QTRY_VERIFY(item(QStringLiteral("export.folder")) != nullptr &&
                    item(QStringLiteral("export.folder"))->isVisible());
        item(QStringLiteral("export.folder"))->setProperty("text", folder.filePath(QStringLiteral("out")));
        QTRY_VERIFY(item(QStringLiteral("export.folder"))->isEnabled());
        click(QStringLiteral("export.write"));
        QTRY_COMPARE(session_->exporter()->state(), ExportModel::State::Done);
        picture(QStringLiteral("export"));
        QFile summary{folder.filePath(QStringLiteral("out/summary.json"))};
        QVERIFY(summary.open(QIODevice::ReadOnly));
        const QJsonObject root = QJsonDocument::fromJson(summary.readAll()).object();
        QCOMPARE(root.value(u"swaths").toObject().value(u"count").toInt(),
                 static_cast<int>(session_->shown()->plan()->swaths.swaths.size()));
    }
    void aFindingIsShownOnTheMap() {
        openSample(QStringLiteral("Three Ponds"));
        QVERIFY(session_->findings()->count() > 0);
        click(QStringLiteral("finding.1"));
        const QGeoCoordinate place = session_->findings()->placeOf(1);
        QTRY_VERIFY(camera()->center().distanceTo(place) < 1.0);
        picture(QStringLiteral("finding"));
    }
    void everyFieldOfAFileIsOffered() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("two.geojson"));
        QFile file{path};
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"type": "FeatureCollection", "features": [
            {"type": "Feature", "properties": {"name": "North"}, "geometry": {"type": "Polygon", "coordinates":
              [[[22.5, 58.25], [22.505, 58.25], [22.504, 58.252], [22.5, 58.252], [22.5, 58.25]]]}},
            {"type": "Feature", "properties": {"name": "South"}, "geometry": {"type": "Polygon", "coordinates":
              [[[22.5, 58.24], [22.503, 58.24], [22.503, 58.242], [22.5, 58.242], [22.5, 58.24]]]}}]})");
        file.close();
        session_->opener()->open(path);
        QTRY_VERIFY(item(QStringLiteral("fieldChooser"))->isVisible());
        picture(QStringLiteral("chooser"));
        click(QStringLiteral("chooser.field.1"));
        QTRY_COMPARE(session_->planning()->state(), PlanState::Ready);
        QCOMPARE(session_->farm()->fieldName(), QStringLiteral("South"));
    }
    void filesAreDroppedOnTheMap() {
        const QTemporaryDir folder;
        QMimeData dropped;
        QList<QUrl> urls;
        for (const char* name : {"North", "South"}) {
            QFile file{folder.filePath(QStringLiteral("%1.geojson").arg(QLatin1String{name}))};
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(
                QStringLiteral(
                    R"({"type": "Feature", "properties": {"name": "%1"}, "geometry": {"type": "Polygon", "coordinates":
                [[[22.5, 58.25], [22.503, 58.25], [22.503, 58.252], [22.5, 58.252], [22.5, 58.25]]]}})")
                    .arg(QLatin1String{name})
                    .toUtf8());
            urls << QUrl::fromLocalFile(file.fileName());
        }
        dropped.setUrls(urls);
        const QPoint at = middleOf(*map()) + QPoint{250, 250};
        QDragEnterEvent enter{at, Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier};
        QCoreApplication::sendEvent(window_, &enter);
        QVERIFY(enter.isAccepted());
        picture(QStringLiteral("drop"));
        QDropEvent drop{QPointF{at}, Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier};
        QCoreApplication::sendEvent(window_, &drop);
        QTRY_COMPARE(session_->farm()->fields().size(), 2);
        QTRY_VERIFY_WITH_TIMEOUT(isFinished(session_->planning()->state()), kPatienceMs);
        QCOMPARE(session_->farm()->fieldName(), QStringLiteral("North"));
    }
    void theProblemOfABoundaryIsTold() {
        session_->opener()->addDrawn({{58.25, 22.5}, {58.2535, 22.507}, {58.25, 22.507}, {58.2535, 22.5}});
        QTRY_VERIFY(item(QStringLiteral("problemCard"))->isVisible());
        picture(QStringLiteral("failed"));
    }
    /// Prints how evenly frames come while the headland of a 64 ha field is dragged; how fast is not for a
    /// test.
    void draggingTheHeadlandKeepsDrawing_data() {
        QTest::addColumn<double>("widthM");
        QTest::newRow("12 m") << 12.0;
        QTest::newRow("2.5 m") << 2.5;
    }
    void draggingTheHeadlandKeepsDrawing() {
        QFETCH(double, widthM);
        session_->planning()->machine()->setNumber(0, widthM);
        session_->opener()->addDrawn({{58.25, 22.5}, {58.25, 22.5136}, {58.2572, 22.5136}, {58.2572, 22.5}});
        QTRY_COMPARE_WITH_TIMEOUT(session_->planning()->state(), PlanState::Ready, kPatienceMs);
        click(QStringLiteral("step.headland"));
        QTRY_VERIFY(item(QStringLiteral("headland.width_m.slider")) != nullptr);
        QQuickItem* slider = item(QStringLiteral("headland.width_m.slider"));
        QTRY_VERIFY(slider->isVisible());
        waitForRest(*slider);
        QSignalSpy plans{session_->shown(), &ShownPlan::planChanged};
        const QPoint left = slider->mapToScene({12.0, slider->height() / 2.0}).toPoint();
        QTest::mousePress(window_, Qt::LeftButton, {}, left);
        FrameClock frames{*window_};
        for (int i = 0; i < 120; ++i) {
            frames.move(left + QPoint{20 + i, 0});
        }
        qInfo("%zu swaths, %zu segments, %lld plans; %s", session_->shown()->plan()->swaths.swaths.size(),
              session_->shown()->plan()->path.segments.size(), static_cast<long long>(plans.count()),
              qPrintable(frames.text()));
        QTest::mouseRelease(window_, Qt::LeftButton, {}, left + QPoint{139, 0});
        QVERIFY(frames.frames() > 0);
        QTRY_VERIFY_WITH_TIMEOUT(plans.count() > 0, kPatienceMs);
        QTRY_COMPARE_WITH_TIMEOUT(session_->planning()->state(), PlanState::Ready, kPatienceMs);

        // Panning alone, in processor time of all threads: a busy computer does not disturb that.
        constexpr int kFrames = 60;
        const std::clock_t begin = std::clock();
        for (int i = 0; i < kFrames; ++i) {
            NextFrame frame{*window_};
            camera()->panBy(i % 2 == 0 ? 7.0 : -6.0, 3.0);
            QVERIFY(frame.wait());
        }
        qInfo("panning: %.1f ms of processor time a frame",
              1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / kFrames);
    }
};

FURROW_TEST_WITH(TestWindow, QGuiApplication);
#include "tst_window.moc"
