#include "translations/collect/planner_texts.h"

#include "planner/core/message.h"
#include "planner/io/delivery/terminals.h"
#include "planner/io/formats/registry.h"
#include "planner/machine/machine_file.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "translations/collect/source_texts.h"

#include <QRegularExpression>
#include <QSet>

#include <algorithm>

namespace furrow {

namespace {

/// Literals that are no sentences: ids, file contents, names of makers, what only the command line says.
bool isNoText(const QString& text) {
    static const QRegularExpression none{QString::fromUtf8(
        "^(\\+proj|POLYGON|MULTIPOLYGON|LINESTRING|geojson json|xml zip|shp zip|gml xml|wkt txt|tif png|log nmea|csv |# |SELECT|INSERT|CREATE|PRAGMA|SQLite format|AutoCAD Binary|std_msgs|\\{:016|.*\\\\n| or $|plans cannot be written as|furrow-cli|Part \\{|transform|header|type:|EPSG|QGC|.* json$|\\+|-|map_frame|builtin|geometry_msgs|nav_msgs/|float|string |int|uint|.*ros2msg|byte|A\\+ |AB \\{|Headland \\{|Tramline \\{|\\{\\} [AB]|Swath \\{|ArduPilot Rover, |Case IH|CHC |Claas |Deutz|FJ |John Deere|Massey|M\\\\u00fcller|New Holland|Raven|Topcon|Trimble|Valtra|ESRI Shape|.*--field-id|the table holds|NMEA log|gpsd log|ISOXML time log|yield monitor|no memory|\\{\\}, segment)")};
    return none.match(text).hasMatch();
}

/// Whether people see a literal, by what stands before it in the code: names and sentences, no ids.
bool isSaid(const QString& said, const QString& before) {
    static const QRegularExpression id{QString::fromUtf8("\\.(key|id) = $")};
    static const QRegularExpression named{QString::fromUtf8("\\.name = $|Message\\{$")};
    static const QRegularExpression words{QStringLiteral("[A-Za-zÀ-ÿ%}]{1,} [A-Za-z{(]|^[A-Z][a-z ]+\\.$")};
    static const QRegularExpression letters{QStringLiteral("[a-z]{2,}|^[A-Z]\\+?$")};
    const bool isName = named.match(before).hasMatch();
    return !isNoText(said) && !id.match(before).hasMatch() &&
           (isName || (words.match(said).hasMatch() &&
                       letters.match(QString{said}.remove(QStringLiteral("{}"))).hasMatch()));
}

/// Those of one file of the planner; texts that are counted are true.
void addFromCode(const QString& text, QMap<QString, bool>& texts) {
    static const QRegularExpression literal{kLiteral};
    static const QRegularExpression plural{QString::fromUtf8("counted\\(\\s*(%1),\\s*(%1)").arg(kLiteral)};
    static const QRegularExpression pattern{QString::fromUtf8("\\{(:[^{}]*)?\\}")};
    static const QRegularExpression onlyPlaces{QStringLiteral("^[%\\d\\s,.:()]*$")};
    // A name and its value: some languages set a space before the colon.
    static const QString labelled = QStringLiteral("{}: {}");
    QSet<QString> counted;
    for (auto each = plural.globalMatch(text); each.hasNext();) {
        const auto match = each.next();
        counted << joined(match.captured(1)) << joined(match.captured(2));
        texts.insert(QString::fromStdString(messageKey(joined(match.captured(2)).toStdString(), true)), true);
    }
    for (auto each = literal.globalMatch(text); each.hasNext();) {
        const auto match = each.next();
        const QString said = joined(match.captured(0));
        const QString before = text.mid(std::max<qsizetype>(0, match.capturedStart() - 24),
                                        std::min<qsizetype>(24, match.capturedStart()));
        if (counted.contains(said) || !(said == labelled || isSaid(said, before))) {
            continue;
        }
        const QString key = pattern.match(said).hasMatch()
                                ? QString::fromStdString(messageKey(said.toStdString(), false))
                                : said;
        if (!key.isEmpty() && (said == labelled || !onlyPlaces.match(key).hasMatch())) {
            texts.insert(key, texts.value(key, false));
        }
    }
}

/// Errors that the window makes itself are said as the planner's are.
void addErrorsOfTheWindow(const QString& project, QMap<QString, bool>& texts) {
    static const QRegularExpression error{QString::fromUtf8("\\.(?:what|remedy) = (%1)").arg(kLiteral)};
    for (const QString& file : filesIn(project + QStringLiteral("/ui"), {"*.cpp", "*.h"})) {
        const QString text = codeOf(file);
        for (auto each = error.globalMatch(text); each.hasNext();) {
            texts.insert(joined(each.next().captured(1)), false);
        }
    }
}

/// Names and descriptions of settings, methods, machines and sample fields.
void addNames(const QString& project, QMap<QString, bool>& texts) {
    const auto add = [&texts](std::string_view text) {
        const QString key = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
        if (!key.isEmpty() && !isNoText(key) &&
            key.contains(QRegularExpression{QStringLiteral("[a-z]{2,}")})) {
            texts.insert(key, texts.value(key, false));
        }
    };
    for (const Parameter* parameter : allParameters()) {
        add(parameter->name);
        add(parameter->description);
        for (const Choice& choice : parameter->choices) {
            add(choice.name);
            add(choice.description);
        }
    }
    for (const StageInfo& stage : stages()) {
        add(stage.name);
        for (const MethodInfo& method : stage.methods) {
            add(method.name);
            add(method.description);
        }
    }
    for (const MachineKey& key : machineKeys()) {
        add(key.name);
        add(key.description);
    }
    for (const Machine& machine : machineLibrary()) {
        add(machine.name());
    }
    for (const QString& sample :
         filesIn(project + QStringLiteral("/resources/sample_fields"), {"*.geojson"})) {
        static const QRegularExpression name{QString::fromUtf8("\"name\"\\s*:\\s*\"([^\"]*)\"")};
        add(name.match(textOf(sample)).captured(1).toStdString());
    }
}

}  // namespace

bool isForPrograms(const QString& file) {
    static const QStringList parts{"/evaluation/",  "/benchmarks/", "/report/",     "/written_path",
                                   "/kml_writer",   "/gpx_writer",  "/dxf_writer",  "/guidance_lines",
                                   "/nav_path",     "/path_csv",    "/field_files", "/core/message",
                                   "/settings_file"};
    return std::ranges::any_of(parts, [&file](const QString& part) { return file.contains(part); });
}

QMap<QString, bool> plannerTexts(const QString& project) {
    QMap<QString, bool> texts;
    for (const QString& file : filesIn(project + QStringLiteral("/planner"), {"*.cpp", "*.h"})) {
        if (!isForPrograms(file)) {
            addFromCode(codeOf(file), texts);
        }
    }
    addErrorsOfTheWindow(project, texts);
    addNames(project, texts);
    return texts;
}

}  // namespace furrow
