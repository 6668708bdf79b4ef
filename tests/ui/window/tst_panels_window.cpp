#include "tests/planner/imagery/raster_samples.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/editor_window_test.h"
#include "ui/text/display.h"

#include <QFile>
#include <QTemporaryDir>

#include <cmath>

using namespace furrow;
using namespace furrow::test;

/// Every panel, dialog and notice fits into the window. With FURROW_PICTURES set they are opened in every
/// size, theme and some languages, for people to look at the pictures.
class TestPanelsWindow : public EditorWindowTest {
    Q_OBJECT

    QString name_;

    QObject* found(const char* name) const {
        return engine_->rootObjects().first()->findChild<QObject*>(QLatin1String{name});
    }
    void shot(const char* what) { picture(QStringLiteral("panel-%1-%2").arg(QLatin1String{what}, name_)); }
    /// Opens a dialog by a command, takes its picture, and closes it.
    void dialog(const char* command, const char* name) {
        QVERIFY(QMetaObject::invokeMethod(found(command), "trigger"));
        QObject* dialog = found(name);
        QVERIFY2(dialog != nullptr, name);
        QTRY_VERIFY2(dialog->property("opened").toBool(), name);
        QTRY_COMPARE(dialog->property("opacity").toDouble(), 1.0);
        const QRectF place{dialog->property("x").toDouble(), dialog->property("y").toDouble(),
                           dialog->property("width").toDouble(), dialog->property("height").toDouble()};
        QVERIFY2(QRectF(0.0, 0.0, window_->width(), window_->height()).contains(place), name);
        shot(name);
        QMetaObject::invokeMethod(dialog, "close");
        QTRY_VERIFY2(!dialog->property("visible").toBool(), name);
    }
    void isInside(const char* name) const {
        const QQuickItem* shown = item(QLatin1String{name});
        QVERIFY2(shown != nullptr && shown->isVisible(), name);
        const QRectF place = shown->mapRectToScene(QRectF{0.0, 0.0, shown->width(), shown->height()});
        QVERIFY2(QRectF(0.0, 0.0, window_->width(), window_->height()).contains(place), name);
    }

    /// Three layers: a picture, heights, and one whose file is gone.
    void layersPanel(const QTemporaryDir& folder) {
        const auto raster = [&folder](const char* name, int bands, GDALDataType type,
                                      const std::function<double(int, int, int)>& value) {
            return writeTiff(folder.filePath(QLatin1String{name}),
                             {.width = 300,
                              .height = 300,
                              .epsg = 4326,
                              .affine = {22.499, 3e-5, 0.0, 58.2545, 0.0, -2e-5},
                              .type = type},
                             bands, value);
        };
        const auto colour = [](int band, int x, int y) {
            return 60.0 + 40.0 * band + (x / 20 + y / 20) % 2 * 30.0;
        };
        QVERIFY(raster("Aerial photo May 2026.tif", 3, GDT_Byte, colour) &&
                raster("gone.tif", 3, GDT_Byte, colour) &&
                raster("heights.tif", 1, GDT_Float32,
                       [](int, int x, int y) { return 20.0 * std::sin(x / 60.0) + y / 20.0; }));
        session_->imagery()->add({folder.filePath(QStringLiteral("heights.tif")),
                                  folder.filePath(QStringLiteral("gone.tif")),
                                  folder.filePath(QStringLiteral("Aerial photo May 2026.tif"))});
        QTRY_COMPARE(session_->imagery()->count(), 3);
        QVERIFY(QFile::remove(folder.filePath(QStringLiteral("gone.tif"))));
        QTRY_VERIFY(session_->imagery()
                        ->data(session_->imagery()->index(1), ImageryModel::StateRole)
                        .value<ImageryModel::State>() == ImageryModel::State::Failed);
        click(QStringLiteral("layersTool"));
        QTRY_VERIFY(shows(QStringLiteral("layersPanel")));
        QTRY_VERIFY(session_->imagery()->store().isIdle());
        isInside("layersPanel");
        shot("layers");
    }
    /// Something that is no layer.
    void imageryNotice(const QTemporaryDir& folder) {
        QFile file{folder.filePath(QStringLiteral("broken.mbtiles"))};
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("no tiles") > 0);
        file.close();
        session_->imagery()->add({file.fileName()});
        QTRY_VERIFY(shows(QStringLiteral("imageryNotice")));
        isInside("imageryNotice");
        shot("imagery-notice");
        session_->imagery()->dismiss();
        key(Qt::Key_L, Qt::ControlModifier);
    }
    void dialogs() {
        dialog("command.keys", "keysDialog");
        dialog("command.preferences", "preferencesDialog");
        dialog("command.palette", "commandPalette");
        dialog("command.addPlan", "nameDialog");
        dialog("command.export", "exportDialog");
        dialog("command.new", "unsavedDialog");
    }
    /// A boundary that cannot be planned with.
    void problemCard() {
        session_->opener()->addDrawn({{58.25, 22.5}, {58.2535, 22.507}, {58.25, 22.507}, {58.2535, 22.5}});
        QTRY_VERIFY(shows(QStringLiteral("problemCard")));
        isInside("problemCard");
        shot("problem");
        key(Qt::Key_Z, Qt::ControlModifier);
        ready();
    }
    void tour() {
        QVERIFY(QMetaObject::invokeMethod(found("command.tour"), "trigger"));
        QTRY_VERIFY(shows(QStringLiteral("tour.card")));
        isInside("tour.card");
        shot("tour");
        click(QStringLiteral("tour.leave"));
        QTRY_VERIFY(!shows(QStringLiteral("tour.card")));
    }

private slots:
    void panels_data() {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<int>("colours");
        QTest::addColumn<QString>("language");
        const auto row = [](const char* name, QSize size, int colours, const char* language = "en") {
            QTest::newRow(name) << size << colours << QString::fromLatin1(language);
        };
        row("1000-dark", {1000, 700}, 2);
        if (!qEnvironmentVariableIsSet("FURROW_PICTURES")) {
            return;
        }
        row("1000-light-de", {1000, 700}, 1, "de");
        row("1000-sunlight-fr", {1000, 700}, 3, "fr");
        row("1440-dark", {1440, 900}, 2);
        row("1440-light", {1440, 900}, 1);
        row("1920-sunlight", {1920, 1200}, 3);
    }
    void panels() {
        QFETCH(QSize, size);
        QFETCH(int, colours);
        QFETCH(QString, language);
        name_ = QString::fromUtf8(QTest::currentDataTag());
        furrow::Display::instance().force(language, furrow::Display::Metric);
        end();
        begin(size);
        engine_->singletonInstance<QObject*>("Furrow.Controls", "Theme")->setProperty("forced", colours);
        DRAW_FIELD();
        const QTemporaryDir folder;
        layersPanel(folder);
        if (QTest::currentTestFailed()) {
            return;
        }
        imageryNotice(folder);
        if (QTest::currentTestFailed()) {
            return;
        }
        dialogs();
        if (QTest::currentTestFailed()) {
            return;
        }
        problemCard();
        if (QTest::currentTestFailed()) {
            return;
        }
        tour();
        if (QTest::currentTestFailed()) {
            return;
        }
        furrow::Display::instance().force(QStringLiteral("en"), furrow::Display::Metric);
    }
};

FURROW_TEST_WITH(TestPanelsWindow, QGuiApplication);
#include "tst_panels_window.moc"
