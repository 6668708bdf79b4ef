#include "tests/planner/io/format_cases.h"

#include "planner/io/delivery/field_files.h"
#include "planner/io/import/boundary_import.h"
#include "planner/io/import/field_reader.h"
#include "tests/support/large_data.h"
#include "tests/support/real_fields.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

using namespace furrow;
using namespace furrow::test;

namespace {

/// What a format keeps of a field, and how exactly.
struct Kept {
    const char* format;
    const char* out;         ///< file or folder to write to and read from
    double toleranceM;       ///< of the format, with a little for both ways
    bool densified = false;  ///< more points on the same outline
    bool parts = true;       ///< several parts stay one field
    bool obstacles = true;
    bool gates = true;
    bool mainland = true;
    std::size_t lines = 4;      ///< of the four of the field with everything
    bool straightKinds = true;  ///< A+ and pivot come back as such
    bool holes = true;
};

constexpr Kept kKept[] = {
    {.format = "geojson", .out = "f.geojson", .toleranceM = 1e-6, .straightKinds = false},
    {.format = "isoxml", .out = "TASKDATA", .toleranceM = 2e-4},
    {.format = "isoxml-v3",
     .out = "TASKDATA",
     .toleranceM = 2e-4,
     .gates = false,
     .mainland = false,
     .straightKinds = false},
    {.format = "isoxml", .out = "t.zip", .toleranceM = 2e-4},
    {.format = "agopengps",
     .out = "fields",
     .toleranceM = 2e-3,
     .densified = true,
     .parts = false,
     .straightKinds = false},
    {.format = "shapefile",
     .out = "f.shp",
     .toleranceM = 1e-6,
     .obstacles = false,
     .gates = false,
     .mainland = false,
     .lines = 0},
    {.format = "shapefile-zip",
     .out = "f.zip",
     .toleranceM = 1e-6,
     .obstacles = false,
     .gates = false,
     .mainland = false,
     .lines = 0},
    {.format = "shapefile", .out = "all.zip", .toleranceM = 1e-6, .straightKinds = false},
    {.format = "aggps",
     .out = "AgGPS",
     .toleranceM = 1e-6,
     .obstacles = false,
     .gates = false,
     .mainland = false,
     .straightKinds = false},
    {.format = "kml", .out = "f.kml", .toleranceM = 2e-4, .straightKinds = false},
    {.format = "kmz", .out = "f.kmz", .toleranceM = 2e-4, .straightKinds = false},
    {.format = "geopackage", .out = "f.gpkg", .toleranceM = 1e-6, .straightKinds = false},
    {.format = "dxf",
     .out = "f.dxf",
     .toleranceM = 2e-3,
     .parts = false,
     .gates = false,
     .straightKinds = false},
    {.format = "csv",
     .out = "f.csv",
     .toleranceM = 1e-6,
     .obstacles = false,
     .gates = false,
     .mainland = false,
     .lines = 0},
};

/// Corners of one among the points of the other, within the tolerance.
bool sameOutline(const GeoRing& dense, const GeoRing& corners, double toleranceM) {
    // Of many corners some are enough.
    for (std::size_t i = 0; i < corners.size(); i += std::max<std::size_t>(1, corners.size() / 200)) {
        if (std::ranges::none_of(
                dense, [&](GeoPoint point) { return metresBetween(point, corners[i]) <= toleranceM; })) {
            return false;
        }
    }
    return true;
}

QString told(const ImportedFields& read) {
    QString text;
    for (const FieldContent& content : read.fields) {
        text += QStringLiteral("%1: %2 parts, %3 obstacles, %4 gates, %5 mainland, %6 lines; ")
                    .arg(QString::fromStdString(content.field.name))
                    .arg(content.field.parts.size())
                    .arg(content.field.obstacles.size())
                    .arg(content.field.gates.size())
                    .arg(content.mainland.size())
                    .arg(content.lines.size());
    }
    for (const Note& note : read.notes) {
        text += QString::fromStdString(note.text) + "; ";
    }
    return text;
}

}  // namespace

/// Fields without a plan: written, read again, compared.
class FieldRoundTripTest : public QObject {
    Q_OBJECT

private slots:
    void comesBack_data() {
        QTest::addColumn<int>("kept");
        QTest::addColumn<int>("field");
        for (int kept = 0; kept < static_cast<int>(std::size(kKept)); ++kept) {
            for (int field = 0; field < static_cast<int>(std::size(kFormatCases)); ++field) {
                QTest::addRow("%s in %s: %s", kKept[kept].format, kKept[kept].out, kFormatCases[field].name)
                    << kept << field;
            }
        }
    }

