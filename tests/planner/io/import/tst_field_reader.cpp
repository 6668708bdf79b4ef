#include "planner/gdal/zip.h"
#include "planner/io/files/file_names.h"
#include "planner/io/formats/agopengps/agopengps_plane.h"
#include "planner/io/formats/isoxml/isoxml_writer.h"
#include "planner/io/import/boundary_import.h"
#include "planner/io/import/field_reader.h"
#include "tests/planner/io/format_cases.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using namespace furrow;
using namespace furrow::test;

namespace {

namespace fs = std::filesystem;

const std::string kRing =
    R"(<PNT A="2" C="52.0" D="9.0"/><PNT A="2" C="52.0" D="9.003"/><PNT A="2" C="52.002" D="9.003"/><PNT A="2" C="52.002" D="9.0"/>)";
const std::string kHole =
    R"(<LSG A="2"><PNT A="2" C="52.0005" D="9.001"/><PNT A="2" C="52.0008" D="9.001"/><PNT A="2" C="52.0008" D="9.0013"/><PNT A="2" C="52.0005" D="9.001"/></LSG>)";

std::string taskData(const std::string& inside, const std::string& version = "4") {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?><ISO11783_TaskData VersionMajor=\"" + version +
           "\" VersionMinor=\"3\" ManagementSoftwareManufacturer=\"x\" ManagementSoftwareVersion=\"1\" "
           "DataTransferOrigin=\"1\">" +
           inside + "</ISO11783_TaskData>";
}
std::string field(const std::string& inside) {
    return R"(<PFD A="PFD1" C="North" D="0">)" + inside + "</PFD>";
}
std::string boundary(const std::string& ring = kRing, const std::string& kind = "1") {
    return "<PLN A=\"" + kind + "\"><LSG A=\"1\">" + ring + "</LSG></PLN>";
}
std::string pattern(const std::string& attributes, const std::string& points) {
    return R"(<GGP A="GGP1"><GPN A="GPN1" B="line" )" + attributes + R"(><LSG A="5" C="6000">)" + points +
           "</LSG></GPN></GGP>";
}

/// What is read of a field in task data.
void row(const char* name, const std::string& xml, int parts, int holes = 0, int obstacles = 0, int lines = 0,
         int notes = 0) {
    QTest::newRow(name) << QByteArray::fromStdString(xml) << parts << holes << obstacles << lines << notes;
}

}  // namespace

/// What real files do that no schema allows, and what files made to do harm do.
class FieldReaderTest : public QObject {
    Q_OBJECT

