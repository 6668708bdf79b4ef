#include "planner/io/check/export_check.h"
#include "planner/io/content/plan_content.h"
#include "planner/io/formats/registry.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/planner/io/format_cases.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include "path_message.pb.h"

#include <QRegularExpression>
#include <QTest>

#include <bit>
#include <cstring>
#include <functional>

using namespace furrow;
using namespace furrow::test;

namespace {

/// The same without much of what lies round the obstacle.
const Plan& widelyBufferedPlan() {
    static const std::shared_ptr<const Plan> made = [] {
        FieldSource source = planWithEverything().field().source();
        source.obstacles.front().buffer = metres(12.0);
        return planOf(source, "power-harrow-drill");
    }();
    return *made;
}

/// A plan that drives forwards only.
const Plan& forwardPlan() {
    static const std::shared_ptr<const Plan> made = [] {
        Settings settings;
        for (const auto& [key, value] :
             {std::pair{"headland.driven", "false"}, std::pair{"path.method", "dubins"}}) {
            applySetting(settings, key, value).value();
        }
        return planOf(plainField().field, "power-harrow-drill", settings);
    }();
    return *made;
}

struct Export {
    std::vector<FieldContent> fields;
    const Plan* plan = nullptr;
    ExportOptions options = {};
    std::vector<FileToWrite> files = {};

