#include "planner/core/message.h"
#include "planner/io/delivery/terminals.h"
#include "planner/io/formats/registry.h"
#include "planner/machine/machine_file.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"

#include <QDirIterator>
#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <QXmlStreamReader>

using namespace furrow;

namespace {

const QString kSource = QStringLiteral(FURROW_SOURCE_DIR);
const QString kTexts = QStringLiteral(FURROW_SOURCE_DIR "/translations/planner_texts.h");

// String literals, with those that follow each other as one.
const QString kLiteral = QString::fromUtf8("\"(?:[^\"\\\\\\n]|\\\\.)*\"(?:\\s*\"(?:[^\"\\\\\\n]|\\\\.)*\")*");

struct Entry {
    QString context;
    QString source;
    bool numerus = false;
    bool finished = true;
    QStringList forms;
};

QString readAll(const QString& path) {
    QFile file{path};
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString{};
}

/// What a literal of the sources says.
QString joined(const QString& literal) {
    static const QRegularExpression piece{QString::fromUtf8("\"((?:[^\"\\\\\\n]|\\\\.)*)\"")};
    QString text;
    for (auto each = piece.globalMatch(literal); each.hasNext();) {
        text += each.next().captured(1);
    }
    return text.replace(QStringLiteral("\\\""), QStringLiteral("\""))
        .replace(QStringLiteral("\\\\"), QStringLiteral("\\"));
}

/// A source file without comments, includes and raw strings.
QString code(const QString& path) {
    QString text = readAll(path);
    text.remove(QRegularExpression{QString::fromUtf8("^\\s*#.*$"), QRegularExpression::MultilineOption});
    text.replace(QRegularExpression{QString::fromUtf8("R\"(\\w*)\\(.*?\\)\\1\""),
                                    QRegularExpression::DotMatchesEverythingOption},
                 QStringLiteral("\"\""));
    text.remove(QRegularExpression{QString::fromUtf8("(?<![:\"])//[^\\n]*")});
    return text;
}

QStringList filesIn(const QString& folder, const QStringList& names) {
    QStringList files;
    QDirIterator each{kSource + folder, names, QDir::Files, QDirIterator::Subdirectories};
    while (each.hasNext()) {
        files << each.next();
    }
    files.sort();
    return files;
}

QList<Entry> entriesOf(const QString& path) {
    QList<Entry> entries;
    QFile file{path};
    if (!file.open(QIODevice::ReadOnly)) {
        return entries;
    }
    QXmlStreamReader xml{&file};
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) {
            continue;
        }
        const auto name = xml.name();
        if (name == u"name") {
            context = xml.readElementText();
        } else if (name == u"message") {
            entries.push_back({.context = context,
                               .source = {},
                               .numerus = xml.attributes().value(u"numerus") == u"yes",
                               .forms = {}});
        } else if (name == u"source") {
            entries.back().source = xml.readElementText();
        } else if (name == u"translation") {
            entries.back().finished = !xml.attributes().hasAttribute(u"type");
            if (!entries.back().numerus) {
                entries.back().forms << xml.readElementText();
            }
        } else if (name == u"numerusform") {
            entries.back().forms << xml.readElementText();
        }
    }
    return xml.hasError() ? QList<Entry>{} : entries;
}

QString languageFile(const QString& language) {
    return kSource + QStringLiteral("/translations/furrow_%1.ts").arg(language);
}

/// Of a text: %1, %2 ... %n, in order, each as often as it is there.
QStringList placeholders(const QString& text) {
    static const QRegularExpression place{QStringLiteral("%(?:n|\\d)")};
    QStringList found;
    for (auto each = place.globalMatch(text); each.hasNext();) {
        found << each.next().captured(0);
    }
    found.sort();
    return found;
}

/// Parts of the planner that only the command line and other programs speak through.
bool isForPrograms(const QString& file) {
    static const QStringList parts{
        "/evaluation/",    "/report/",      "/track/",   "/io/tracks/",  "_tracks.",      "/formats/logs/",
        "/track_reader",   "/written_path", "/rosbag_",  "/kml_writer",  "/gpx_writer",   "/dxf_writer",
        "/guidance_lines", "/nav_path",     "/path_csv", "/field_files", "/core/message", "/settings_file"};
    return std::ranges::any_of(parts, [&file](const QString& part) { return file.contains(part); });
}

