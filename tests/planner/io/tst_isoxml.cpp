#include "planner/geodesy/local_frame.h"
#include "planner/io/content/plan_content.h"
#include "planner/io/formats/isoxml/isoxml_writer.h"
#include "planner/io/import/boundary_import.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include <cmath>
#include <fstream>
#include <regex>

using namespace furrow;

namespace {

/// The element of a document with its children, read by Qt: not the library that wrote it.
struct Element {
    QString tag;
    QXmlStreamAttributes attributes;
    QList<Element> children;

    QString value(const char* name) const { return attributes.value(QLatin1StringView{name}).toString(); }
    QList<Element> all(const char* wantedTag) const {
        QList<Element> found;
        for (const Element& child : children) {
            if (child.tag == QLatin1StringView{wantedTag}) {
                found.append(child);
            }
        }
        return found;
    }
};

Element readElement(QXmlStreamReader& reader) {
    Element element{reader.name().toString(), reader.attributes(), {}};
    while (reader.readNext() != QXmlStreamReader::EndElement && !reader.atEnd()) {
        if (reader.isStartElement()) {
            element.children.append(readElement(reader));
        }
    }
    return element;
}

Element parsed(const std::string& xml) {
    QXmlStreamReader reader{QByteArray::fromStdString(xml)};
    reader.readNextStartElement();
    Element root = readElement(reader);
    return reader.hasError() ? Element{} : root;
}

GeoRing ringOf(const Element& line) {
    GeoRing ring;
    for (const Element& point : line.all("PNT")) {
        ring.push_back({point.value("D").toDouble(), point.value("C").toDouble()});
    }
    return ring;
}

// 0.000 000 000 5 degrees of rounding, on both sides.
constexpr double kToleranceDeg = 1.1e-9;

bool near(const GeoPoint& a, const GeoPoint& b) {
    return std::abs(a.lonDeg - b.lonDeg) < kToleranceDeg && std::abs(a.latDeg - b.latDeg) < kToleranceDeg;
}

/// The written ring is closed and has exactly the points of the field's.
bool sameRing(GeoRing written, const GeoRing& expected) {
    if (written.size() != expected.size() + 1 || written.front() != written.back()) {
        return false;
    }
    return std::ranges::all_of(expected, [&written](const GeoPoint& point) {
        return std::ranges::any_of(written, [&point](const GeoPoint& other) { return near(point, other); });
    });
}

/// Positive for counter-clockwise.
double turning(const GeoRing& ring) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
        sum += (ring[i].lonDeg - ring[0].lonDeg) * (ring[i + 1].latDeg - ring[0].latDeg) -
               (ring[i + 1].lonDeg - ring[0].lonDeg) * (ring[i].latDeg - ring[0].latDeg);
    }
    return sum;
}

GeoRing box(double lonDeg, double latDeg, double widthDeg, double heightDeg) {
    return {{lonDeg, latDeg},
            {lonDeg + widthDeg, latDeg},
            {lonDeg + widthDeg, latDeg + heightDeg},
            {lonDeg, latDeg + heightDeg}};
}

FieldSource plainField() {
    FieldSource source;
    source.id = "north";
    source.name = "North Field";
    source.parts = {{.outer = box(9.0, 52.0, 0.003, 0.002), .holes = {}}};
    return source;
}

FieldSource fieldWithEverything() {
    FieldSource source = plainField();
    source.name = "Höhe & \"Senke\" <an der Straße nach Süden, hinter dem Wald>";
    source.parts[0].holes = {{{9.001, 52.0005}, {9.001, 52.0008}, {9.0013, 52.0008}, {9.0013, 52.0005}}};
    source.parts.push_back({.outer = box(9.004, 52.0, 0.002, 0.002), .holes = {}});
    source.obstacles = {{.name = "Pylon",
                         .outline = {.outer = box(9.002, 52.001, 0.0001, 0.0001), .holes = {}},
                         .passable = false,
                         .buffer = metres(1.0)},
                        {.name = "Pylon",
                         .outline = {.outer = box(9.005, 52.001, 0.0001, 0.0001), .holes = {}},
                         .passable = true,
                         .buffer = metres(0.0)}};
    source.gates = {{.name = "Lane", .position = {9.0, 52.001}, .width = metres(6.0)}};
    return source;
}