    static void addRings() {
        row("ring not closed", taskData(field(boundary())), 1);
        row("ring closed", taskData(field(boundary(kRing + R"(<PNT A="2" C="52.0" D="9.0"/>)"))), 1);
        row("ring closed twice",
            taskData(
                field(boundary(kRing + R"(<PNT A="2" C="52.0" D="9.0"/><PNT A="2" C="52.0" D="9.0"/>)"))),
            1);
        row("byte order mark", "\xEF\xBB\xBF" + taskData(field(boundary())), 1);
        row("point types 10 in version 3",
            taskData(
                field(boundary(
                    R"(<PNT A="10" C="52.0" D="9.0"/><PNT A="10" C="52.0" D="9.003"/><PNT A="10" C="52.002" D="9.003"/>)")),
                "3"),
            1);
        row("13 decimals, id of a machine",
            taskData(
                R"(<PFD A="PFD-1" C="x" D="0">)" +
                boundary(
                    R"(<PNT A="2" C="52.0000000000001" D="9.0"/><PNT A="2" C="52.0" D="9.003"/><PNT A="2" C="52.002" D="9.003"/>)") +
                "</PFD>"),
            1);
        row("proprietary attributes",
            taskData(R"(<PFD A="PFD1" C="x" D="0" P094_Thing="1">)" + boundary() + "</PFD>"), 1);
    }
    static void addHolesAndObstacles() {
        row("hole as inner ring",
            taskData(field(R"(<PLN A="1"><LSG A="1">)" + kRing + "</LSG>" + kHole + "</PLN>")), 1, 1);
        row("hole as obstacle",
            taskData(field(
                boundary() +
                R"(<PLN A="6" B="pond"><LSG A="1"><PNT A="2" C="52.0005" D="9.001"/><PNT A="2" C="52.0008" D="9.001"/><PNT A="2" C="52.0008" D="9.0013"/></LSG></PLN>)")),
            1, 0, 1);
        row("hole told twice",
            taskData(field(
                R"(<PLN A="1"><LSG A="1">)" + kRing + "</LSG>" + kHole +
                R"(</PLN><PLN A="6"><LSG A="1"><PNT A="2" C="52.0005" D="9.001"/><PNT A="2" C="52.0008" D="9.001"/><PNT A="2" C="52.0008" D="9.0013"/></LSG></PLN>)")),
            1, 1, 0, 0, 1);
        row("two outer rings in one polygon",
            taskData(field(
                R"(<PLN A="1"><LSG A="1">)" + kRing +
                R"(</LSG><LSG A="1"><PNT A="2" C="52.0" D="9.005"/><PNT A="2" C="52.0" D="9.006"/><PNT A="2" C="52.001" D="9.006"/></LSG></PLN>)")),
            2);
        row("main field instead of boundary", taskData(field(boundary(kRing, "9"))), 1);
    }
    static void addGuidance() {
        row("boundary in the guidance group only",
            taskData(field(R"(<GGP A="GGP1">)" + boundary() + "</GGP>")), 1, 0, 0, 0, 1);
        row("guidance in version 3",
            taskData(
                field(
                    boundary() +
                    R"(<LSG A="5" B="l"><PNT A="2" C="52.001" D="9.0"/><PNT A="2" C="52.001" D="9.003"/></LSG>)"),
                "3"),
            1, 0, 0, 1);
        row("guidance group in version 3",
            taskData(field(boundary() +
                           pattern(R"(C="1")",
                                   R"(<PNT A="6" C="52.001" D="9.0"/><PNT A="7" C="52.001" D="9.003"/>)")),
                     "3"),
            1, 0, 0, 1);
        row("pattern without a line",
            taskData(field(boundary() + R"(<GGP A="GGP1"><GPN A="GPN1" C="3"/></GGP>)")), 1, 0, 0, 0, 1);
        row("line with a decimal comma",
            taskData(
                field(boundary() +
                      R"(<LSG A="5"><PNT A="2" C="52,001" D="9.0"/><PNT A="2" C="52.001" D="9.003"/></LSG>)"),
                "3"),
            1, 0, 0, 0, 2);
        row("line with an exponent",
            taskData(
                field(
                    boundary() +
                    R"(<LSG A="5"><PNT A="2" C="5.2001e1" D="9.0"/><PNT A="2" C="52.001" D="9.003"/></LSG>)"),
                "3"),
            1, 0, 0, 0, 2);
        row("a field without boundary beside one with",
            taskData(field(boundary()) + R"(<PFD A="PFD2" C="South" D="0"/>)"), 1, 0, 0, 0, 1);
    }

private slots:
    void readsTaskData_data() {
        QTest::addColumn<QByteArray>("xml");
        QTest::addColumn<int>("parts");
        QTest::addColumn<int>("holes");
        QTest::addColumn<int>("obstacles");
        QTest::addColumn<int>("lines");
        QTest::addColumn<int>("notes");
        addRings();
        addHolesAndObstacles();
        addGuidance();
    }

    void readsTaskData() {
        QFETCH(QByteArray, xml);
        QFETCH(int, parts);
        QFETCH(int, holes);
        QFETCH(int, obstacles);
        QFETCH(int, lines);
        QFETCH(int, notes);
        const Scratch scratch;
        // The name does not matter where the content says what it is.
        const auto read = readFields(scratch.write("taskdata.Xml", xml.toStdString()));
        VERIFY_RESULT(read);
        QCOMPARE(read->fields.size(), 1U);
        const FieldContent& content = read->fields.front();
        QCOMPARE(static_cast<int>(content.field.parts.size()), parts);
        QCOMPARE(static_cast<int>(content.field.parts[0].holes.size()), holes);
        QCOMPARE(static_cast<int>(content.field.obstacles.size()), obstacles);
        QCOMPARE(static_cast<int>(content.lines.size()), lines);
        QVERIFY2(static_cast<int>(read->notes.size()) == notes,
                 read->notes.empty() ? "none" : read->notes.front().text.c_str());
        QVERIFY(content.field.parts[0].outer.size() >= 3 && content.field.parts[0].outer.size() <= 4);
        QVERIFY(metresBetween(content.field.parts[0].outer[0], {9.0, 52.0}) < 0.001);
    }

