#include "planner/geodesy/local_frame.h"
#include "planner/io/content/plan_content.h"
#include "planner/io/formats/isoxml/isoxml.h"
#include "planner/io/formats/isoxml/isoxml_writer.h"
#include "planner/io/import/boundary_import.h"
#include "planner/plan/plan.h"
#include "tests/planner/io/formats/isoxml_cases.h"
#include "tests/support/test_program.h"

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
using namespace furrow::test;

class TestIsoxml : public QObject {
    Q_OBJECT

private slots:
    void holdsTheField_data();
    void holdsTheField();
    void obstaclesAndGates();
    void namesAreCutAndUnequal();
    void strangeNames_data();
    void strangeNames();
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
};

void TestIsoxml::addCases() {
    QTest::addColumn<int>("index");
    for (int i = 0; i < static_cast<int>(std::size(kTaskDataCases)); ++i) {
        QTest::newRow(kTaskDataCases[i].name) << i;
    }
}

std::shared_ptr<const Plan> TestIsoxml::currentPlan() {
    QFETCH(int, index);
    return planOf(kTaskDataCases[index].field());
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
    const auto plan = planOf(fieldForTaskData());
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
    const auto plan = planOf(fieldForTaskData());
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
    FieldSource source = plainField().field;
    source.name = name.toStdString();
    const auto plan = planOf(source);
    QVERIFY(plan);
    QCOMPARE(parsed(isoxmlTaskData(*plan)).all("PFD").first().value("C"), written);
}

void TestIsoxml::numbersHaveNineDecimals() {
    const auto plan = planOf(fieldForTaskData());
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

void TestIsoxml::fieldsKeepWhatTheyAreKnownBy() {
    // What another program knows it by; the sample of the format notes.
    FieldContent known{.field = plainField().field};
    known.field.id = "{6F1D3C52-0C1E-4B7A-9B1D-4C3A2F0E9D10}";
    FieldContent drawn{.field = plainField().field};
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
    static const QRegularExpression uuid{
        QStringLiteral(R"(^\{[0-9a-f]{8}-[0-9a-f]{4}-8[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}\}$)")};
    QVERIFY2(uuid.match(links[1].value("B")).hasMatch(), qPrintable(links[1].value("B")));
    // The task data names the list, or nobody reads it; version 3 knows none.
    QCOMPARE(parsed(made->files[0].text()).all("AFE").first().value("A"), "LINKLIST.XML");
    QCOMPARE(writeIsoxml3(job)->files.size(), 1U);
    QVERIFY(parsed(writeIsoxml3(job)->files[0].text()).all("AFE").isEmpty());
    // Another export has the same ones, and what is read keeps them.
    const QTemporaryDir folder;
    for (const FileToWrite& file : made->files) {
        std::ofstream{folder.filePath(QString::fromStdString(file.path.filename().string())).toStdString(),
                      std::ios::binary}
            << file.text();
    }
    const auto read = readBoundaries(folder.filePath("TASKDATA.XML").toStdString());
    QVERIFY(read);
    QCOMPARE(read->size(), 2U);
    const std::vector again{FieldContent{.field = (*read)[0]}, FieldContent{.field = (*read)[1]}};
    QCOMPARE(writeIsoxml4({.fields = again})->files[1].text(), made->files[1].text());
    QCOMPARE(runLint("ISO11783_LinkListFile_V4-3.xsd", folder.filePath("LINKLIST.XML")), 0);
}

void TestIsoxml::tasksForTerminalsThatWantThem() {
    const auto plan = planOf(plainField().field);
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
        QCOMPARE(runLint(version == IsoxmlVersion::V4 ? "ISO11783_TaskFile_V4-3.xsd"
                                                      : "ISO11783_TaskFile_V3-3.xsd",
                         writeTaskData(folder, xml)),
                 0);
        QVERIFY(parsed(isoxmlText(fields, version)).all("TSK").isEmpty());
    }
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

FURROW_TEST(TestIsoxml);
#include "tst_isoxml.moc"