FieldSource fieldOnTheAntimeridian() {
    FieldSource source;
    source.id = source.name = "Taveuni";
    source.parts = {{.outer = {{179.999, -16.8}, {-179.999, -16.8}, {-179.999, -16.798}, {179.999, -16.798}},
                     .holes = {}}};
    return source;
}

FieldSource farNorth() {
    FieldSource source;
    source.id = source.name = "80 degrees north";
    source.parts = {{.outer = box(20.0, 80.0, 0.012, 0.002), .holes = {}}};
    return source;
}

struct Case {
    const char* name;
    FieldSource (*field)();
};
constexpr Case kCases[] = {{"plain field", plainField},
                           {"holes, parts, obstacles, a gate", fieldWithEverything},
                           {"across the antimeridian", fieldOnTheAntimeridian},
                           {"80 degrees north", farNorth}};

std::shared_ptr<const Plan> planOf(const FieldSource& source,
                                   std::initializer_list<std::pair<const char*, const char*>> given = {}) {
    const auto field = Field::create(source);
    if (!field) {
        qWarning("%s", field.error().line().c_str());
        return nullptr;
    }
    Settings settings;
    for (const auto& [key, value] : given) {
        applySetting(settings, key, value).value();
    }
    const auto plan = makePlan({std::make_shared<const Field>(*field), machineLibrary().front(), settings});
    if (!plan) {
        qWarning("%s", plan.error().line().c_str());
        return nullptr;
    }
    return *plan;
}

/// What xmllint says to a file by one of the schemas; 0, too, where one of the two is not at hand.
int runLint(const char* schema, const QString& file) {
    const QString path = QStringLiteral(FURROW_SHARED_DATA_DIR "/schemas/%1").arg(QLatin1StringView{schema});
    QProcess lint;
    lint.start("xmllint", {"--noout", "--nonet", "--schema", path, file});
    if (!QFileInfo::exists(path) || !lint.waitForStarted()) {
        return 0;
    }
    if (!lint.waitForFinished()) {
        return -1;
    }
    if (lint.exitCode() != 0) {
        qWarning("%s", lint.readAllStandardError().constData());
    }
    return lint.exitCode();
}

/// A TASKDATA folder with this content, as a stick has it.
QString writeTaskData(const QTemporaryDir& folder, const std::string& xml) {
    const QString path = folder.filePath("TASKDATA.XML");
    std::ofstream{path.toStdString(), std::ios::binary} << xml;
    return path;
}

}  // namespace

class TestIsoxml : public QObject {
    Q_OBJECT

private slots:
    void holdsTheField_data();
    void holdsTheField();
    void obstaclesAndGates();
    void namesAreCutAndUnequal();
    void strangeNames_data();
    void strangeNames();
    void lineLiesOnTheLongestSwathOfItsTrack_data();
    void lineLiesOnTheLongestSwathOfItsTrack();
    void oneLineForEachDirection();
    void curvesAndPivots();
    void tramlinesAreLinesOfTheirOwn();
    void tramlinesBesideAPlus();
    void fieldsKeepWhatTheyAreKnownBy();
    void tasksForTerminalsThatWantThem();
    void numbersHaveNineDecimals();
    void fitsTheSchema_data();
    void fitsTheSchema();
    void anotherReaderFindsTheSame_data();
    void anotherReaderFindsTheSame();

private:
    static void addCases();
    static std::shared_ptr<const Plan> currentPlan();
    static void checkSchema(const Plan& plan);
};

void TestIsoxml::addCases() {
    QTest::addColumn<int>("index");
    for (int i = 0; i < static_cast<int>(std::size(kCases)); ++i) {
        QTest::newRow(kCases[i].name) << i;
    }
}

std::shared_ptr<const Plan> TestIsoxml::currentPlan() {
    QFETCH(int, index);
    return planOf(kCases[index].field());
}

void TestIsoxml::holdsTheField_data() {
    addCases();
}

