#include "planner/plan/method_registry.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/editor_window_test.h"
#include "ui/text/display.h"

using namespace furrow;

/// The guide in the window, and its pictures, which are made here from the program itself.
class TestGuideWindow : public test::EditorWindowTest {
    Q_OBJECT

private:
    QString title() const { return item(QStringLiteral("guide.title"))->property("text").toString(); }
    /// A part of the window for the guide. Written to the guide where that is asked for, otherwise compared
    /// in its size: a picture of another window would be of another.
    void guidePicture(const QString& name, const QRect& part) {
        const QImage image = window_->grabWindow().copy(part);
        const QString file = QStringLiteral(FURROW_SOURCE_DIR "/resources/guide/pictures/%1.png").arg(name);
        if (qEnvironmentVariableIsSet("FURROW_WRITE_GUIDE")) {
            QVERIFY(image.convertToFormat(QImage::Format_RGB888).save(file, "PNG", 0));
        } else {
            const QImage stored{file};
            QVERIFY2(!stored.isNull(), qPrintable(file));
            QCOMPARE(stored.size(), image.size());
        }
    }
    QRect partOf(const QString& name) const {
        const QQuickItem* of = item(name);
        return QRectF{of->mapToScene({}), of->size()}.toRect() & QRect{QPoint{}, window_->size()};
    }
    void openStep(const QString& step) {
        if (!item(QStringLiteral("stepsPanel"))->property("openStep").toString().contains(step)) {
            click(QStringLiteral("step.") + step);
        }
        bringIntoView(QStringLiteral("step.") + step);
        QTest::mouseMove(window_, middle());
    }

private slots:
    void isReadSearchedAndFollowed() {
        QVERIFY(!shows(QStringLiteral("guidePanel")));
        key(Qt::Key_F1);
        QTRY_VERIFY(shows(QStringLiteral("guidePanel")));
        QTRY_VERIFY(item(QStringLiteral("guide.search"))->hasActiveFocus());
        QVERIFY(shows(QStringLiteral("guide.line.8")) && !shows(QStringLiteral("guide.line.9")));
        picture(QStringLiteral("guide_chapters"));
        type(QStringLiteral("fishtail"));
        picture(QStringLiteral("guide_search"));
        QTRY_VERIFY(shows(QStringLiteral("guide.line.0")) &&
                    item(QStringLiteral("guide.line.0"))
                        ->property("caption")
                        .toString()
                        .contains(QStringLiteral("fishtail"), Qt::CaseInsensitive));
        picture(QStringLiteral("guide_search"));
        click(QStringLiteral("guide.line.0"));
        QTRY_VERIFY(shows(QStringLiteral("guide.block.0")) || shows(QStringLiteral("guide.block.1")));
        QVERIFY(title() != QStringLiteral("Guide"));
        // At the place that was found, far down.
        QTRY_VERIFY(item(QStringLiteral("guide.scroller"))->property("contentY").toDouble() > 2000.0);
        picture(QStringLiteral("guide_found"));
        // Back to the chapters, then out.
        key(Qt::Key_Escape);
        QTRY_COMPARE(title(), QStringLiteral("Guide"));
        item(QStringLiteral("guide.search"))->forceActiveFocus(Qt::TabFocusReason);
        key(Qt::Key_A, Qt::ControlModifier);
        key(Qt::Key_Delete);
        click(QStringLiteral("guide.line.0"));
        QTRY_VERIFY(shows(QStringLiteral("guide.block.0")));
        picture(QStringLiteral("guide_first"));
        // In the language of the window at once.
        furrow::Display::instance().setLanguage(QStringLiteral("de"));
        QTRY_VERIFY(title() != QStringLiteral("The first plan in five minutes"));
        picture(QStringLiteral("guide_de"));
        furrow::Display::instance().setLanguage({});
        key(Qt::Key_Escape);
        key(Qt::Key_Escape);
        QTRY_VERIFY(!shows(QStringLiteral("guidePanel")));
    }
    void theSearchOfCommandsFindsPagesFieldsAndFindings() {
        DRAW_FIELD();
        const auto find = [this](const QString& words) {
            key(Qt::Key_K, Qt::ControlModifier);
            QTRY_VERIFY(item(QStringLiteral("palette.field"))->hasActiveFocus());
            type(words);
            QTRY_VERIFY(shows(QStringLiteral("palette.row.0")));
        };
        find(QStringLiteral("first plan in five"));
        key(Qt::Key_Return);
        QTRY_COMPARE(title(), QStringLiteral("The first plan in five minutes"));
        find(QStringLiteral("about furrow"));
        key(Qt::Key_Return);
        QTRY_VERIFY(shows(QStringLiteral("about.licence")));
        picture(QStringLiteral("about"));
        key(Qt::Key_Escape);
        QTRY_VERIFY(!shows(QStringLiteral("about.licence")));
        // Commands of similar names may stand above it.
        const auto rowOf = [this](const QString& text) {
            for (int row = 0; row < 9; ++row) {
                const QQuickItem* each = item(QStringLiteral("palette.row.%1").arg(row));
                if (each != nullptr && each->property("text").toString() == text) {
                    return QStringLiteral("palette.row.%1").arg(row);
                }
            }
            return QString{};
        };
        find(session_->farm()->fieldName());
        QTRY_VERIFY_WITH_TIMEOUT(!rowOf(session_->farm()->fields().first()).isEmpty(), 5000);
        picture(QStringLiteral("palette_field"));
        key(Qt::Key_Escape);
        QTRY_VERIFY(!shows(QStringLiteral("palette.row.0")));
        // A finding is gone to.
        QVERIFY(session_->findings()->count() > 0);
        const QString finding = session_->findings()->texts().first();
        find(finding.left(30));
        QTRY_VERIFY_WITH_TIMEOUT(!rowOf(finding).isEmpty(), 5000);
        click(rowOf(finding));
        QTRY_COMPARE(editor()->selectedFinding(), 0);
    }
    void whatIsCalledJustSoComesFirst() {
        DRAW_FIELD();
        for (const auto& [words, first] :
             {std::pair{QStringLiteral("first swath"), QStringLiteral("First swath")},
              {QStringLiteral("passes"), QStringLiteral("Passes")},
              {QStringLiteral("change the order by hand..."), QStringLiteral("Change the order by hand…")},
              {QStringLiteral("plan ag"), QStringLiteral("Plan again")},
              {QStringLiteral("drive slow"), QStringLiteral("Drive slower")}}) {
            key(Qt::Key_K, Qt::ControlModifier);
            QTRY_VERIFY(item(QStringLiteral("palette.field"))->hasActiveFocus());
            type(words);
            QTRY_VERIFY(shows(QStringLiteral("palette.row.0")));
            QTRY_COMPARE(item(QStringLiteral("palette.row.0"))->property("text").toString(), first);
            key(Qt::Key_Escape);
            QTRY_VERIFY(!shows(QStringLiteral("palette.field")));
        }
        // It leads to the list of the swaths.
        key(Qt::Key_K, Qt::ControlModifier);
        type(QStringLiteral("order by hand"));
        QTRY_VERIFY(shows(QStringLiteral("palette.row.0")));
        key(Qt::Key_Return);
        QTRY_VERIFY(shows(QStringLiteral("order.list")));
    }
    void aSampleIsFoundBeforeThereIsAField() {
        key(Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(item(QStringLiteral("palette.field"))->hasActiveFocus());
        type(QStringLiteral("long strip"));
        QTRY_VERIFY(shows(QStringLiteral("palette.row.0")));
        key(Qt::Key_Return);
        QTRY_COMPARE(session_->farm()->fieldName(), QStringLiteral("Long Strip"));
    }
    void aMachineAndAMethodAreTakenByTheirNames() {
        DRAW_FIELD();
        const auto take = [this](const QString& words) {
            key(Qt::Key_K, Qt::ControlModifier);
            QTRY_VERIFY(item(QStringLiteral("palette.field"))->hasActiveFocus());
            type(words);
            QTRY_VERIFY(shows(QStringLiteral("palette.row.0")));
            key(Qt::Key_Return);
            QTRY_VERIFY(!shows(QStringLiteral("palette.field")));
        };
        take(QStringLiteral("field robot"));
        QTRY_VERIFY(session_->planning()->machine()->name().startsWith(QStringLiteral("Field robot")));
        // At once, while the step of the machine opens.
        take(QStringLiteral("no headland"));
        QTRY_COMPARE(session_->planning()->settings().choice(**furrow::findParameter("headland.method")),
                     "none");
        // Both are undone like any other change.
        key(Qt::Key_Z, Qt::ControlModifier);
        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(!session_->planning()->machine()->name().startsWith(QStringLiteral("Field robot")));
    }
    void aPointerAtRestChoosesNoRow() {
        const auto highlighted = [this](int row) {
            return item(QStringLiteral("palette.row.%1").arg(row))->property("highlighted").toBool();
        };
        key(Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(shows(QStringLiteral("palette.row.6")));
        const QQuickItem& sixth = *item(QStringLiteral("palette.row.6"));
        const QPoint there = sixth.mapToScene({40.0, 18.0}).toPoint();
        key(Qt::Key_Escape);
        QTRY_VERIFY(!shows(QStringLiteral("palette.field")));
        QTest::mouseMove(window_, there);
        key(Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(shows(QStringLiteral("palette.row.6")));
        waitForRest(*item(QStringLiteral("palette.row.6")));
        QVERIFY(highlighted(0) && !highlighted(6));
        QTest::mouseMove(window_, there + QPoint{3, 1});
        QTest::mouseMove(window_, there + QPoint{6, 2});
        QTRY_VERIFY(highlighted(6));
        key(Qt::Key_Escape);
        QTRY_VERIFY(!shows(QStringLiteral("palette.field")));
    }
    void coordinatesAreGoneTo() {
        QVERIFY(!shows(QStringLiteral("palette.field")));
        QTRY_VERIFY(shows(QStringLiteral("emptyState")));
        QVERIFY(QMetaObject::invokeMethod(window_->findChild<QObject*>(QStringLiteral("command.place")),
                                          "trigger"));
        QTRY_VERIFY(item(QStringLiteral("palette.field"))->hasActiveFocus());
        // Nothing is listed that Return might do before a place is typed.
        QVERIFY(!shows(QStringLiteral("palette.row.0")));
        type(QStringLiteral("47,5 N 8,25 E"));
        QTRY_COMPARE(item(QStringLiteral("palette.row.0"))->property("text").toString(),
                     QStringLiteral("Go to 47.500000° N, 8.250000° E"));
        picture(QStringLiteral("palette_place"));
        key(Qt::Key_Return);
        QTRY_VERIFY(camera()->center().distanceTo(QGeoCoordinate{47.5, 8.25}) < 1.0);
        QTRY_COMPARE(camera()->zoomLevel(), 16.0);
        // What there is to begin with does not cover it, until a field came and went.
        QTRY_VERIFY(!shows(QStringLiteral("emptyState")));
        session_->opener()->openSample(0);
        QTRY_VERIFY_WITH_TIMEOUT(session_->farm()->hasField(), kPatienceMs);
        session_->farm()->removeField();
        QTRY_VERIFY(shows(QStringLiteral("emptyState")));
        // No place on Earth.
        key(Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(item(QStringLiteral("palette.field"))->hasActiveFocus());
        type(QStringLiteral("97.5, 8.25"));
        QVERIFY(!shows(QStringLiteral("palette.row.0")));
        key(Qt::Key_Escape);
        QTRY_VERIFY(!shows(QStringLiteral("palette.field")));
    }
    void pictures() {
        openSample(QStringLiteral("Home Field"));
        QTest::mouseMove(window_, middle());
        const QRect panel = partOf(QStringLiteral("stepsPanel"));
        const QRect steps{panel.topLeft(), QSize{panel.width(), 560}};
        guidePicture(QStringLiteral("plan"), {{}, window_->size()});
        openStep(QStringLiteral("field"));
        guidePicture(QStringLiteral("field"), steps);
        for (const char* step : {"machine", "headland", "swaths", "route"}) {
            openStep(QLatin1String{step});
            guidePicture(QLatin1String{step}, steps);
        }
        key(Qt::Key_L, Qt::ControlModifier);
        QTRY_VERIFY(shows(QStringLiteral("layerSwitches")));
        waitForRest(*item(QStringLiteral("layerSwitches")));
        guidePicture(QStringLiteral("layers"), partOf(QStringLiteral("mapPage")));
        key(Qt::Key_L, Qt::ControlModifier);
        QTRY_VERIFY(!shows(QStringLiteral("layerSwitches")));
        session_->drive()->setTime(session_->drive()->duration() * 0.55);
        QTRY_VERIFY(session_->drive()->isUnderWay());
        guidePicture(QStringLiteral("drive"),
                     partOf(QStringLiteral("mapPage")).united(partOf(QStringLiteral("driveBar"))));
        session_->drive()->setTime(0.0);
        key(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(shows(QStringLiteral("farmPanel")));
        guidePicture(QStringLiteral("farm"), {{}, window_->size()});
        key(Qt::Key_Escape);
    }
    void pictureOfFindings() {
        openSample(QStringLiteral("Three Ponds"));
        QTRY_VERIFY(session_->findings()->count() > 0);
        click(QStringLiteral("step.check"));
        QTRY_VERIFY(shows(QStringLiteral("finding.0")));
        waitForRest(*item(QStringLiteral("finding.0")));
        QTest::mouseMove(window_, middle());
        guidePicture(QStringLiteral("findings"), {{}, window_->size()});
    }
};

FURROW_TEST_WITH(TestGuideWindow, QGuiApplication);
#include "tst_guide_window.moc"
