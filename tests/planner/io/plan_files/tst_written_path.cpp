// A plan's files read back: the path to the last bit, and every way in which files can be wrong.

#include "planner/io/delivery/plan_folder.h"
#include "planner/io/formats/csv/path_csv.h"
#include "planner/io/import/boundary_import.h"
#include "planner/io/plan_files/written_path.h"
#include "planner/machine/machine_library.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace furrow;

namespace {

std::shared_ptr<const Plan> samplePlan() {
    const auto sources = readBoundaries(FURROW_SOURCE_DIR "/resources/sample_fields/home_field.geojson");
    auto field = Field::create(sources.value().front());
    return makePlan({.field = std::make_shared<const Field>(std::move(field.value())),
                     .machine = machineLibrary().front(),
                     .settings = {}})
        .value();
}

void replace(const QTemporaryDir& folder, const char* name, const QByteArray& text) {
    QFile file{folder.filePath(name)};
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text);
}

constexpr char kHeader[] =
    "s_m,t_s,x_m,y_m,lon_deg,lat_deg,heading_rad,curvature_1pm,speed_mps,gear,implement_down,segment,order,"
    "machine,"
    "level\n";

}  // namespace

class WrittenPathTest : public QObject {
    Q_OBJECT

private slots:
    void thePathComesBackToTheLastBit() {
        const auto plan = samplePlan();
        const auto path = readPathCsv(pathCsv(*plan), "path.csv");
        VERIFY_RESULT(path);
        QCOMPARE(path->segments.size(), plan->path.segments.size());
        for (std::size_t i = 0; i < path->segments.size(); ++i) {
            const PathSegment& read = path->segments[i];
            const PathSegment& made = plan->path.segments[i];
            QVERIFY(read.samples == made.samples);
            QVERIFY(read.kind == made.kind && read.gear == made.gear &&
                    read.implementDown == made.implementDown);
        }
    }

    void thePlanComesBack() {
        const auto plan = samplePlan();
        const QTemporaryDir folder;
        VERIFY_RESULT(writePlanFolder(*plan, folder.path().toStdString(), standardPlanFormats()));
        const auto read = readWrittenPath(folder.path().toStdString());
        VERIFY_RESULT(read);
        QVERIFY(read->frame == plan->field().frame());
        QCOMPARE(read->name, plan->field().name());
        QCOMPARE(read->operatingWidth.si(), plan->request.machine.operatingWidth().si());
        COMPARE_WITHIN(area(read->field).si(), plan->field().area().si(), 1.0);
        QVERIFY(QFile::remove(folder.filePath("plan.geojson")));
        VERIFY_RESULT(readWrittenPath(folder.path().toStdString()));
    }

    void damagedPaths_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("part");
        const QByteArray header{kHeader};
        const QByteArray row{"0,0,1,2,5,52,0,0,2,1,1,swath,0,0,\n"};
        QTest::newRow("empty") << QByteArray{} << "line 1: there is no column s_m";
        QTest::newRow("no rows") << header << "no path";
        QTest::newRow("one row") << header + row << "one sample";
        QTest::newRow("another table") << QByteArray{"lon,lat\n5,52\n"} << "no column";
        QTest::newRow("cut off") << header + row + "1,0,1" << "line 3: y_m is ''";
        QTest::newRow("NaN") << header + row + "nan,0,1,2,5,52,0,0,2,1,1,swath,0,0,\n"
                             << "line 3: s_m is 'nan'";
        QTest::newRow("far away") << header + row + "1,1,1,-2e15,5,52,0,0,2,1,1,swath,0,0,\n"
                                  << "line 3: y_m is '-2e15'";
        QTest::newRow("kind") << header + "0,0,1,2,5,52,0,0,2,1,1,flight,0,0,\n" << "'flight' is no kind";
    }
    void damagedPaths() {
        QFETCH(QByteArray, text);
        QFETCH(QString, part);
        const auto path = readPathCsv(text.toStdString(), "path.csv");
        QVERIFY(!path);
        QVERIFY2(path.error().line().find(part.toStdString()) != std::string::npos,
                 path.error().line().c_str());
    }

    void damagedFolders_data() {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<bool>("readFailed");
        QTest::newRow("summary is no JSON") << QByteArray{"summary.json"} << QByteArray{"{"} << false;
        QTest::newRow("summary is another JSON") << QByteArray{"summary.json"} << QByteArray{"[1]"} << false;
        QTest::newRow("no frame") << QByteArray{"summary.json"}
                                  << QByteArray{R"({"crs":"x","field":{},"machine":{"operating_width_m":2}})"}
                                  << false;
        QTest::newRow("no width") << QByteArray{"summary.json"}
                                  << QByteArray{R"({"crs":"+lat_0=1 +lon_0=2","field":{},"machine":{}})"}
                                  << false;
        QTest::newRow("width of zero")
            << QByteArray{"summary.json"}
            << QByteArray{R"({"crs":"+lat_0=1 +lon_0=2","field":{},"machine":{"operating_width_m":0}})"}
            << false;
        QTest::newRow("path is empty") << QByteArray{"path.csv"} << QByteArray{} << false;
        QTest::newRow("outlines are no GeoJSON")
            << QByteArray{"plan.geojson"} << QByteArray{"{\"a\":1}"} << false;
        QTest::newRow("nothing there") << QByteArray{} << QByteArray{} << true;
    }
    void damagedFolders() {
        QFETCH(QByteArray, file);
        QFETCH(QByteArray, text);
        QFETCH(bool, readFailed);
        const QTemporaryDir folder;
        if (!readFailed) {
            VERIFY_RESULT(writePlanFolder(*samplePlan(), folder.path().toStdString(), standardPlanFormats()));
            replace(folder, file.constData(), text);
        }
        const auto read = readWrittenPath(folder.path().toStdString());
        QVERIFY(!read);
        QCOMPARE(read.error().code, readFailed ? ErrorCode::ReadFailed : ErrorCode::InputRefused);
        QVERIFY(!read.error().remedy.empty() && !read.error().where.empty());
    }
};

FURROW_TEST(WrittenPathTest);
#include "tst_written_path.moc"