    void comesBack() {
        QFETCH(int, kept);
        QFETCH(int, field);
        const Kept& format = kKept[kept];
        const FieldContent expected = kFormatCases[field].field();
        const QTemporaryDir folder;
        const std::filesystem::path out = std::filesystem::path{folder.path().toStdString()} / format.out;
        const auto written = writeFields(std::vector{expected}, out, format.format);
        VERIFY_RESULT(written);
        for (const std::filesystem::path& file : written->files) {
            QVERIFY2(std::filesystem::exists(file), file.c_str());
            QVERIFY(file.string().starts_with(folder.path().toStdString()));
        }
        // A drawing gets the code of its zone into its name.
        const bool isDrawing = std::string_view{format.format} == "dxf";
        const auto read = readFields(isDrawing ? written->files.front() : out);
        VERIFY_RESULT(read);
        const bool manyFields = !format.parts && expected.field.parts.size() > 1;
        QVERIFY2(read->fields.size() == (manyFields ? expected.field.parts.size() : 1),
                 qPrintable(told(*read)));
        std::vector<GeoPolygon> parts;
        for (const FieldContent& content : read->fields) {
            parts.insert(parts.end(), content.field.parts.begin(), content.field.parts.end());
        }
        QCOMPARE(parts.size(), expected.field.parts.size());
        for (const GeoPolygon& part : expected.field.parts) {
            QVERIFY2(std::ranges::any_of(parts,
                                         [&](const GeoPolygon& other) {
                                             return format.densified
                                                        ? other.holes.size() >= part.holes.size() &&
                                                              sameOutline(other.outer, part.outer,
                                                                          format.toleranceM)
                                                        : samePolygon(other, part, format.toleranceM);
                                         }),
                     qPrintable(told(*read)));
        }
        compareBelongings(format, expected, read->fields);
    }

    void realFieldsComeBackFromTaskData() {
        // bg_021 has 545 ha, bg_010 195 ha and 19 holes.
        const std::filesystem::path file = test::largeDataPath("fields/all_fields.geojson");
        if (!std::filesystem::exists(file)) {
            QSKIP("needs the fields of the large test data");
        }
        const auto all = readBoundaries(file);
        VERIFY_RESULT(all);
        for (const char* id : {"bg_021", "bg_010"}) {
            const auto source = pickField(*all, id);
            VERIFY_RESULT(source);
            const auto field = Field::create(*source);
            VERIFY_RESULT(field);
            const QTemporaryDir folder;
            const std::filesystem::path out = std::filesystem::path{folder.path().toStdString()} / "TASKDATA";
            const auto written = writeFields(
                std::vector{FieldContent{.field = field->source(), .area = field->area()}}, out, {});
            VERIFY_RESULT(written);
            QVERIFY2(written->notes.empty(), written->notes.empty() ? "" : written->notes.front().c_str());
            const auto read = readFields(out);
            VERIFY_RESULT(read);
            QCOMPARE(read->fields.size(), 1U);
            QCOMPARE(read->fields[0].field.parts.size(), field->source().parts.size());
            for (std::size_t i = 0; i < field->source().parts.size(); ++i) {
                QVERIFY(samePolygon(read->fields[0].field.parts[i], field->source().parts[i], 2e-4));
            }
        }
    }

private:
    static void compareBelongings(const Kept& format, const FieldContent& expected,
                                  const std::vector<FieldContent>& read) {
        std::size_t obstacles = 0;
        std::size_t gates = 0;
        std::size_t mainland = 0;
        std::vector<GuidanceLine> lines;
        for (const FieldContent& content : read) {
            obstacles += content.field.obstacles.size();
            gates += content.field.gates.size();
            mainland += content.mainland.size();
            lines.insert(lines.end(), content.lines.begin(), content.lines.end());
        }
        const bool agOpenGps = std::string_view{format.format} == "agopengps";
        if (agOpenGps) {
            return;  // its parts are fields of their own: see tst_agopengps
        }
        QCOMPARE(obstacles, format.obstacles ? expected.field.obstacles.size() : 0U);
        QCOMPARE(gates, format.gates ? expected.field.gates.size() : 0U);
        QVERIFY(mainland >= (format.mainland ? expected.mainland.size() : 0U));
        if (expected.lines.empty()) {
            return;
        }
        QCOMPARE(lines.size(), format.lines);
        for (const GuidanceLine& line : lines) {
            const auto same = std::ranges::find(expected.lines, line.name, &GuidanceLine::name);
            const bool named = same != expected.lines.end();
            if (named && (format.straightKinds || line.kind == same->kind)) {
                QCOMPARE(line.kind, same->kind);
                QCOMPARE(line.points.size(), same->points.size());
                for (std::size_t i = 0; i < line.points.size(); ++i) {
                    QVERIFY(metresBetween(line.points[i], same->points[i]) <= format.toleranceM);
                }
            }
        }
    }
};

FURROW_TEST(FieldRoundTripTest);
#include "tst_field_round_trip.moc"