void TestIsoxml::holdsTheField() {
    const auto plan = currentPlan();
    QVERIFY(plan);
    const std::string xml = isoxmlTaskData(*plan);
    QVERIFY(xml.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>"));
    const Element root = parsed(xml);
    QCOMPARE(root.tag, "ISO11783_TaskData");
    QCOMPARE(root.value("VersionMajor"), "4");
    QCOMPARE(root.value("VersionMinor"), "3");
    QCOMPARE(root.value("DataTransferOrigin"), "1");
    QCOMPARE(root.all("PFD").size(), 1);
    const Element field = root.all("PFD").first();
    QCOMPARE(field.value("A"), "PFD1");
    QCOMPARE(field.value("D"), QString::number(std::llround(plan->field().area().si())));
    const FieldSource& source = plan->field().source();
    QList<Element> boundaries;
    for (const Element& polygon : field.all("PLN")) {
        if (polygon.value("A") == "1") {
            boundaries.append(polygon);
        }
    }
    QCOMPARE(static_cast<std::size_t>(boundaries.size()), source.parts.size());
    for (qsizetype i = 0; i < boundaries.size(); ++i) {
        const GeoPolygon& part = source.parts[static_cast<std::size_t>(i)];
        const QList<Element> rings = boundaries[i].all("LSG");
        QCOMPARE(static_cast<std::size_t>(rings.size()), 1 + part.holes.size());
        QCOMPARE(rings[0].value("A"), "1");
        QVERIFY(sameRing(ringOf(rings[0]), part.outer));
        for (qsizetype hole = 1; hole < rings.size(); ++hole) {
            QCOMPARE(rings[hole].value("A"), "2");
            QVERIFY(sameRing(ringOf(rings[hole]), part.holes[static_cast<std::size_t>(hole - 1)]));
            QVERIFY(turning(ringOf(rings[hole])) < 0.0);
        }
        if (std::abs(part.outer[0].lonDeg) < 179.0) {
            QVERIFY(turning(ringOf(rings[0])) > 0.0);
        }
    }
}

void TestIsoxml::obstaclesAndGates() {
    const auto plan = planOf(fieldWithEverything());
    QVERIFY(plan);
    const Element field = parsed(isoxmlTaskData(*plan)).all("PFD").first();
    const QList<Element> polygons = field.all("PLN");
    // Two parts, two obstacles, and what is left inside the headland of each part.
    QCOMPARE(polygons.size(), 4 + static_cast<qsizetype>(plan->headland.mainland.size()));
    QCOMPARE(polygons[4].value("A"), "10");
    QVERIFY(sameRing(ringOf(polygons[4].all("LSG").first()),
                     plan->field().frame().toGeo(plan->headland.mainland.front().outer)));
    QCOMPARE(polygons[2].value("A"), "6");
    QCOMPARE(polygons[2].value("B"), "Pylon");
    QCOMPARE(polygons[3].value("A"), "8");
    QCOMPARE(polygons[3].value("B"), "Pylon 2");
    QVERIFY(sameRing(ringOf(polygons[2].all("LSG").first()), box(9.002, 52.001, 0.0001, 0.0001)));
    const QList<Element> gates = field.all("PNT");
    QCOMPARE(gates.size(), 1);
    QCOMPARE(gates[0].value("A"), "3");
    QCOMPARE(gates[0].value("B"), "Lane");
    QVERIFY(near({gates[0].value("D").toDouble(), gates[0].value("C").toDouble()}, {9.0, 52.001}));
}

void TestIsoxml::namesAreCutAndUnequal() {
    const auto plan = planOf(fieldWithEverything());
    QVERIFY(plan);
    const Element field = parsed(isoxmlTaskData(*plan)).all("PFD").first();
    // 32 characters, counted by hand; the blank at the end of the second is left out before " 2".
    QCOMPARE(field.value("C"), QString::fromUtf8("Höhe & \"Senke\" <an der Straße na"));
    QCOMPARE(field.all("PLN")[0].value("B"), field.value("C"));
    QCOMPARE(field.all("PLN")[1].value("B"), QString::fromUtf8("Höhe & \"Senke\" <an der Straße 2"));
}

void TestIsoxml::strangeNames_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QString>("written");
    QTest::newRow("empty") << QByteArray{} << "Field";
    QTest::newRow("control characters") << QByteArray{"A\x01\x1F" "B\n"} << "AB";
    QTest::newRow("not UTF-8") << QByteArray{"Stra\xDF" "e"} << "Stra?e";
    QTest::newRow("cut inside a character of UTF-8") << QByteArray{"Stra\xC3"} << "Stra?";
    QTest::newRow("characters of four bytes")
        << QString::fromUtf8("🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾").toUtf8()
        << QString::fromUtf8("🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾🌾");
    QTest::newRow("half of a pair") << QByteArray{"A\xED\xA0\x80"} << "A???";
}