/// Literals that are no sentences: ids, file contents, names of makers, what only the command line says.
bool isNoText(const QString& text) {
    static const QRegularExpression none{QString::fromUtf8(
        "^(\\+proj|POLYGON|MULTIPOLYGON|LINESTRING|geojson json|xml zip|shp zip|gml xml|wkt txt|tif png|log nmea|csv |# |SELECT|INSERT|CREATE|PRAGMA|std_msgs|\\{:016|.*\\\\n| or $|plans cannot be written as|furrow-cli|Part \\{|transform|header|type:|EPSG|QGC|.* json$|\\+|-|map_frame|builtin|geometry_msgs|nav_msgs/|float|string |int|uint|.*ros2msg|byte|A\\+ |AB \\{|Headland \\{|Tramline \\{|\\{\\} [AB]|Swath \\{|ArduPilot Rover, |Case IH|CHC |Claas |Deutz|FJ |John Deere|Massey|M\\\\u00fcller|New Holland|Raven|Topcon|Trimble|Valtra|ESRI Shape|.*--field-id|the table holds)")};
    return none.match(text).hasMatch();
}

/// Keys of every text in the planner's sources and registries; with those that have plural forms.
QMap<QString, bool> plannerTexts() {
    QMap<QString, bool> texts;
    static const QRegularExpression literal{kLiteral};
    static const QRegularExpression plural{QString::fromUtf8("counted\\(\\s*(%1),\\s*(%1)").arg(kLiteral)};
    static const QRegularExpression id{QString::fromUtf8("\\.(key|id) = $")};
    static const QRegularExpression named{QString::fromUtf8("\\.name = $|Message\\{$")};
    static const QRegularExpression words{QStringLiteral("[A-Za-zÀ-ÿ%}]{1,} [A-Za-z{(]|^[A-Z][a-z ]+\\.$")};
    static const QRegularExpression letters{QStringLiteral("[a-z]{2,}|^[A-Z]\\+?$")};
    static const QRegularExpression onlyPlaces{QStringLiteral("^[%\\d\\s,.:()]*$")};
    for (const QString& file : filesIn(QStringLiteral("/planner"), {"*.cpp", "*.h"})) {
        if (isForPrograms(file)) {
            continue;
        }
        const QString text = code(file);
        QSet<QString> counted;
        for (auto each = plural.globalMatch(text); each.hasNext();) {
            const auto match = each.next();
            counted << joined(match.captured(1)) << joined(match.captured(2));
            texts.insert(QString::fromStdString(messageKey(joined(match.captured(2)).toStdString(), true)),
                         true);
        }
        for (auto each = literal.globalMatch(text); each.hasNext();) {
            const auto match = each.next();
            const QString said = joined(match.captured(0));
            const QString before = text.mid(std::max<qsizetype>(0, match.capturedStart() - 24),
                                            std::min<qsizetype>(24, match.capturedStart()));
            const bool isName = named.match(before).hasMatch();
            if (counted.contains(said) || isNoText(said) || id.match(before).hasMatch() ||
                (!isName && !words.match(said).hasMatch()) ||
                (!isName && !letters.match(QString{said}.remove(QStringLiteral("{}"))).hasMatch())) {
                continue;
            }
            static const QRegularExpression pattern{QString::fromUtf8("\\{(:[^{}]*)?\\}")};
            const QString key = pattern.match(said).hasMatch()
                                    ? QString::fromStdString(messageKey(said.toStdString(), false))
                                    : said;
            if (!key.isEmpty() && !onlyPlaces.match(key).hasMatch()) {
                texts.insert(key, texts.value(key, false));
            }
        }
    }
    // Errors that the window makes itself are said as the planner's are.
    static const QRegularExpression error{QString::fromUtf8("\\.(?:what|remedy) = (%1)").arg(kLiteral)};
    for (const QString& file : filesIn(QStringLiteral("/ui"), {"*.cpp", "*.h"})) {
        const QString text = code(file);
        for (auto each = error.globalMatch(text); each.hasNext();) {
            texts.insert(joined(each.next().captured(1)), false);
        }
    }
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
    for (const QString& sample : filesIn(QStringLiteral("/resources/sample_fields"), {"*.geojson"})) {
        static const QRegularExpression name{QString::fromUtf8("\"name\"\\s*:\\s*\"([^\"]*)\"")};
        add(name.match(readAll(sample)).captured(1).toStdString());
    }
    return texts;
}