    void refusesTaskData_data() {
        QTest::addColumn<QByteArray>("xml");
        QTest::addColumn<QString>("why");
        QTest::newRow("no field") << QByteArray::fromStdString(taskData(""))
                                  << "there is no field in this task data";
        QTest::newRow("nothing but a name")
            << QByteArray::fromStdString(taskData(R"(<PFD A="PFD1" C="x" D="0"/>)"))
            << "neither boundary nor guidance";
        QTest::newRow("cut off") << QByteArray::fromStdString(taskData(field(boundary())).substr(0, 300))
                                 << "not XML from here on";
        QTest::newRow("two corners")
            << QByteArray::fromStdString(taskData(
                   field(boundary(R"(<PNT A="2" C="52.0" D="9.0"/><PNT A="2" C="52.0" D="9.003"/>)"))))
            << "neither boundary";
        QTest::newRow("latitude of 95")
            << QByteArray::fromStdString(taskData(field(boundary(
                   R"(<PNT A="2" C="95.0" D="9.0"/><PNT A="2" C="52.0" D="9.003"/><PNT A="2" C="52.002" D="9.003"/>)"))))
            << "neither boundary";
    }
    void refusesTaskData() {
        QFETCH(QByteArray, xml);
        QFETCH(QString, why);
        const Scratch scratch;
        const auto read = readFields(scratch.write("TASKDATA.XML", xml.toStdString()));
        QVERIFY(!read);
        QVERIFY2(read.error().line().contains(why.toStdString()), read.error().line().c_str());
        QVERIFY(!read.error().remedy.empty());
    }

    void partsInFilesOfTheirOwn() {
        const Scratch scratch;
        scratch.write("TASKDATA/TASKDATA.XML",
                      taskData(R"(<XFR A="PFD00000" B="1"/><XFR A="PFD00007" B="1"/>)"));
        scratch.write("TASKDATA/pfd00000.xml",
                      R"(<?xml version="1.0"?><XFC>)" + field(boundary()) + "</XFC>");
        const auto read = readFields(scratch.path("TASKDATA"));
        VERIFY_RESULT(read);
        QCOMPARE(read->fields.size(), 1U);
        QCOMPARE(read->notes.size(), 1U);  // the second file is missing
    }

    void neverLeavesItsFolder() {
        const Scratch scratch;
        scratch.write("PFDsecret.xml", "<XFC>" + field(boundary()) + "</XFC>");
        const auto read = readFields(
            scratch.write("in/TASKDATA.XML",
                          taskData(R"(<XFR A="PFD/../../PFDsecret" B="1"/><XFR A="PFDsecret" B="1"/>)")));
        QVERIFY(!read);
        QVERIFY(read.error().what.contains("no field"));
    }