void TestIsoxml::strangeNames() {
    QFETCH(QByteArray, name);
    QFETCH(QString, written);
    FieldSource source = plainField();
    source.name = name.toStdString();
    const auto plan = planOf(source);
    QVERIFY(plan);
    QCOMPARE(parsed(isoxmlTaskData(*plan)).all("PFD").first().value("C"), written);
}

void TestIsoxml::lineLiesOnTheLongestSwathOfItsTrack_data() {
    addCases();
}

void TestIsoxml::lineLiesOnTheLongestSwathOfItsTrack() {
    const auto plan = currentPlan();
    QVERIFY(plan);
    const Element field = parsed(isoxmlTaskData(*plan)).all("PFD").first();
    QCOMPARE(field.all("GGP").size(), 1);
    const Element group = field.all("GGP").first();
    QCOMPARE(group.value("A"), "GGP1");
    QCOMPARE(group.all("GPN").size(), 1);
    const Element pattern = group.all("GPN").first();
    QCOMPARE(pattern.value("A"), "GPN1");
    QCOMPARE(pattern.value("C"), "1");
    QCOMPARE(pattern.value("E"), "1");
    QCOMPARE(pattern.value("F"), "1");
    QCOMPARE(pattern.value("I"), "16");
    QCOMPARE(pattern.all("LSG").size(), 1);
    const Element line = pattern.all("LSG").first();
    QCOMPARE(line.value("A"), "5");
    QCOMPARE(line.value("C"), "2500");  // the AgBot's 2.5 m
    const QList<Element> points = line.all("PNT");
    QCOMPARE(points.size(), 2);
    QCOMPARE(points[0].value("A"), "6");
    QCOMPARE(points[1].value("A"), "7");
    const Swath* longest = &plan->swaths.swaths.front();
    for (const Swath& swath : plan->swaths.swaths) {
        if (swath.track == longest->track && swath.length() > longest->length()) {
            longest = &swath;
        }
    }
    const GeoRing ends = ringOf(line);
    QVERIFY(near(ends[0], plan->field().frame().toGeo(longest->start)));
    QVERIFY(near(ends[1], plan->field().frame().toGeo(longest->end)));
    // The heading by the plain formula on a sphere; the flattening of the earth turns it by up to 0.2
    // degrees.
    const double east =
        std::remainder(ends[1].lonDeg - ends[0].lonDeg, 360.0) * std::cos(ends[0].latDeg * M_PI / 180.0);
    const double north = ends[1].latDeg - ends[0].latDeg;
    const double bearing = std::fmod(std::atan2(east, north) * 180.0 / M_PI + 360.0, 360.0);
    const double written = pattern.value("G").toDouble();
    QVERIFY2(written >= 0.0 && written < 360.0, qPrintable(pattern.value("G")));
    QVERIFY2(std::abs(std::remainder(written - bearing, 360.0)) < 0.25,
             std::format("{} instead of {}", written, bearing).c_str());
}

void TestIsoxml::oneLineForEachDirection() {
    Plan plan = *planOf(plainField());
    const auto swath = [](Point from, Point to, int track) {
        return Swath{.start = from, .end = to, .number = 0, .track = track, .width = metres(2.5)};
    };
    plan.swaths.swaths = {swath({0, 0}, {10, 0}, 0),     swath({20, 0}, {50, 0}, 0),
                          swath({0, 2.5}, {90, 2.5}, 1), swath({0, 9}, {0, 40}, 2),
                          swath({90, 5}, {0, 5}, 3),     swath({3, 40}, {3, 0}, 4)};
    const Element field = parsed(isoxmlTaskData(plan)).all("PFD").first();
    QCOMPARE(field.all("GGP").size(), 2);
    const GeoRing eastward = ringOf(field.all("GGP")[0].all("GPN").first().all("LSG").first());
    QVERIFY(near(eastward[0], plan.field().frame().toGeo(Point{20, 0})));
    QVERIFY(near(eastward[1], plan.field().frame().toGeo(Point{50, 0})));
    QCOMPARE(field.all("GGP")[0].all("GPN").first().value("G"), "90.0000");
    QCOMPARE(field.all("GGP")[1].all("GPN").first().value("G"), "0.0000");
    QCOMPARE(field.all("GGP")[1].value("A"), "GGP2");
}