/// As planner_texts.h lists them.
QMap<QString, bool> listedTexts() {
    QMap<QString, bool> texts;
    static const QRegularExpression line{
        QString::fromUtf8("QT_TRANSLATE_(N_)?NOOP\\(\"Planner\", (\"(?:[^\"\\\\]|\\\\.)*\")\\)")};
    const QString all = readAll(kTexts);
    for (auto each = line.globalMatch(all); each.hasNext();) {
        const auto match = each.next();
        texts.insert(joined(match.captured(2)), !match.captured(1).isEmpty());
    }
    return texts;
}

void writeTexts(const QMap<QString, bool>& texts) {
    QFile file{kTexts};
    const QString old = readAll(kTexts);
    QString text = old.left(old.indexOf(QLatin1Char('{')) + 2);
    for (auto each = texts.begin(); each != texts.end(); ++each) {
        QString escaped = each.key();
        escaped.replace(QLatin1String{"\\"}, QLatin1String{"\\\\"})
            .replace(QLatin1String{"\""}, QLatin1String{"\\\""});
        text += QStringLiteral("    %1(\"Planner\", \"%2\"),\n")
                    .arg(QLatin1String{each.value() ? "QT_TRANSLATE_N_NOOP" : "QT_TRANSLATE_NOOP"}, escaped);
    }
    if (file.open(QIODevice::WriteOnly)) {
        file.write((text + QStringLiteral("};\n")).toUtf8());
    }
}

QString shortList(QStringList list) {
    const auto all = list.size();
    list = list.mid(0, 12);
    return QStringLiteral("%1: ").arg(all) + list.join(QStringLiteral("\n"));
}

}  // namespace

class TestTranslations : public QObject {
    Q_OBJECT

private slots:
    void everyPlannerTextIsListed() {
        const QMap<QString, bool> texts = plannerTexts();
        QVERIFY(texts.size() > 600);
        if (qEnvironmentVariableIsSet("FURROW_WRITE_TEXTS")) {
            writeTexts(texts);
        }
        const QMap<QString, bool> listed = listedTexts();
        QStringList missing;
        for (auto each = texts.begin(); each != texts.end(); ++each) {
            if (!listed.contains(each.key()) || listed.value(each.key()) != each.value()) {
                missing << each.key();
            }
        }
        QStringList gone;
        for (auto each = listed.begin(); each != listed.end(); ++each) {
            if (!texts.contains(each.key())) {
                gone << each.key();
            }
        }
        QVERIFY2(missing.isEmpty(),
                 qPrintable(QStringLiteral("not in planner_texts.h, ") + shortList(missing)));
        QVERIFY2(gone.isEmpty(),
                 qPrintable(QStringLiteral("no longer said by the planner, ") + shortList(gone)));
    }