    ExportJob job() const { return {.fields = fields, .plan = plan, .options = options, .job = {}}; }
};

Export exported(std::string_view format, const Plan* of,
                std::vector<FieldContent> fields = {fieldWithEverything()}, ExportOptions options = {}) {
    Export made{.fields = of == nullptr ? std::move(fields) : std::vector{contentOf(*of, options)},
                .plan = of,
                .options = options};
    const auto found = std::ranges::find(formats(), format, &Format::id);
    made.files = found->writing.write(made.job()).value().files;
    return made;
}

using Spoil = std::function<void(std::string&)>;

/// The first place that matches, in other words.
Spoil text(const char* from, const char* to) {
    return [from, to](std::string& bytes) {
        QString all = QString::fromStdString(bytes);
        const QRegularExpression pattern{QString::fromUtf8(from),
                                         QRegularExpression::DotMatchesEverythingOption};
        const auto match = pattern.match(all);
        QString with = QString::fromUtf8(to);
        with.replace(QStringLiteral("\\1"), match.captured(1))
            .replace(QStringLiteral("\\2"), match.captured(2));
        all.replace(match.capturedStart(), match.capturedLength(), with);
        bytes = all.toStdString();
    };
}

Spoil everywhere(const char* from, const char* to) {
    return [from, to](std::string& bytes) {
        bytes = QString::fromStdString(bytes)
                    .replace(QRegularExpression{QString::fromUtf8(from),
                                                QRegularExpression::DotMatchesEverythingOption},
                             QString::fromUtf8(to))
                    .toStdString();
    };
}

/// A double in little-endian bytes, where it first or last stands.
Spoil number(std::function<double()> from, double by, bool last = false) {
    return [from = std::move(from), by, last](std::string& bytes) {
        const auto raw = std::bit_cast<std::array<char, 8>>(from());
        const std::string_view wanted{raw.data(), raw.size()};
        const std::size_t at = last ? bytes.rfind(wanted) : bytes.find(wanted);
        if (at != std::string::npos) {
            const auto other = std::bit_cast<std::array<char, 8>>(from() + by);
            bytes.replace(at, other.size(), other.data(), other.size());
        }
    };
}

/// The same wherever it stands.
Spoil everyNumber(std::function<double()> from, double by) {
    return [one = number(from, by), from](std::string& bytes) {
        const auto raw = std::bit_cast<std::array<char, 8>>(from());
        while (bytes.contains(std::string_view{raw.data(), raw.size()})) {
            one(bytes);
        }
    };
}

Spoil cutOff(std::size_t count) {
    return [count](std::string& bytes) { bytes.resize(bytes.size() - count); };
}

Spoil message(void (*change)(v1::PathMessage&)) {
    return [change](std::string& bytes) {
        v1::PathMessage parsed;
        parsed.ParseFromString(bytes);
        change(parsed);
        bytes = parsed.SerializeAsString();
    };
}

double firstCornerLon() {
    return 9.0;
}
double firstX() {
    return planWithEverything().path.segments.front().samples.front().position.x;
}

struct Row {
    const char* name;
    const char* format;
    const Plan& (*plan)();  ///< null for fields alone
    const char* file;       ///< the end of its name; what is spoilt, or taken away
    Spoil spoil;            ///< empty: the file is taken away
    const char* problem;
};

const std::vector<Row>& rows() {
    static const std::vector<Row> all{
        // What section 9 of the format notes put into task data, and schemas overlooked.
        {"ISOXML: pattern without a line", "isoxml", nullptr, "TASKDATA.XML",
         text(R"(<LSG A="5" B="AB".*?</LSG>)", ""), "'AB' has 0 lines"},
        {"ISOXML: AB with one point", "isoxml", nullptr, "TASKDATA.XML",
         text(R"(<PNT A="7" C="52.000300000" D="9.002700000" />)", ""), "its points are of kinds 6"},
        {"ISOXML: A and B one place", "isoxml", nullptr, "TASKDATA.XML",
         text(R"(<PNT A="7" C="52.000300000" D="9.002700000" />)",
              R"(<PNT A="7" C="52.000300000" D="9.000300001" />)"),
         "A and B of 'AB' are the same place"},
        {"ISOXML: ring not closed", "isoxml", nullptr, "TASKDATA.XML",
         text(R"((<LSG A="1">\s*)<PNT[^>]*/>)", "\\1"), "does not end where it begins"},
        {"ISOXML: ring of two", "isoxml", nullptr, "TASKDATA.XML",
         text(R"((<LSG A="2">\s*<PNT[^>]*/>).*?</LSG>)", "\\1</LSG>"), "fewer than three corners"},
        {"ISOXML: latitude and longitude exchanged", "isoxml", nullptr, "TASKDATA.XML",
         everywhere("C=\"(5[0-9.]*)\" D=\"([0-9.]*)\"", "C=\"\\2\" D=\"\\1\""), "is far from the field"},
        {"ISOXML: wrong area", "isoxml", nullptr, "TASKDATA.XML",
         text(R"(<PLN A="6" B="Pylon" C="\d+")", R"(<PLN A="6" B="Pylon" C="500")"),
         "'Pylon' is said to have 500 m²"},
        {"ISOXML: wrong area of the field", "isoxml", nullptr, "TASKDATA.XML",
         text(R"((<PFD A="PFD1" C="[^"]*" D=")\d+")", "\\1999999\""), "is said to have 999999 m²"},
        {"ISOXML: hole outside", "isoxml", nullptr, "TASKDATA.XML", everywhere(R"(52\.0005)", "52.0105"),
         "a hole lies outside"},
        {"ISOXML: bow-tie", "isoxml", nullptr, "TASKDATA.XML",
         text(
             R"(<PNT A="2" C="52.000000000" D="9.003000000" />\s*<PNT A="2" C="52.002000000" D="9.003000000" />)",
             R"(<PNT A="2" C="52.002000000" D="9.003000000" /><PNT A="2" C="52.000000000" D="9.003000000" />)"),
         "crosses itself"},
        {"ISOXML: name of 33 characters", "isoxml", nullptr, "TASKDATA.XML",
         text("<PFD A=\"PFD1\" C=\"[^\"]*\"", "<PFD A=\"PFD1\" C=\"123456789012345678901234567890123\""),
         "longer than 32"},
        {"ISOXML: exponent", "isoxml", nullptr, "TASKDATA.XML",
         text(R"(C="52.001000000" D="9.005000000")", R"(C="5.2e1" D="9.005")"),
         "is no longitude and latitude"},
        {"ISOXML: id twice", "isoxml", nullptr, "TASKDATA.XML", text("GPN2", "GPN1"),
         "the id GPN1 is there twice"},
        {"ISOXML: line name twice", "isoxml", nullptr, "TASKDATA.XML",
         text("(<GPN [^>]*)B=\"Bend\"", "\\1B=\"AB\""), "the name 'AB' is there twice"},
        {"ISOXML: width in metres", "isoxml", nullptr, "TASKDATA.XML",
         text(R"(B="AB" C="6000")", R"(B="AB" C="6")"), "'AB' is said to be 0.006 m wide"},
        {"ISOXML: a part less", "isoxml", nullptr, "TASKDATA.XML",
         text(R"(<PLN A="1" B="[^"]* 2".*?</PLN>)", ""), "1 boundaries are in it, not 2"},
        {"ISOXML: hole lost", "isoxml", nullptr, "TASKDATA.XML", text(R"(<LSG A="2">.*?</LSG>)", ""),
         "0 holes are in it, not 1"},
        {"ISOXML: line lost", "isoxml", nullptr, "TASKDATA.XML", text(R"(<GGP.*?</GGP>)", ""),
         "3 guidance lines are in it, not 4"},
        {"ISOXML: no list of links", "isoxml", nullptr, "LINKLIST.XML", {}, "LINKLIST.XML is missing"},
        {"ISOXML: link to nothing", "isoxml", nullptr, "LINKLIST.XML", text("PFD1", "PFD7"),
         "PFD7 is referred to and not there"},
        {"ISOXML: cut off", "isoxml", nullptr, "TASKDATA.XML", cutOff(200), "this is no XML"},
        {"ISOXML 3: group", "isoxml-v3", nullptr, "TASKDATA.XML", text("</PFD>", R"(<GGP A="GGP1"/></PFD>)"),
         "not known before version 4"},
        {"ISOXML 3: headland", "isoxml-v3", nullptr, "TASKDATA.XML", text(R"(<PLN A="6")", R"(<PLN A="10")"),
         "PLN A=10 is not known"},
        {"GeoJSON: cut off", "geojson", planWithEverything, ".geojson", cutOff(9), "this is no JSON"},
        {"GeoJSON: longitude and latitude exchanged", "geojson", nullptr, ".geojson",
         everywhere(R"(\[(9[0-9.]*),(52[0-9.]*)\])", "[\\2,\\1]"), "is far from the field"},
        {"GeoJSON: clockwise", "geojson", nullptr, ".geojson",
         text(R"(\[9.0,52.0\],\[9.003,52.0\],\[9.003,52.002\],\[9.0,52.002\],\[9.0,52.0\])",
              "[9.0,52.0],[9.0,52.002],[9.003,52.002],[9.003,52.0],[9.0,52.0]"),
         "runs the wrong way round"},
        {"GeoJSON: order", "geojson", planWithEverything, ".geojson",
         text(R"("order":3,"segment")", R"("order":4,"segment")"), "4 comes where 3 should"},
        {"GeoJSON: swath lost", "geojson", planWithEverything, ".geojson",
         text(R"("kind":"swath")", R"("kind":"other")"), "1 comes where 0 should"},
        {"GeoJSON: coordinate system", "geojson", nullptr, ".geojson",
         text(R"(\{"type":"FeatureCollection")", R"({"crs":{},"type":"FeatureCollection")"),
         "does not say in which coordinate system"},
        {"CSV: time falls", "csv", planWithEverything, "path.csv",
         text(R"((\n[^,\n]*),[^,\n]*(,[^\n]*\n)$)", "\\1,0.5\\2"), "is before that of the place before"},
        {"CSV: row of words", "csv", planWithEverything, "path.csv", text(R"(\n[^\n]*\n$)", "\nfive\n"),
         "is not as this format has it"},
        {"CSV: column", "csv", planWithEverything, "path.csv", text("heading_rad", "heading"),
         "heading_rad is missing"},
        {"CSV: open ring", "csv", nullptr, "fields.csv", text(R"(\(\(9 52, )", "(("),
         "does not end where it begins"},
        {"AgOpenGPS: headings", "agopengps", nullptr, "Boundary.txt",
         text(R"(,(\d\.\d{5})\r\n)", ",0.00000\r\n"), "the headings of a ring do not point along it"},
        {"AgOpenGPS: count", "agopengps", nullptr, "Boundary.txt",
         text(R"(False\r\n(\d+)\r\n)", "False\r\n5\r\n"), "is not as this format has it"},
        {"AgOpenGPS: east and north exchanged", "agopengps", forwardPlan, "RecPath.txt",
         everywhere(R"((-?\d+(?:\.\d+)?),(-?\d+(?:\.\d+)?),(\d\.\d{3}),)", "\\2,\\1,\\3,"),
         "of the path is not where the plan goes next"},
        {"AgOpenGPS: no StartFix", "agopengps", nullptr, "Field.txt", text("StartFix", "Start"),
         "StartFix is missing"},
        {"AgOpenGPS: name left out", "agopengps", nullptr, "TrackLines.txt", text("AB\r\n", "\r\n"),
         "is not as this format has it"},
        {"Shapefile: no projection", "shapefile", nullptr, "boundary.prj", {}, "in which coordinate system"},
        {"Shapefile: no index", "shapefile", nullptr, "boundary.shx", {}, "boundary.shx is missing"},
        {"Shapefile: ring open", "shapefile", nullptr, "boundary.shp", number(firstCornerLon, 0.0001, true),
         "does not end where it begins"},
        {"Shapefile: cut off", "shapefile", nullptr, "boundary.shp", cutOff(16),
         "its content cannot be read"},
        {"zipped shapefile: no zip", "shapefile-zip", nullptr, ".zip", cutOff(60), "is missing"},
        {"AgGPS: with heights", "aggps", nullptr, "Boundary.shp", [](std::string& bytes) { bytes[32] = 15; },
         "cannot be read"},
        {"KML: latitude first", "kml", nullptr, ".kml", everywhere(R"((9\.\d{9}),(52\.\d{9}))", "\\2,\\1"),
         "is far from the field"},
        {"KML: hole lost", "kml", nullptr, ".kml", text("<innerBoundaryIs>.*?</innerBoundaryIs>", ""),
         "0 holes are in it, not 1"},
        {"KML: height", "kml", nullptr, ".kml",
         text(R"(9\.000000000,52\.000000000)", "9.000000000,52.000000000,35"),
         "is no longitude and latitude"},
        {"KMZ: no zip", "kmz", nullptr, ".kmz", cutOff(40), "doc.kml is missing"},
        {"GeoPackage: hole outside", "geopackage", nullptr, ".gpkg", everyNumber(firstCornerLon, 0.002),
         "a hole lies outside"},
        {"GeoPackage: no database", "geopackage", nullptr, ".gpkg",
         text("SQLite format 3", "SQLite format 9"), "this is no GeoPackage"},
        {"GPX: out of order", "gpx", planWithEverything, ".gpx",
         text("</gpx>", "<wpt lat=\"52\" lon=\"9\"/></gpx>"), "wpt comes where trk should"},
        {"GPX: a stretch less", "gpx", planWithEverything, ".gpx", text("<trkseg>.*?</trkseg>", ""),
         "the path"},
        {"GPX: version", "gpx", nullptr, ".gpx", text("version=\"1.1\"", "version=\"1.0\""),
         "this is no GPX 1.1"},
        {"DXF: no end", "dxf", nullptr, ".dxf", cutOff(8), "is not as this format has it"},
        {"DXF: another zone", "dxf", nullptr, ".dxf", everywhere(R"( 10\n(\d)(\d{5}\.))", " 10\n9\\2"),
         "is far from the field"},
        {"mission: rows", "waypoints", planWithEverything, ".waypoints", text(R"(\n7\t)", "\n9\t"),
         "9 comes where 7 should"},
        {"mission: unknown command", "waypoints", planWithEverything, ".waypoints",
         text(R"(\n7\t0\t3\t\d+)", "\n7\t0\t3\t82"), "is not as this format has it"},
        {"mission: waypoints lost", "waypoints", planWithEverything, ".waypoints",
         text(R"((\n2\t.*?\n)3\t.*$)", "\\1"), "m long, not"},
        {"ground station: longitude first", "qgc-plan", planWithEverything, ".plan",
         everywhere(R"((\n\s*)(52\.\d+),\s*(9\.\d+))", "\\1\\3,\\2"), "is far from the field"},
        {"ground station: fence lost", "qgc-plan", planWithEverything, ".plan",
         text("\"inclusion\": true", "\"inclusion\": false"), "0 boundaries are in it, not 1"},
        {"bag, sqlite3: a place moved", "rosbag2", planWithEverything, ".db3", number(firstX, 100.0),
         "of the path is not where the plan goes next"},
        {"bag, sqlite3: counts", "rosbag2", planWithEverything, "metadata.yaml",
         text("message_count: ", "message_count: 9"), "entries are announced"},
        {"bag, MCAP: a place moved", "rosbag2-mcap", planWithEverything, ".mcap", number(firstX, 100.0),
         "of the path is not where the plan goes next"},
        {"bag, MCAP: cut off", "rosbag2-mcap", planWithEverything, ".mcap", cutOff(100),
         "its content cannot be read"},
        {"YAML: orientation", "nav-path", planWithEverything, "path.yaml", text(R"(w: -?\d\.\d+)", "w: 5.0"),
         "is not as this format has it"},
        {"YAML: frame", "nav-path", planWithEverything, "path.yaml",
         everywhere("frame_id: map", "frame_id: odom"), "in which coordinate system"},
        {"goal: ring open", "coverage-goal", planWithEverything, "goal.yaml",
         text(R"((- coordinates:\n)  - [^\n]*\n)", "\\1"), "does not end where it begins"},
        {"goal: headland", "coverage-goal", planWithEverything, "goal.yaml",
         text(R"(CONSTANT, width: \d)", "CONSTANT, width: 99"), "'headland_mode' is said to be"},
        {"message: cut off", "protobuf", planWithEverything, ".pb", cutOff(3), "its content cannot be read"},
        {"message: speed in km/h", "protobuf", planWithEverything, ".pb", message([](v1::PathMessage& path) {
             for (v1::Segment& segment : *path.mutable_segments()) {
                 for (v1::Sample& sample : *segment.mutable_samples()) {
                     sample.set_speed_mps(sample.speed_mps() * 3.6);
                 }
             }
         }),
         "its largest speed is"},
        {"message: heading from north", "protobuf", planWithEverything, ".pb",
         message([](v1::PathMessage& path) {
             for (v1::Segment& segment : *path.mutable_segments()) {
                 for (v1::Sample& sample : *segment.mutable_samples()) {
                     sample.set_heading_rad(M_PI / 2.0 - sample.heading_rad());
                 }
             }
         }),
         "does not point along it"},
        {"message: segments exchanged", "protobuf", planWithEverything, ".pb",
         message([](v1::PathMessage& path) { path.mutable_segments()->SwapElements(4, 9); }),
         "of the path is not where the plan goes next"},
        {"message: times stand still", "protobuf", planWithEverything, ".pb",
         message([](v1::PathMessage& path) {
             for (v1::Segment& segment : *path.mutable_segments()) {
                 for (v1::Sample& sample : *segment.mutable_samples()) {
                     sample.set_time_s(5.0);
                 }
             }
         }),
         "the times of the path stand still"},
    };
    return all;
}

}  // namespace

/// The checks find nothing in what is written, and each mistake that is put in on purpose.
class ExportCheckTest : public QObject {
    Q_OBJECT

private slots:
    void findsNothingInFields_data() {
        QTest::addColumn<QString>("format");
        QTest::addColumn<int>("index");
        for (const Format& format : formats()) {
            for (int i = 0; format.writesFields() && i < static_cast<int>(std::size(kFormatCases)); ++i) {
                QTest::addRow("%s, %s", format.id.data(), kFormatCases[i].name)
                    << QString::fromUtf8(format.id.data()) << i;
            }
        }
    }
    void findsNothingInFields() {
        QFETCH(QString, format);
        QFETCH(int, index);
        const Export made = exported(format.toStdString(), nullptr, {kFormatCases[index].field()});
        const ExportChecks checks = checkExport(*formatCalled(format.toStdString()), made.job(), made.files);
        QVERIFY2(checks.problems.empty(), checks.problems.empty() ? "" : checks.problems.front().c_str());
        QVERIFY(checks.made.size() >= 5);
    }

    void findsNothingInPlans_data() {
        QTest::addColumn<QString>("format");
        QTest::addColumn<const Plan*>("made");
        for (const Format& format : formats()) {
            if (format.writes()) {
                const QString id = QString::fromUtf8(format.id.data());
                QTest::addRow("%s", format.id.data()) << id << &planWithEverything();
                QTest::addRow("%s, forwards only", format.id.data()) << id << &forwardPlan();
                QTest::addRow("%s, a wide buffer", format.id.data()) << id << &widelyBufferedPlan();
            }
        }
    }
    void findsNothingInPlans() {
        QFETCH(QString, format);
        QFETCH(const Plan*, made);
        const Export files = exported(format.toStdString(), made);
        const ExportChecks checks =
            checkExport(*formatCalled(format.toStdString()), files.job(), files.files);
        QVERIFY2(checks.problems.empty(), checks.problems.empty() ? "" : checks.problems.front().c_str());
        QVERIFY(checks.made.size() >= 5);
    }

    void findsWhatIsPutIn_data() {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < rows().size(); ++i) {
            QTest::newRow(rows()[i].name) << static_cast<int>(i);
        }
    }
    void findsWhatIsPutIn() {
        QFETCH(int, index);
        const Row& row = rows()[static_cast<std::size_t>(index)];
        Export made = exported(row.format, row.plan == nullptr ? nullptr : &row.plan());
        const auto file = std::ranges::find_if(made.files, [&row](const FileToWrite& each) {
            return each.path.generic_string().ends_with(row.file);
        });
        QVERIFY(file != made.files.end());
        if (row.spoil) {
            std::string bytes = file->text();
            const std::string before = bytes;
            row.spoil(bytes);
            QVERIFY(bytes != before);
            file->text = [bytes] { return bytes; };
        } else {
            made.files.erase(file);
        }
        const ExportChecks checks = checkExport(*formatCalled(row.format), made.job(), made.files);
        const bool told = std::ranges::any_of(
            checks.problems, [&row](const Message& problem) { return problem.contains(row.problem); });
        QVERIFY2(told, checks.problems.empty() ? "nothing was found" : checks.problems.front().c_str());
    }

    void namesOfFilesThatSomeSystemsRefuse_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<bool>("good");
        QTest::newRow("plain") << "Home Field/Field.txt" << true;
        QTest::newRow("colon") << "Home: Field/Field.txt" << false;
        QTest::newRow("device") << "con/Field.txt" << false;
        QTest::newRow("dot at the end") << "Home./Field.txt" << false;
        QTest::newRow("blank at the end") << "Home /Field.txt" << false;
        QTest::newRow("question mark") << "Where?/Field.txt" << false;
        QTest::newRow("leads out") << "../Field.txt" << false;
        QTest::newRow("from the root") << "/Field.txt" << false;
        QTest::newRow("terminals want capitals") << "TASKDATA/Taskdata.xml" << false;
        QTest::newRow("terminals want eight and three") << "TASKDATA/TASKDATA_2.XML" << false;
        QTest::newRow("terminals") << "TASKDATA/TASKDATA.XML" << true;
    }
    void namesOfFilesThatSomeSystemsRefuse() {
        QFETCH(QString, path);
        QFETCH(bool, good);
        Export made = exported("geojson", nullptr);
        made.files.front().path = path.toStdString();
        const ExportChecks checks = checkExport(*formatCalled("geojson"), made.job(), made.files);
        const bool told = std::ranges::any_of(checks.problems, [](const Message& problem) {
            return problem.contains("some systems do not allow");
        });
        QCOMPARE(told, !good);
    }