void TestIsoxml::numbersHaveNineDecimals() {
    const auto plan = planOf(fieldWithEverything());
    QVERIFY(plan);
    const std::string xml = isoxmlTaskData(*plan);
    static const std::regex point{R"x(<PNT A="\d+" C="([^"]*)" D="([^"]*)")x"};
    static const std::regex number{R"(-?\d{1,3}\.\d{9})"};
    int points = 0;
    for (std::sregex_iterator found{xml.begin(), xml.end(), point}, none; found != none; ++found, ++points) {
        QVERIFY2(std::regex_match((*found)[1].str(), number), (*found)[1].str().c_str());
        QVERIFY2(std::regex_match((*found)[2].str(), number), (*found)[2].str().c_str());
    }
    // Rings of four, closed: two parts, a hole, two obstacles; a gate and an AB line; the mainland's rings.
    qsizetype mainland = 0;
    for (const Polygon& polygon : plan->headland.mainland) {
        mainland += static_cast<qsizetype>(polygon.outer.size()) + 1;
        for (const Ring& hole : polygon.holes) {
            mainland += static_cast<qsizetype>(hole.size()) + 1;
        }
    }
    QCOMPARE(points, 5 * 5 + 1 + 2 + mainland);
}

void TestIsoxml::fitsTheSchema_data() {
    addCases();
}

void TestIsoxml::fitsTheSchema() {
    const auto plan = currentPlan();
    QVERIFY(plan);
    checkSchema(*plan);
}

// formats.md: type 3 is a curve from point 6 over points 9 to point 7; type 4 with option 3 a full circle about point 8
// with its radius in millimetres. One stands for all that lie beside it.
void TestIsoxml::curvesAndPivots() {
    const auto curve = planOf(plainField(), {{"swaths.method", "ab-curve"},
                                             {"swaths.line", "LINESTRING ("
                                              "9.000500 52.000800, 9.000667 52.000818, 9.000833 52.000833, 9.001000 52.000845, 9.001167 52.000853, "
                                              "9.001333 52.000858, 9.001500 52.000860, 9.001667 52.000858, 9.001833 52.000853, "
                                              "9.002000 52.000845, 9.002167 52.000833, 9.002333 52.000818, 9.002500 52.000800)"}});
    QVERIFY(curve);
    const QList<Element> curves = parsed(isoxmlTaskData(*curve)).all("PFD").first().all("GGP");
    // And those whose bends are lost to the inside.
    QVERIFY(!curves.isEmpty() && curves.size() < 5);
    const Element pattern = curves.first().all("GPN").first();
    QCOMPARE(pattern.value("C"), "3");
    QCOMPARE(pattern.value("E"), "1");
    const QList<Element> points = pattern.all("LSG").first().all("PNT");
    QVERIFY(points.size() > 2);
    for (qsizetype i = 0; i < points.size(); ++i) {
        QCOMPARE(points[i].value("A"), i == 0 ? "6" : i + 1 == points.size() ? "7" : "9");
    }
    checkSchema(*curve);

    // A round field: rings only.
    FieldSource round = plainField();
    round.parts.front().outer.clear();
    for (int i = 0; i < 90; ++i) {
        const double angle = i * M_PI / 45.0;
        round.parts.front().outer.push_back({9.0 + 0.0015 * std::cos(angle), 52.0 + 0.0015 * std::cos(52.0 * M_PI / 180.0) * std::sin(angle)});
    }
    const auto pivot = planOf(round, {{"swaths.method", "pivot"}, {"swaths.line", "POINT (9 52)"}});
    QVERIFY(pivot);
    QVERIFY(pivot->swaths.swaths[3].isClosed());
    bool found = false;
    for (const Element& group : parsed(isoxmlTaskData(*pivot)).all("PFD").first().all("GGP")) {
        const Element ring = group.all("GPN").first();
        if (ring.value("C") == "4") {
            QVERIFY(!found);
            found = true;
            QCOMPARE(ring.value("D"), "3");
            const double radiusM = pivot->swaths.swaths.front().isClosed() ? pivot->swaths.swaths.front().length().si() / (2.0 * M_PI) : 0.0;
            if (radiusM > 0.0) {
                QVERIFY(std::abs(ring.value("H").toDouble() - 1000.0 * radiusM) <= 1.0);
            }
            QCOMPARE(ring.all("LSG").first().all("PNT").size(), 1);
            QCOMPARE(ring.all("LSG").first().all("PNT").first().value("A"), "8");
        }
    }
    QVERIFY(found);
    checkSchema(*pivot);
}