    void messagesArePatternsOfMessage() {
        // A text with values that is put together by std::format could not be translated.
        static const QRegularExpression made{QString::fromUtf8("std::format\\(\\s*(%1)").arg(kLiteral)};
        static const QRegularExpression sentence{QStringLiteral("[a-z]{3,} [a-z]{2,} [a-z]")};
        QStringList wrong;
        for (const QString& file : filesIn(QStringLiteral("/planner"), {"*.cpp"})) {
            if (isForPrograms(file) || file.endsWith(QLatin1String{"/ros_writer.cpp"})) {
                continue;
            }
            const QString text = code(file);
            for (auto each = made.globalMatch(text); each.hasNext();) {
                const QString said = joined(each.next().captured(1));
                if (sentence.match(said).hasMatch()) {
                    wrong << file.section(QLatin1Char('/'), -1) + QStringLiteral(": ") + said;
                }
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(shortList(wrong)));
    }

    void everyLanguageIsComplete_data() {
        QTest::addColumn<QString>("language");
        for (const char* language : {"de", "nl", "fr", "es", "pt_BR", "pt_PT"}) {
            QTest::newRow(language) << QString::fromLatin1(language);
        }
    }
    void everyLanguageIsComplete() {
        QFETCH(QString, language);
        const QList<Entry> entries = entriesOf(languageFile(language));
        QVERIFY(!entries.isEmpty());
        QStringList wrong;
        QSet<QString> there;
        for (const Entry& entry : entries) {
            there << entry.context + QLatin1Char('\n') + entry.source;
            const bool complete = entry.finished && entry.forms.size() == (entry.numerus ? 2 : 1) &&
                                  !entry.forms.contains(QString{});
            bool samePlaces = complete;
            for (const QString& form : entry.forms) {
                // Where one is meant, the number may be left to the words.
                QStringList wanted = placeholders(entry.source);
                QStringList found = placeholders(form);
                if (entry.numerus) {
                    wanted.removeAll(QStringLiteral("%n"));
                    found.removeAll(QStringLiteral("%n"));
                }
                samePlaces = samePlaces && wanted == found;
            }
            if (!samePlaces) {
                wrong << entry.source + QStringLiteral(" -> ") + entry.forms.join(QStringLiteral(" / "));
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(shortList(wrong)));
        if (language == QLatin1String{"pt_PT"}) {
            return;  // only what differs from Brazil's
        }
        QStringList missing;
        for (const Entry& entry : entriesOf(languageFile(QStringLiteral("de")))) {
            if (!there.contains(entry.context + QLatin1Char('\n') + entry.source)) {
                missing << entry.source;
            }
        }
        const QMap<QString, bool> planner = listedTexts();
        for (auto each = planner.begin(); each != planner.end(); ++each) {
            if (!there.contains(QStringLiteral("Planner\n") + each.key())) {
                missing << each.key();
            }
        }
        QVERIFY2(missing.isEmpty(), qPrintable(shortList(missing)));
    }

    void everyTextOfTheWindowIsTranslated() {
        QSet<QString> known;
        for (const Entry& entry : entriesOf(languageFile(QStringLiteral("de")))) {
            known << entry.source;
        }
        QSet<QString> englishPlurals;
        for (const Entry& entry : entriesOf(languageFile(QStringLiteral("en")))) {
            QCOMPARE(entry.forms.size(), 2);
            englishPlurals << entry.source;
        }
        static const QRegularExpression said{
            QString::fromUtf8("\\b(?:qsTr|tr|QT_TR_NOOP)\\(\\s*(%1)\\s*([,)])").arg(kLiteral)};
        QStringList missing;
        int count = 0;
        for (const QString& folder : {QStringLiteral("/ui"), QStringLiteral("/app/window")}) {
            for (const QString& file : filesIn(folder, {"*.cpp", "*.h", "*.qml"})) {
                const QString text = code(file);
                for (auto each = said.globalMatch(text); each.hasNext();) {
                    const QString source = joined(each.next().captured(1));
                    ++count;
                    if (!known.contains(source) ||
                        (source.contains(QLatin1String{"%n"}) && !englishPlurals.contains(source))) {
                        missing << file.section(QLatin1Char('/'), -1) + QStringLiteral(": ") + source;
                    }
                }
            }
        }
        QVERIFY(count > 350);
        QVERIFY2(missing.isEmpty(), qPrintable(shortList(missing)));
    }

    void nothingIsSaidInOneLanguageOnly() {
        static const QRegularExpression shown{QString::fromUtf8(
            "\\b(?:text|title|hint|name|label|message|description|keywords|placeholderText|Accessible\\.name|Accessible\\.description)\\s*:\\s*\"([^\"]*)\"")};
        // Names of icons are in small letters, with no blank.
        static const QRegularExpression words{QStringLiteral("[A-Z][a-z]|[a-z] [a-z]")};
        static const QRegularExpression literal{kLiteral};
        static const QRegularExpression sentence{QStringLiteral("[A-Za-z]{2,} [a-z]{2,}")};
        static const QRegularExpression around{QString::fromUtf8(
            "(?:\\btr|QT_TR_NOOP|translate|shown|qWarning|qFatal|QML_UNCREATABLE|fputs|printf|add|property|toLatin1|static_assert|contains|QLatin1String|\\.what =|\\.remedy =)\\s*[({]?\\s*$")};
        QStringList wrong;
        for (const QString& file : filesIn(QStringLiteral("/ui"), {"*.qml"})) {
            const QString text = code(file);
            for (auto each = shown.globalMatch(text); each.hasNext();) {
                const QString said = each.next().captured(1);
                if (words.match(said).hasMatch() && said != QLatin1String{"Inter"} &&
                    said != QLatin1String{"Furrow"}) {
                    wrong << file.section(QLatin1Char('/'), -1) + QStringLiteral(": ") + said;
                }
            }
        }
        for (const QString& file : filesIn(QStringLiteral("/ui"), {"*.cpp", "*.h"})) {
            const QString text = code(file);
            for (auto each = literal.globalMatch(text); each.hasNext();) {
                const auto match = each.next();
                const QString said = joined(match.captured(0));
                const QString before = text.mid(std::max<qsizetype>(0, match.capturedStart() - 40),
                                                std::min<qsizetype>(40, match.capturedStart()));
                if (sentence.match(said).hasMatch() && !around.match(before).hasMatch()) {
                    wrong << file.section(QLatin1Char('/'), -1) + QStringLiteral(": ") + said;
                }
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(shortList(wrong)));
    }

    void fieldTermsAreThoseOfTheGlossary_data() {
        QTest::addColumn<QString>("term");
        QTest::addColumn<QStringList>(
            "words");  // de, nl, fr, es, pt_BR: beginnings that other forms of the word share
        const auto row = [](const char* term, const QStringList& words) {
            QTest::newRow(term) << QString::fromLatin1(term) << words;
        };
        row("\\bheadland\\b(?!\\.)", {"vorgewende", "kopakker", "fourrière", "cabecera", "cabeceira"});
        row("\\bmainland", {"innenfläche", "binnenakker", "plein champ", "interior", "interior"});
        row("\\bobstacle", {"hindernis", "obstakel", "obstacle", "obstáculo", "obstáculo"});
        // "Direction of the swaths" is a term of its own.
        row("(?<!direction of the )\\bswath", {"spur", "werkgang", "passage", "pasada", "passada"});
        row("direction of the swaths",
            {"fahrtrichtung", "rijrichting", "orientation", "dirección", "direção"});
        row("\\boperating width", {"arbeitsbreite", "werkbreedte", "largeur", "ancho", "largura"});
        row("\\bturning radius",
            {"wenderadius", "draaistraal", "rayon de braquage", "radio de giro", "raio de giro"});
        row("\\btramline", {"fahrgasse", "spuitsp", "pulvérisateur", "calle", "rastro"});
        row("\\bguidance line", {"leitlinie", "stuurlijn", "de guidage", "de guiado", "de orientação"});
        row("\\btractor", {"schlepper", "trekker", "tracteur", "tractor", "trator"});
        row("\\bgate", {"zufahrt", "inrit", "entrée", "entrada", "entrada"});
        row("\\bterminal", {"terminal", "terminal", "console|terminal", "terminal", "termina"});
        row("\\bfindings?\\b", {"hinweis", "bevinding", "remarque", "aviso", "aviso"});
        row("three-point turn", {"dreipunktwendung", "steekbocht", "demi-tour en trois temps",
                                 "giro en tres puntos", "manobra em três pontos"});
        row("fishtail",
            {"schwalbenschwanz", "vissenstaart", "queue de poisson", "cola de pez", "rabo de peixe"});
    }
    void fieldTermsAreThoseOfTheGlossary() {
        QFETCH(QString, term);
        QFETCH(QStringList, words);
        const QRegularExpression inSource{term, QRegularExpression::CaseInsensitiveOption};
        const QStringList languages{"de", "nl", "fr", "es", "pt_BR"};
        QStringList wrong;
        int seen = 0;
        for (qsizetype i = 0; i < languages.size(); ++i) {
            const QRegularExpression wanted{words[i], QRegularExpression::CaseInsensitiveOption};
            for (const Entry& entry : entriesOf(languageFile(languages[i]))) {
                if (inSource.match(entry.source).hasMatch()) {
                    ++seen;
                    if (!wanted.match(entry.forms.join(QLatin1Char(' '))).hasMatch()) {
                        wrong << entry.source + QStringLiteral(" -> ") +
                                     entry.forms.join(QStringLiteral(" / "));
                    }
                }
            }
        }
        QVERIFY(seen >= 5);
        QVERIFY2(wrong.isEmpty(), qPrintable(shortList(wrong)));
    }
};

QTEST_APPLESS_MAIN(TestTranslations)
#include "tst_translations.moc"
