#pragma once

#include "planner/geodesy/local_frame.h"
#include "planner/io/formats/isoxml/isoxml_writer.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/planner/io/format_cases.h"
#include "tests/support/large_data.h"

#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>

// Task data as Qt reads it, and the fields that the tests of it are about.

namespace furrow::test {

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

inline Element readElement(QXmlStreamReader& reader) {
    Element element{reader.name().toString(), reader.attributes(), {}};
    while (reader.readNext() != QXmlStreamReader::EndElement && !reader.atEnd()) {
        if (reader.isStartElement()) {
            element.children.append(readElement(reader));
        }
    }
    return element;
}

inline Element parsed(const std::string& xml) {
    QXmlStreamReader reader{QByteArray::fromStdString(xml)};
    reader.readNextStartElement();
    Element root = readElement(reader);
    return reader.hasError() ? Element{} : root;
}

inline GeoRing ringOf(const Element& line) {
    GeoRing ring;
    for (const Element& point : line.all("PNT")) {
        ring.push_back({point.value("D").toDouble(), point.value("C").toDouble()});
    }
    return ring;
}

// 0.000 000 000 5 degrees of rounding, on both sides.
inline constexpr double kToleranceDeg = 1.1e-9;

inline bool near(const GeoPoint& a, const GeoPoint& b) {
    return std::abs(a.lonDeg - b.lonDeg) < kToleranceDeg && std::abs(a.latDeg - b.latDeg) < kToleranceDeg;
}

/// The written ring is closed and has exactly the points of the field's.
inline bool sameRing(GeoRing written, const GeoRing& expected) {
    if (written.size() != expected.size() + 1 || written.front() != written.back()) {
        return false;
    }
    return std::ranges::all_of(expected, [&written](const GeoPoint& point) {
        return std::ranges::any_of(written, [&point](const GeoPoint& other) { return near(point, other); });
    });
}

/// Positive for counter-clockwise.
inline double turning(const GeoRing& ring) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
        sum += (ring[i].lonDeg - ring[0].lonDeg) * (ring[i + 1].latDeg - ring[0].latDeg) -
               (ring[i + 1].lonDeg - ring[0].lonDeg) * (ring[i].latDeg - ring[0].latDeg);
    }
    return sum;
}

/// The parts of it that task data have places for, with a name that has to be cut.
inline FieldSource fieldForTaskData() {
    FieldSource source = plainField().field;
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

inline FieldSource fieldOnTheAntimeridian() {
    FieldSource source;
    source.id = source.name = "Taveuni";
    source.parts = {{.outer = {{179.999, -16.8}, {-179.999, -16.8}, {-179.999, -16.798}, {179.999, -16.798}},
                     .holes = {}}};
    return source;
}

inline FieldSource farNorth() {
    FieldSource source;
    source.id = source.name = "80 degrees north";
    source.parts = {{.outer = box(20.0, 80.0, 0.012, 0.002), .holes = {}}};
    return source;
}

struct IsoxmlCase {
    const char* name;
    FieldSource (*field)();
};
inline constexpr IsoxmlCase kTaskDataCases[] = {{"plain field", [] { return plainField().field; }},
                                                {"holes, parts, obstacles, a gate", fieldForTaskData},
                                                {"across the antimeridian", fieldOnTheAntimeridian},
                                                {"80 degrees north", farNorth}};

/// The plan of a field with these settings, by their keys.
inline std::shared_ptr<const Plan> planWith(
    const FieldSource& source, std::initializer_list<std::pair<const char*, const char*>> given) {
    Settings settings;
    for (const auto& [key, value] : given) {
        applySetting(settings, key, value).value();
    }
    return planOf(source, "agbot", settings);
}

/// What xmllint says to a file by one of the schemas; 0, too, where one of the two is not at hand.
inline int runLint(const char* schema, const QString& file) {
    const QString path = test::largeData(QStringLiteral("schemas/%1").arg(QLatin1StringView{schema}));
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
inline QString writeTaskData(const QTemporaryDir& folder, const std::string& xml) {
    const QString path = folder.filePath("TASKDATA.XML");
    std::ofstream{path.toStdString(), std::ios::binary} << xml;
    return path;
}

/// By the schema of version 4.
inline void checkSchema(const Plan& given) {
    const Plan* const plan = &given;
    const QString schema = test::largeData(QStringLiteral("schemas/ISO11783_TaskFile_V4-3.xsd"));
    if (!QFileInfo::exists(schema) || QStandardPaths::findExecutable("xmllint").isEmpty()) {
        QSKIP("needs xmllint and the schemas of the large test data");
    }
    const QTemporaryDir folder;
    QProcess lint;
    lint.start("xmllint",
               {"--noout", "--nonet", "--schema", schema, writeTaskData(folder, isoxmlTaskData(*plan))});
    QVERIFY(lint.waitForFinished());
    QVERIFY2(lint.exitCode() == 0, lint.readAllStandardError().constData());
}

}  // namespace furrow::test
