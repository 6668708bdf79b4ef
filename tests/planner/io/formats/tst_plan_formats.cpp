#include "planner/io/content/plan_content.h"
#include "planner/io/delivery/plan_folder.h"
#include "planner/io/delivery/terminals.h"
#include "planner/io/formats/registry.h"
#include "tests/planner/io/format_cases.h"
#include "tests/planner/io/formats/written_plan.h"
#include "tests/support/geo_rings.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include "path_message.pb.h"

#include <QDirIterator>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <set>

using namespace furrow;
using namespace furrow::test;

/// What the files of a plan hold, format by format and terminal by terminal.
class PlanFormatsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        VERIFY_RESULT(writtenPlan().result);
        QVERIFY(pathReverses());
    }

    void everyFileIsThereOnce() {
        std::set<std::filesystem::path> files;
        for (const auto& file : writtenPlan().result->files) {
            QVERIFY2(std::filesystem::is_regular_file(file), file.c_str());
            QVERIFY2(files.insert(file).second, file.c_str());
        }
        QDirIterator left{writtenPlan().folder.path(), {"*.part"}, QDir::Files, QDirIterator::Subdirectories};
        QVERIFY(!left.hasNext());
    }

    void missionFollowsThePath() {
        const QList<QByteArray> lines = writtenPlan().text("plan.waypoints").split('\n');
        QCOMPARE(lines[0], "QGC WPL 110");
        int reversed = 0;
        GeoPoint lastSeen;
        for (qsizetype i = 1; i + 1 < lines.size(); ++i) {
            const QList<QByteArray> columns = lines[i].split('\t');
            QCOMPARE(columns.size(), 12);
            QCOMPARE(columns[0].toInt(), static_cast<int>(i - 1));
            QCOMPARE(columns[2].toInt(), i == 1 ? 0 : 3);
            reversed += columns[3] == "194" && columns[4].toDouble() == 1.0 ? 1 : 0;
            if (columns[3] == "16") {
                lastSeen = {columns[9].toDouble(), columns[8].toDouble()};
                if (i == 1) {
                    QVERIFY(metresBetween(lastSeen, firstPlace()) < 0.002);
                }
            }
        }
        QVERIFY(metresBetween(lastSeen, lastPlace()) < 0.002);
        QVERIFY(reversed > 0);
        const QJsonObject file = QJsonDocument::fromJson(writtenPlan().text("plan.plan")).object();
        QCOMPARE(file["fileType"].toString(), "Plan");
        QCOMPARE(file["mission"]["items"].toArray().size() + 3,
                 lines.size());  // header, home, and what follows the last end
        const QJsonArray fences = file["geoFence"]["polygons"].toArray();
        QCOMPARE(fences.size(), 3);
        QVERIFY(fences[0]["inclusion"].toBool() && !fences[1]["inclusion"].toBool() &&
                !fences[2]["inclusion"].toBool());
        COMPARE_WITHIN(fences[0]["polygon"][0][0].toDouble(), 52.0, 0.01);  // latitude first
    }

    void messageHoldsThePath() {
        v1::PathMessage message;
        QVERIFY(message.ParseFromString(bytesOf(writtenPlan().file("path.pb").toStdString())));
        QCOMPARE(message.format_version(), 1U);
        QCOMPARE(message.fence_size(), 1);
        QCOMPARE(message.fence(0).holes_size(), 1);
        QCOMPARE(message.keep_out_size(), 1);
        QCOMPARE(message.keep_out(0).name(), "Pylon");
        QCOMPARE(static_cast<std::size_t>(message.segments_size()),
                 planWithEverything().path.segments.size());
        for (int i = 0; i < message.segments_size(); ++i) {
            const PathSegment& segment = planWithEverything().path.segments[static_cast<std::size_t>(i)];
            QCOMPARE(message.segments(i).reverse(), segment.gear == Gear::Reverse);
            QCOMPARE(message.segments(i).implement_down(), segment.implementDown);
            QCOMPARE(static_cast<std::size_t>(message.segments(i).samples_size()), segment.samples.size());
            const v1::Sample& sample = message.segments(i).samples(1);
            const v1::Sample& next = message.segments(i).samples(0);
            QCOMPARE(sample.x_m(), segment.samples[1].position.x);
            QCOMPARE(sample.time_s(), segment.samples[1].tS);
            // The velocity points the way it moves, also in reverse.
            const double forwards = (sample.x_m() - next.x_m()) * sample.velocity_x_mps() +
                                    (sample.y_m() - next.y_m()) * sample.velocity_y_mps();
            QVERIFY(forwards >= -1e-6);
        }
    }

    void goalHoldsField() {
        const QByteArray goal = writtenPlan().text("ros/compute_coverage_path_goal.yaml");
        const auto rings = goal.count("- coordinates:");
        // The outline, the hole and the obstacle; an obstacle without a clearance stays as it is drawn.
        QCOMPARE(rings, 3);
        QVERIFY(goal.contains("mode: SET_ANGLE, best_angle: " +
                              QByteArray::number(planWithEverything().swaths.heading.si(), 'f', 9)));
        QVERIFY(goal.contains("route_mode: {mode: CUSTOM"));
        QVERIFY(writtenPlan().text("ros/map_frame.yaml").contains("proj: \"+proj=tmerc"));
    }

    void pathOfAgOpenGpsIsThePath() {
        const QString folder = QString::fromUtf8("agopengps/Höhe & Senke/");
        const QList<QByteArray> field = writtenPlan().text(folder + "Field.txt").split('\n');
        QCOMPARE(field[7], "StartFix\r");
        // Stretches between changes of gear; together every metre that is driven forwards.
        double forwards = 0.0;
        for (const PathSegment& segment : planWithEverything().path.segments) {
            forwards += segment.gear == Gear::Forward ? segment.length().si() : 0.0;
        }
        double recorded = 0.0;
        const QStringList parts =
            QDir{writtenPlan().file(folder)}.entryList({"*.rec"}, QDir::Files, QDir::Name);
        QVERIFY(parts.size() > 1);
        for (const QString& part : parts) {
            const QList<QByteArray> lines = writtenPlan().text(folder + part).split('\n');
            QCOMPARE(lines[0], "$RecPath\r");
            QCOMPARE(lines[1].trimmed().toInt(), static_cast<int>(lines.size()) - 3);
            for (qsizetype i = 3; i + 1 < lines.size(); ++i) {
                const QList<QByteArray> from = lines[i - 1].trimmed().split(',');
                const QList<QByteArray> to = lines[i].trimmed().split(',');
                QCOMPARE(to.size(), 5);
                const double east = to[0].toDouble() - from[0].toDouble();
                const double north = to[1].toDouble() - from[1].toDouble();
                recorded += std::hypot(east, north);
                // Straights have points, too: AgOpenGPS steers from one to the next.
                QVERIFY2(std::hypot(east, north) < 2.0, lines[i].constData());
                // Clockwise from north; nothing goes sideways.
                const double bearing = std::atan2(east, north);
                QVERIFY2(std::abs(std::remainder(from[2].toDouble() - bearing, 2.0 * M_PI)) < 0.02 ||
                             std::hypot(east, north) < 0.1,
                         lines[i].constData());
            }
        }
        QVERIFY2(recorded > 0.95 * forwards && recorded < 1.001 * forwards,
                 qPrintable(QStringLiteral("%1 of %2 m").arg(recorded).arg(forwards)));
    }

    // As short as cells and last passes may leave them: 27 cm, and 30 cm of a headland pass.
    void shortStretchesAreNoFault() {
        Plan shortened = planWithEverything();
        for (Swath& swath : shortened.swaths.swaths) {
            if (!swath.isCurved()) {
                const Point along = swath.end - swath.start;
                swath.end = swath.start + (0.27 / norm(along)) * along;
            }
        }
        PathSegment stretch =
            *std::ranges::find(shortened.path.segments, SegmentKind::HeadlandPass, &PathSegment::kind);
        stretch.samples.resize(2);
        stretch.samples[1] = stretch.samples[0];
        stretch.samples[1].position = stretch.samples[0].position + Point{0.3, 0.0};
        stretch.samples[1].sM = stretch.samples[0].sM + 0.3;
        stretch.number = 99;
        shortened.path.segments.push_back(stretch);
        std::vector<std::string_view> ids;
        for (const Format& format : formats()) {
            if (format.writes()) {
                ids.push_back(format.id);
            }
        }
        const QTemporaryDir folder;
        const auto files =
            writePlanFolder(shortened, folder.path().toStdString(), ids, {}, {.headlandLines = true});
        VERIFY_RESULT(files);
        for (const std::string& problem : files->checks.problems) {
            QVERIFY2(!problem.contains("same place"), problem.c_str());
        }
        // What a terminal steers by keeps its bearing.
        const auto lines = contentOf(shortened, {.headlandLines = true}).lines;
        const auto ab = std::ranges::find(lines, GuidanceKind::AbLine, &GuidanceLine::kind);
        QVERIFY(ab != lines.end());
        COMPARE_WITHIN(metresBetween(ab->points[0], ab->points[1]), 20.0, 0.1);
        const auto before = contentOf(planWithEverything(), {}).lines;
        QCOMPARE(ab->name, std::ranges::find(before, GuidanceKind::AbLine, &GuidanceLine::kind)->name);
        QVERIFY(
            std::ranges::none_of(lines, [](const GuidanceLine& line) { return line.name == "Headland 99"; }));
    }

    // A ring of missed land whose inner side was traced 4 cm beyond its outer one.
    void missedLandIsWrittenWithoutCrossings() {
        Plan traced = planWithEverything();
        const Point at = traced.path.segments.front().samples.front().position;
        const auto ring = [at](std::initializer_list<Point> points) {
            Ring moved;
            for (const Point& point : points) {
                moved.push_back(at + point);
            }
            return moved;
        };
        traced.audit.missedAreas = {{.outer = ring({{0.0, 0.0}, {20.0, 0.0}, {20.0, 10.0}, {0.0, 10.0}}),
                                     .holes = {ring({{2.0, 2.0}, {2.0, 8.0}, {20.04, 5.0}})}}};
        const QTemporaryDir folder;
        const std::vector<std::string_view> formats{"geojson"};
        const auto files = writePlanFolder(traced, folder.path().toStdString(), formats);
        VERIFY_RESULT(files);
        QVERIFY2(files->checks.problems.empty(),
                 files->checks.problems.empty() ? "" : files->checks.problems.front().c_str());
        double missedM2 = 0.0;
        const QJsonDocument json = QJsonDocument::fromJson(
            QByteArray::fromStdString(bytesOf(folder.filePath("plan.geojson").toStdString())));
        for (const QJsonValue& feature : json["features"].toArray()) {
            const QJsonObject properties = feature["properties"].toObject();
            missedM2 += properties["kind"].toString() == "missed" ? properties["area_m2"].toDouble() : 0.0;
        }
        // 200 m² less a triangle of 6 by 18 m.
        COMPARE_WITHIN(missedM2, 200.0 - 54.12, 0.1);
    }

    void everyTerminalGetsFiles() {
        std::set<std::string_view> ids;
        for (const Terminal& terminal : terminals()) {
            QVERIFY2(ids.insert(terminal.id).second, terminal.id.data());
            const QTemporaryDir folder;
            const auto files = writeForTerminal(planWithEverything(), folder.path().toStdString(), terminal);
            VERIFY_RESULT(files);
            QVERIFY2(files->files.size() > 1, terminal.id.data());
            const bool isIsoxml = terminal.format.starts_with("isoxml");
            QCOMPARE(QFileInfo::exists(folder.filePath("TASKDATA/TASKDATA.XML")), isIsoxml);
            QVERIFY(terminal.shows.size() > 40);
        }
        QVERIFY(!findTerminal("fent"));
        QVERIFY(findTerminal("fent").error().remedy.contains("fendt"));
    }

    void holesBecomeObstaclesForThoseThatOverlookThem() {
        const QTemporaryDir folder;
        VERIFY_RESULT(writeForTerminal(planWithEverything(), folder.path().toStdString(),
                                       **findTerminal("agopengps-isoxml")));
        const QByteArray xml =
            QByteArray::fromStdString(bytesOf(folder.filePath("TASKDATA/TASKDATA.XML").toStdString()));
        QCOMPARE(xml.count("<PLN A=\"6\""), 2);  // the hole and the pylon
        const qsizetype boundary = xml.indexOf("<PLN A=\"1\"");
        QVERIFY(!xml.mid(boundary, xml.indexOf("</PLN>", boundary) - boundary).contains("LSG A=\"2\""));
    }
};

FURROW_TEST(PlanFormatsTest);
#include "tst_plan_formats.moc"