// Beside the AB line a group for each tramline, which is not laid beside itself (propagation 4).
void TestIsoxml::tramlinesAreLinesOfTheirOwn() {
    const auto plan = planOf(plainField(), {{"swaths.tramline_every", "8"}});
    QVERIFY(plan);
    const auto tramlines = std::ranges::count_if(plan->swaths.swaths, &Swath::tramline);
    QVERIFY(tramlines > 3);
    int written = 0;
    for (const Element& group : parsed(isoxmlTaskData(*plan)).all("PFD").first().all("GGP")) {
        if (group.value("B").startsWith("Tramline")) {
            ++written;
            QCOMPARE(group.all("GPN").first().value("C"), "1");
            QCOMPARE(group.all("GPN").first().value("E"), "4");
        }
    }
    QCOMPARE(written, tramlines);
    checkSchema(*plan);
}

void TestIsoxml::tramlinesBesideAPlus() {
    const auto plan = planOf(plainField(), {{"swaths.method", "a-plus"},
                                            {"swaths.line", "POINT(9.0005 52.0005)"},
                                            {"swaths.angle_deg", "30"},
                                            {"swaths.tramline_every", "8"}});
    QVERIFY(plan);
    const auto tramlines = std::ranges::count_if(plan->swaths.swaths, &Swath::tramline);
    QVERIFY(tramlines > 3);
    qsizetype once = 0;
    qsizetype aPlus = 0;
    for (const Element& group : parsed(isoxmlTaskData(*plan)).all("PFD").first().all("GGP")) {
        const Element pattern = group.all("GPN").first();
        aPlus += pattern.value("C") == "2" && pattern.value("E") == "1" && pattern.value("G") == "60.0000" ? 1 : 0;
        once += pattern.value("C") == "1" && pattern.value("E") == "4" ? 1 : 0;
    }
    QCOMPARE(aPlus, 1);
    QCOMPARE(once, tramlines);
    checkSchema(*plan);
}

void TestIsoxml::fieldsKeepWhatTheyAreKnownBy() {
    // What another program knows it by; the sample of the format notes.
    FieldContent known{.field = plainField()};
    known.field.id = "{6F1D3C52-0C1E-4B7A-9B1D-4C3A2F0E9D10}";
    FieldContent drawn{.field = plainField()};
    const std::vector fields{known, drawn};
    const ExportJob job{.fields = fields};
    const auto made = writeIsoxml4(job);
    QVERIFY(made);
    QCOMPARE(made->files.size(), 2U);
    QCOMPARE(made->files[1].path.string(), "TASKDATA/LINKLIST.XML");
    const Element list = parsed(made->files[1].text());
    const QList<Element> links = list.all("LGP").first().all("LNK");
    QCOMPARE(list.all("LGP").first().value("B"), "1");
    QCOMPARE(links.size(), 2);
    QCOMPARE(links[0].value("A"), "PFD1");
    QCOMPARE(links[0].value("B"), "{6f1d3c52-0c1e-4b7a-9b1d-4c3a2f0e9d10}");
    static const QRegularExpression uuid{QStringLiteral(R"(^\{[0-9a-f]{8}-[0-9a-f]{4}-8[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}\}$)")};
    QVERIFY2(uuid.match(links[1].value("B")).hasMatch(), qPrintable(links[1].value("B")));
    // The task data names the list, or nobody reads it; version 3 knows none.
    QCOMPARE(parsed(made->files[0].text()).all("AFE").first().value("A"), "LINKLIST.XML");
    QCOMPARE(writeIsoxml3(job)->files.size(), 1U);
    QVERIFY(parsed(writeIsoxml3(job)->files[0].text()).all("AFE").isEmpty());
    // Another export has the same ones, and what is read keeps them.
    const QTemporaryDir folder;
    for (const FileToWrite& file : made->files) {
        std::ofstream{folder.filePath(QString::fromStdString(file.path.filename().string())).toStdString(), std::ios::binary} << file.text();
    }
    const auto read = readBoundaries(folder.filePath("TASKDATA.XML").toStdString());
    QVERIFY(read);
    QCOMPARE(read->size(), 2U);
    const std::vector again{FieldContent{.field = (*read)[0]}, FieldContent{.field = (*read)[1]}};
    QCOMPARE(writeIsoxml4({.fields = again})->files[1].text(), made->files[1].text());
    QCOMPARE(runLint("ISO11783_LinkListFile_V4-3.xsd", folder.filePath("LINKLIST.XML")), 0);
}

