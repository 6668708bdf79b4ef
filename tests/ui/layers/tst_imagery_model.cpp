#include "planner/project/project_edits.h"
#include "tests/planner/imagery/raster_samples.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "ui/layers/imagery_model.h"

#include <QAbstractItemModelTester>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace furrow;
using namespace furrow::test;

class TestImageryModel : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QStringList paths_;

    static QStringList names(const ImageryModel& model) {
        QStringList names;
        for (int row = 0; row < model.rowCount(); ++row) {
            names << model.data(model.index(row), ImageryModel::NameRole).toString();
        }
        return names;
    }
    static ImageryModel::State state(const ImageryModel& model, int row) {
        return model.data(model.index(row), ImageryModel::StateRole).value<ImageryModel::State>();
    }

private slots:
    void initTestCase() {
        for (const char* name : {"a", "b", "c"}) {
            paths_ << folder_.filePath(QStringLiteral("%1.tif").arg(QLatin1String{name}));
            QVERIFY(writeTiff(
                paths_.back(),
                {.width = 300, .height = 300, .epsg = 4326, .affine = {5.0, 1e-5, 0.0, 52.0, 0.0, -1e-5}}, 3,
                [](int band, int x, int) { return 40.0 * band + x % 100; }));
        }
    }
    void layersAreAddedOrderedAndUndone() {
        Document document;
        ImageryModel model{document};
        const QAbstractItemModelTester tester{&model};
        QSignalSpy added{&model, &ImageryModel::added};
        model.add(paths_);
        QTRY_COMPARE(model.count(), 3);
        // Topmost first: the last one that was added.
        QCOMPARE(names(model), (QStringList{"c", "b", "a"}));
        for (int row = 0; row < 3; ++row) {
            QTRY_COMPARE(state(model, row), ImageryModel::State::Ready);
        }
        QTRY_VERIFY(added.count() == 3);
        model.move(0, 1);
        QCOMPARE(names(model), (QStringList{"b", "c", "a"}));
        model.move(2, -1);
        QCOMPARE(names(model), (QStringList{"b", "a", "c"}));
        model.move(0, -1);
        QCOMPARE(names(model), (QStringList{"b", "a", "c"}));
        // Lowest first, as they are drawn.
        QCOMPARE(model.sheets().size(), std::size_t{3});
        model.show(1, false);
        QCOMPARE(model.sheets().size(), std::size_t{2});
        model.remove(1);
        QCOMPARE(names(model), (QStringList{"b", "c"}));
        model.rename(1, QStringLiteral("  Photo of May "));
        QCOMPARE(names(model), (QStringList{"b", "Photo of May"}));
        for (int i = 0; i < 5; ++i) {
            document.undo();
        }
        QCOMPARE(names(model), (QStringList{"c", "b", "a"}));
        document.undo();
        QCOMPARE(model.count(), 0);
        for (int i = 0; i < 6; ++i) {
            document.redo();
        }
        QCOMPARE(names(model), (QStringList{"b", "Photo of May"}));
    }
    void whatIsAddedWhileOthersAreLookedAtIsNotLost() {
        Document document;
        ImageryModel model{document};
        model.add({paths_[0]});
        model.add({paths_[1], paths_[2]});
        QTRY_COMPARE(model.count(), 3);
        QCOMPARE(names(model), (QStringList{"c", "b", "a"}));
        // Nothing of it comes a second time.
        model.add({paths_[0]});
        QTRY_COMPARE(model.count(), 4);
    }
    void aDraggedSliderIsOneChange() {
        Document document;
        ImageryModel model{document};
        model.add({paths_[0]});
        QTRY_COMPARE(model.count(), 1);
        for (const double strength : {0.9, 0.7, 0.5}) {
            model.setOpacity(0, strength, true);
        }
        model.setOpacity(0, 0.5, false);
        QCOMPARE(model.data(model.index(0), ImageryModel::OpacityRole).toDouble(), 0.5);
        document.undo();
        QCOMPARE(model.data(model.index(0), ImageryModel::OpacityRole).toDouble(), 1.0);
        document.undo();
        QCOMPARE(model.count(), 0);
    }
    void goodOnesAreAddedAndTheFirstBadOneIsTold() {
        Document document;
        ImageryModel model{document};
        QSignalSpy told{&model, &ImageryModel::messageChanged};
        model.add({folder_.filePath(QStringLiteral("gone.tif")), paths_[1]});
        QTRY_COMPARE(model.count(), 1);
        QCOMPARE(model.message(), QStringLiteral("gone.tif: There is no such file or folder"));
        QVERIFY(!model.remedy().isEmpty());
        model.dismiss();
        QVERIFY(model.message().isEmpty());
        QCOMPARE(told.count(), 2);
    }
    void tilesAreKeptInBoundedMemory() {
        Document document;
        ImageryModel model{document};
        model.add({paths_[0]});
        QTRY_COMPARE(model.count(), 1);
        QTRY_COMPARE(state(model, 0), ImageryModel::State::Ready);
        TileStore& store = model.store();
        const int sheet = model.sheets().front().number;
        const int zoom = store.imagery(sheet)->facts().finestZoom;
        const TilePlace place = tilePlace(5.0015, 51.9985, zoom);
        // Far more tiles than are kept, most of them beside the raster.
        for (int i = 0; i < 40; ++i) {
            std::vector<TileKey> keys;
            for (int k = 0; k < 20; ++k) {
                keys.push_back({sheet, {zoom, place.column() - 3 + k % 6, place.row() - 3 + k / 6 + i % 3}});
            }
            store.want(keys, keys.size());
            QTRY_VERIFY(store.isIdle());
        }
        QVERIFY(store.keptBytes() > 0);
        QVERIFY2(store.keptBytes() <= qsizetype{48} << 20, qPrintable(QString::number(store.keptBytes())));
        model.remove(0);
        QCOMPARE(store.keptBytes(), 0);
    }
};

FURROW_TEST(TestImageryModel);
#include "tst_imagery_model.moc"