    void filesThatDifferInCapitalsOnly() {
        Export made = exported("geojson", nullptr);
        made.files.push_back(made.files.front());
        made.files.back().path = "FIELDS.geojson";
        const ExportChecks checks = checkExport(*formatCalled("geojson"), made.job(), made.files);
        QVERIFY(std::ranges::any_of(
            checks.problems, [](const Message& problem) { return problem.contains("in capitals only"); }));
        // Two fields whose names do so lie in folders that do not.
        FieldContent other = plainField();
        other.field.name = "NORTH FIELD";
        for (const char* format : {"agopengps", "aggps"}) {
            const Export both = exported(format, nullptr, {plainField(), other});
            const ExportChecks good = checkExport(*formatCalled(format), both.job(), both.files);
            QVERIFY2(good.problems.empty(), good.problems.empty() ? "" : good.problems.front().c_str());
        }
    }

    void lettersThatOldTerminalsCannotShow() {
        const Export good = exported("isoxml-v3", nullptr, {fieldWithEverything()}, {.asciiNames = true});
        QVERIFY(checkExport(*formatCalled("isoxml-v3"), good.job(), good.files).problems.empty());
        Export wrong = exported("isoxml-v3", nullptr);
        wrong.options.asciiNames = true;  // what was asked for, and is not what was written
        const ExportChecks checks = checkExport(*formatCalled("isoxml-v3"), wrong.job(), wrong.files);
        QVERIFY(std::ranges::any_of(checks.problems, [](const Message& problem) {
            return problem.contains("letters beyond A to Z");
        }));
    }

    void everyFormatIsChecked() {
        for (const Format& format : formats()) {
            if (format.writes()) {
                const Export made = exported(format.id, &planWithEverything());
                const ExportChecks checks = checkExport(format, made.job(), made.files);
                QVERIFY2(std::ranges::contains(checks.made, "readable"), format.id.data());
                // Formats of robots have coordinates in metres, in a frame of the field's own.
                const bool isOnEarth = format.writing.content.fields || format.writing.content.lines;
                for (const std::string_view check : {"coordinates", "place"}) {
                    QVERIFY2(!isOnEarth || std::ranges::contains(checks.made, check), format.id.data());
                }
                QVERIFY2(checks.problems.empty(), format.id.data());
            }
        }
    }
};

FURROW_TEST(ExportCheckTest);
#include "tst_export_check.moc"