    void xmlNamesNoOtherFiles_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("document");
        const QByteArray dtd = "<!DOCTYPE x [<!ENTITY e SYSTEM \"file://%1\">]>";
        QTest::newRow("task data")
            << "TASKDATA.XML"
            << "<?xml version=\"1.0\"?>" + dtd +
                   QByteArray::fromStdString(
                       taskData(R"(<PFD A="PFD1" C="&e;" D="0">)" + boundary() + "</PFD>").substr(38));
        QTest::newRow("KML")
            << "f.kml"
            << "<?xml version=\"1.0\"?>" + dtd +
                   "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><Placemark><name>&e;</name><Polygon><outerBoundaryIs><LinearRing>"
                   "<coordinates>9,52 9.003,52 9.003,52.002 9,52</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark></Document></kml>";
        QTest::newRow("GML of Fields2Cover")
            << "f.gml"
            << "<?xml version=\"1.0\"?>" + dtd +
                   "<GAOS_parcel xmlns:gml=\"http://www.opengis.net/gml\"><name>&e;</name><Field><geometry><gml:Polygon srsName=\"EPSG:4326\"><gml:outerBoundaryIs>"
                   "<gml:LinearRing><gml:coordinates>9,52 9.003,52 9.003,52.002 9,52</gml:coordinates></gml:LinearRing></gml:outerBoundaryIs></gml:Polygon></geometry></Field></GAOS_parcel>";
        QTest::newRow("GPX")
            << "f.gpx"
            << "<?xml version=\"1.0\"?>" + dtd +
                   "<gpx version=\"1.1\" xmlns=\"http://www.topografix.com/GPX/1/1\"><trk><name>&e;</name><trkseg><trkpt lat=\"52\" lon=\"9\"/><trkpt lat=\"52\" lon=\"9.003\"/>"
                   "<trkpt lat=\"52.002\" lon=\"9.003\"/><trkpt lat=\"52\" lon=\"9\"/></trkseg></trk></gpx>";
    }
    void xmlNamesNoOtherFiles() {
        QFETCH(QString, name);
        QFETCH(QByteArray, document);
        const Scratch scratch;
        const fs::path secret = scratch.write("secret.txt", "the content of another file");
        const std::string text =
            QString::fromUtf8(document).arg(QString::fromStdString(secret.string())).toStdString();
        const auto read = readFields(scratch.write(name.toStdString(), text));
        const auto leaks = [](const std::string& told) { return told.contains("another file"); };
        if (!read) {
            QVERIFY(!leaks(read.error().line()));
            return;
        }
        for (const FieldContent& content : read->fields) {
            QVERIFY2(!leaks(content.field.name), content.field.name.c_str());
        }
    }

    void entitiesDoNotGrow() {
        std::string dtd = "<!DOCTYPE k [<!ENTITY a \"aaaaaaaaaa\">";
        char last = 'a';
        for (char next = 'b'; next <= 'm'; last = next++) {
            dtd += std::format("<!ENTITY {} \"", next);
            for (int i = 0; i < 10; ++i) {
                dtd += std::format("&{};", last);
            }
            dtd += "\">";
        }
        const std::string inside =
            "<Document><Placemark><name>&m;</name><Polygon><outerBoundaryIs><LinearRing><coordinates>9,52 9.003,52 "
            "9.003,52.002 9,52</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark></Document>";
        const Scratch scratch;
        const auto read = readFields(scratch.write(
            "f.kml", "<?xml version=\"1.0\"?>" + dtd + "]><kml xmlns=\"http://www.opengis.net/kml/2.2\">" +
                         inside + "</kml>"));
        QVERIFY(!read || read->fields.front().field.name.size() < 10'000);
    }

    void zipsThatGrowAreRefused() {
        const Scratch scratch;
        // 200 MB of zeros become some 200 kB.
        const std::string zeros(std::size_t{200} << 20, '0');
        const std::vector<FileInMemory> files{{"TASKDATA/TASKDATA.XML", zeros}};
        const auto zip = zipOf(files);
        VERIFY_RESULT(zip);
        QVERIFY(zip->size() * 1000 < zeros.size());
        for (const char* name : {"t.zip", "t.kmz"}) {
            const auto read = readFields(scratch.write(name, *zip));
            QVERIFY2(!read, name);
            QVERIFY2(read.error().what.contains("hundredfold"), read.error().line().c_str());
        }
    }

    void namesStayInTheirFolder_data() {
        QTest::addColumn<QByteArray>("given");
        QTest::addColumn<QString>("name");
        QTest::newRow("plain") << QByteArray{"Home Field"} << "Home Field";
        QTest::newRow("up and away") << QByteArray{"../../etc/passwd"} << "_.._etc_passwd";
        QTest::newRow("dots") << QByteArray{".."} << "Field";
        QTest::newRow("absolute") << QByteArray{"/etc"} << "_etc";
        QTest::newRow("a drive") << QByteArray{"C:\\x"} << "C__x";
        QTest::newRow("a device") << QByteArray{"CON"} << "CON_";
        QTest::newRow("a device with an ending") << QByteArray{"com1.txt"} << "com1_.txt";
        QTest::newRow("no device") << QByteArray{"nul.txt"} << "nul_.txt";
        QTest::newRow("a device and a blank") << QByteArray{"nul .txt"} << "nul _.txt";
        QTest::newRow("control characters") << QByteArray{"a\nb"} << "a_b";
        QTest::newRow("empty") << QByteArray{} << "Field";
        QTest::newRow("umlauts") << QByteArray{"Höhe"} << QString::fromUtf8("Höhe");
        QTest::newRow("no UTF-8") << QByteArray{"H\xF6he"} << "H_he";
        QTest::newRow("long") << QByteArray(300, 'x') << QString(60, 'x');
        QTest::newRow("an end that is a blank") << QByteArray{"x. "} << "x";
    }
    void namesStayInTheirFolder() {
        QFETCH(QByteArray, given);
        QFETCH(QString, name);
        QCOMPARE(QString::fromStdString(safeFileName(given.toStdString(), "Field")), name);
    }

    void asciiNames() {
        QCOMPARE(asciiText("Höhe & Größe ńżé"), "Hoehe _ Groesse nze");
        UniqueNames names{12, true};
        QCOMPARE(names.unique("Größe im Süden", "x"), "Groesse im S");
        QCOMPARE(names.unique("Größe im Sand", "x"), "Groesse im 2");
    }

    void planeOfAgOpenGps() {
        // Worked by its own class.
        const AgOpenGpsPlane plane{{5.66, 52.09}};
        const GeoPoint place = plane.toGeo({-100.0, -60.0});
        COMPARE_WITHIN(place.latDeg, 52.089460766, 5e-10);
        COMPARE_WITHIN(place.lonDeg, 5.658541019, 5e-10);
        const Point back = plane.toLocal(place);
        COMPARE_WITHIN(back.x, -100.0, 1e-6);
        COMPARE_WITHIN(back.y, -60.0, 1e-6);
    }

    void agOpenGpsVariants_data() {
        QTest::addColumn<QByteArray>("place");
        QTest::addColumn<QByteArray>("boundary");
        QTest::addColumn<int>("holes");
        QTest::addColumn<int>("passable");
        const QByteArray head =
            "2026-January-05\r\n$FieldDir\r\nx\r\n$Offsets\r\n0,0\r\nConvergence\r\n0\r\nStartFix\r\n";
        const QByteArray square = "4\r\n0,0,1.57\r\n100,0,0\r\n100,100,0\r\n0,100,0\r\n";
        const QByteArray small = "4\r\n20,20,0\r\n40,20,0\r\n40,40,0\r\n20,40,0\r\n";
        QTest::newRow("as written") << head + "52.09,5.66\r\n"
                                    << "$Boundary\r\nFalse\r\n" + square + "False\r\n" + small << 1 << 0;
        QTest::newRow("flag twice") << head + "52.09,5.66\r\n"
                                    << "$Boundary\r\nFalse\r\nFalse\r\n" + square << 0 << 0;
        QTest::newRow("decimal commas") << head + "52,0900,5,6600\r\n"
                                        << "$Boundary\r\nFalse\r\n" + square << 0 << 0;
        QTest::newRow("drive through") << head + "52.09,5.66\r\n"
                                       << "$Boundary\r\nFalse\r\n" + square + "True\r\n" + small << 0 << 1;
        QTest::newRow("LF only, no flags")
            << QByteArray{head + "52.09,5.66\r\n"}.replace("\r", "")
            << QByteArray{"$Boundary\n" + square + small}.replace("\r", "") << 1 << 0;
    }
    void agOpenGpsVariants() {
        QFETCH(QByteArray, place);
        QFETCH(QByteArray, boundary);
        QFETCH(int, holes);
        QFETCH(int, passable);
        const Scratch scratch;
        scratch.write("My Field/Field.txt", place.toStdString());
        scratch.write("My Field/Boundary.Txt", boundary.toStdString());
        for (const char* given : {"My Field", "My Field/Boundary.Txt", ""}) {
            const auto read = readFields(scratch.path(given));
            VERIFY_RESULT(read);
            QCOMPARE(read->fields.size(), 1U);
            const FieldSource& field = read->fields[0].field;
            QCOMPARE(field.name, "My Field");
            QCOMPARE(static_cast<int>(field.parts[0].holes.size()), holes);
            QCOMPARE(static_cast<int>(field.obstacles.size()), passable);
            QVERIFY(metresBetween(field.parts[0].outer[0], {5.66, 52.09}) < 0.001);
            COMPARE_WITHIN(areaOf(field).si(), 1e4 - 400.0 * holes, 30.0);
        }
    }

    void damagedBoundaryIsRefusedWithItsLine() {
        const Scratch scratch;
        scratch.write("F/Field.txt", "StartFix\n52.09,5.66\n");
        scratch.write("F/Boundary.txt", "$Boundary\nFalse\n99999\n0,0,0\n");
        const auto read = readFields(scratch.path("F"));
        QVERIFY(!read);
        QVERIFY2(read.error().where.contains("Boundary.txt, line"), read.error().line().c_str());
    }

    void rasterMask() {
        // 40 by 30 pixels of 5 m in UTM 32: worked from column 5 to 34 and row 5 to 24, with a hole of 6 by 4
        // pixels.
        QByteArray grid = "ncols 40\nnrows 30\nxllcorner 500000\nyllcorner 5761000\ncellsize 5\n";
        for (int y = 0; y < 30; ++y) {
            for (int x = 0; x < 40; ++x) {
                const bool worked =
                    x >= 5 && x < 35 && y >= 5 && y < 25 && !(x >= 10 && x < 16 && y >= 10 && y < 14);
                grid += worked ? "1 " : "0 ";
            }
            grid += '\n';
        }
        const Scratch scratch;
        const fs::path source = scratch.write("mask.asc", grid.toStdString());
        const QString tif = QString::fromStdString(scratch.path("mask.tif").string());
        const Printed made = run(
            "gdal_translate", {"-q", "-a_srs", "EPSG:32632", QString::fromStdString(source.string()), tif});
        if (made.status == -1) {
            QSKIP("needs gdal_translate");
        }
        QCOMPARE(made.status, 0);
        const auto read = readFields(tif.toStdString());
        VERIFY_RESULT(read);
        QCOMPARE(read->fields.size(), 1U);
        const auto& parts = read->fields[0].field.parts;
        QCOMPARE(parts.size(), 1U);
        QCOMPARE(parts[0].outer.size(), 4U);
        QCOMPARE(parts[0].holes.size(), 1U);
        // 150 m by 100 m less 30 m by 20 m; the scale of UTM in the middle of its zone is 0.9996.
        COMPARE_WITHIN(areaOf(read->fields[0].field).si(), 14'400.0 / (0.9996 * 0.9996), 2.0);
        const QString png = QString::fromStdString(scratch.path("mask.png").string());
        QCOMPARE(run("gdal_translate", {"-q", "-ot", "Byte", "-of", "PNG", "-co", "WORLDFILE=YES", "-a_srs",
                                        "EPSG:4326", "-a_ullr", "9.0", "52.002", "9.004", "52.0",
                                        QString::fromStdString(source.string()), png})
                     .status,
                 0);
        fs::remove(png.toStdString() + ".aux.xml");
        const auto picture = readFields(png.toStdString());
        VERIFY_RESULT(picture);
        QCOMPARE(picture->fields[0].field.parts[0].holes.size(), 1U);
        COMPARE_WITHIN(picture->fields[0].field.parts[0].outer[0].lonDeg, 9.0005, 1e-9);
        QVERIFY(fs::remove(scratch.path("mask.wld")));
        const auto nowhere = readFields(png.toStdString());
        QVERIFY(!nowhere && nowhere.error().what.contains("does not say where it lies"));
    }

    void trackThatComesBackIsAField() {
        std::string track =
            R"(<?xml version="1.0"?><gpx version="1.1" xmlns="http://www.topografix.com/GPX/1/1"><trk><name>walk</name><trkseg>)";
        for (int i = 0; i < 60; ++i) {
            const double angle = 2.0 * M_PI * i / 61.0;
            track += std::format(R"(<trkpt lat="{:.7f}" lon="{:.7f}"/>)", 52.0 + 0.001 * std::sin(angle),
                                 9.0 + 0.0015 * std::cos(angle));
        }
        const Scratch scratch;
        const auto read = readFields(scratch.write("walk.gpx", track + "</trkseg></trk></gpx>"));
        VERIFY_RESULT(read);
        QCOMPARE(read->fields.size(), 1U);
        QCOMPARE(read->fields[0].field.name, "walk");
        QCOMPARE(read->notes.size(), 1U);
        QVERIFY(read->notes[0].text.contains("was closed"));
    }
};

FURROW_TEST(FieldReaderTest);
#include "tst_field_reader.moc"