void TestIsoxml::tasksForTerminalsThatWantThem() {
    const auto plan = planOf(plainField());
    QVERIFY(plan);
    const std::vector fields{contentOf(*plan)};
    for (const IsoxmlVersion version : {IsoxmlVersion::V3, IsoxmlVersion::V4}) {
        const std::string xml = isoxmlText(fields, version, {.task = true});
        const Element task = parsed(xml).all("TSK").first();
        QCOMPARE(task.value("A"), "TSK1");
        QCOMPARE(task.value("B"), "North Field");
        QCOMPARE(task.value("E"), "PFD1");
        QCOMPARE(task.value("G"), "1");
        QCOMPARE(task.all("GAN").size(), version == IsoxmlVersion::V4 ? 1 : 0);
        const QTemporaryDir folder;
        QCOMPARE(runLint(version == IsoxmlVersion::V4 ? "ISO11783_TaskFile_V4-3.xsd" : "ISO11783_TaskFile_V3-3.xsd",
                         writeTaskData(folder, xml)), 0);
        QVERIFY(parsed(isoxmlText(fields, version)).all("TSK").isEmpty());
    }
}

void TestIsoxml::checkSchema(const Plan& given) {
    const Plan* const plan = &given;
    const QString schema = QStringLiteral(FURROW_SHARED_DATA_DIR "/schemas/ISO11783_TaskFile_V4-3.xsd");
    if (!QFileInfo::exists(schema) || QStandardPaths::findExecutable("xmllint").isEmpty()) {
        QSKIP("needs xmllint and the schemas in ../shared/data/schemas");
    }
    const QTemporaryDir folder;
    QProcess lint;
    lint.start("xmllint",
               {"--noout", "--nonet", "--schema", schema, writeTaskData(folder, isoxmlTaskData(*plan))});
    QVERIFY(lint.waitForFinished());
    QVERIFY2(lint.exitCode() == 0, lint.readAllStandardError().constData());
}

void TestIsoxml::anotherReaderFindsTheSame_data() {
    addCases();
}

void TestIsoxml::anotherReaderFindsTheSame() {
    const QString modules = qEnvironmentVariable("FURROW_NODE_MODULES");
    if (modules.isEmpty() || !QFileInfo::exists(modules + "/isoxml") ||
        QStandardPaths::findExecutable("node").isEmpty()) {
        QSKIP("needs node and the packages of tests/validators (see packaging/setup)");
    }
    const auto plan = currentPlan();
    QVERIFY(plan);
    const QTemporaryDir folder;
    writeTaskData(folder, isoxmlTaskData(*plan));
    QProcess node;
    node.start("node",
               {QStringLiteral(FURROW_SOURCE_DIR "/tests/validators/isoxml_check.js"), folder.path()});
    QVERIFY(node.waitForFinished(60000));
    const QByteArray output = node.readAllStandardOutput();
    QVERIFY2(node.exitCode() == 0, (output + node.readAllStandardError()).constData());
    const QJsonObject read = QJsonDocument::fromJson(output).object();
    QCOMPARE(read["version"].toInt(), 4);
    const QJsonObject field = read["fields"].toArray().first().toObject();
    const FieldSource& source = plan->field().source();
    QCOMPARE(field["area"].toInteger(), std::llround(plan->field().area().si()));
    const QJsonArray polygons = field["polygons"].toArray();
    QCOMPARE(static_cast<std::size_t>(polygons.size()),
             source.parts.size() + source.obstacles.size() + plan->headland.mainland.size());
    for (std::size_t i = 0; i < source.parts.size(); ++i) {
        GeoRing outer;
        const QJsonArray rings = polygons[static_cast<qsizetype>(i)].toObject()["rings"].toArray();
        QCOMPARE(static_cast<std::size_t>(rings.size()), 1 + source.parts[i].holes.size());
        for (const QJsonValue& point : rings.first().toObject()["points"].toArray()) {
            outer.push_back({point["lon"].toDouble(), point["lat"].toDouble()});
        }
        QVERIFY(sameRing(outer, source.parts[i].outer));
    }
    QCOMPARE(static_cast<std::size_t>(field["gates"].toArray().size()), source.gates.size());
    QCOMPARE(field["lines"].toArray().size(), 1);
    QCOMPARE(field["lines"].toArray().first().toObject()["width"].toInt(), 2500);
}

QTEST_GUILESS_MAIN(TestIsoxml)
#include "tst_isoxml.moc"
