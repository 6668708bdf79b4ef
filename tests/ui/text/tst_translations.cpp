#include "tests/support/test_program.h"
#include "translations/collect/planner_texts.h"
#include "translations/collect/source_texts.h"

#include <QFile>
#include <QFileInfo>
#include <QMap>
#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <QXmlStreamReader>

using namespace furrow;

namespace {

const QString kSource = QStringLiteral(FURROW_SOURCE_DIR);

struct Entry {
    QString context;
    QString source;
    bool numerus = false;
    bool finished = true;
    QStringList forms;
};

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

QString shortList(QStringList list) {
    const auto all = list.size();
    list = list.mid(0, 12);
    return QStringLiteral("%1: ").arg(all) + list.join(QStringLiteral("\n"));
}

}  // namespace

class TestTranslations : public QObject {
    Q_OBJECT

private slots:
    void collectsWhatThePlannerSays() {
        const QMap<QString, bool> texts = plannerTexts(kSource);
        QVERIFY(texts.size() > 600);
        // A finding with a value, one with a plural, a setting, a method, a machine and a sample field.
        QVERIFY(texts.contains(QStringLiteral("%1 crosses an obstacle.")));
        QVERIFY(texts.value(QStringLiteral("%n places")));
        // Nothing but places and a colon is a text of its own: French has a space before the colon.
        for (const char* text : {"Margin", "To and fro", "AgBot", "%1: %2"}) {
            QVERIFY2(texts.contains(QString::fromLatin1(text)), text);
        }
        QVERIFY(!texts.contains(QStringLiteral("EPSG:4326")));
    }

    void messagesArePatternsOfMessage() {
        // A text with values that is put together by std::format could not be translated.
        static const QRegularExpression made{QString::fromUtf8("std::format\\(\\s*(%1)").arg(kLiteral)};
        static const QRegularExpression sentence{QStringLiteral("[a-z]{3,} [a-z]{2,} [a-z]")};
        QStringList wrong;
        for (const QString& file : filesIn(kSource + QStringLiteral("/planner"), {"*.cpp"})) {
            if (isForPrograms(file) || file.endsWith(QLatin1String{"/ros_writer.cpp"})) {
                continue;
            }
            const QString text = codeOf(file);
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
        for (const QString& file : filesIn(kSource + QStringLiteral("/translations"), {"furrow_*.ts"})) {
            const QString language = QFileInfo{file}.completeBaseName().section(QLatin1Char('_'), 1);
            if (language != QLatin1String{"en"}) {
                QTest::newRow(qPrintable(language)) << language;
            }
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
        const QMap<QString, bool> planner = plannerTexts(kSource);
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
            for (const QString& file : filesIn(kSource + folder, {"*.cpp", "*.h", "*.qml"})) {
                const QString text = codeOf(file);
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
            "(?:\\btr|QT_TR_NOOP|translate|shown|qWarning|qFatal|QML_UNCREATABLE|fputs|printf|add|property|toLatin1|static_assert|contains|QLatin1String|\\.what =|\\.remedy =)\\s*[({]?\\s*$|\\b(?:tr|QT_TRANSLATE_NOOP)\\(\"[^\"]*\",\\s*$|\\btoString\\([^\"]*QStringLiteral\\($")};
        // What a short text is about, for translators, stands behind it.
        constexpr qsizetype kBefore = 80;
        QStringList wrong;
        for (const QString& file : filesIn(kSource + QStringLiteral("/ui"), {"*.qml"})) {
            const QString text = codeOf(file);
            for (auto each = shown.globalMatch(text); each.hasNext();) {
                const QString said = each.next().captured(1);
                if (words.match(said).hasMatch() && said != QLatin1String{"Inter"} &&
                    said != QLatin1String{"Furrow"}) {
                    wrong << file.section(QLatin1Char('/'), -1) + QStringLiteral(": ") + said;
                }
            }
        }
        for (const QString& file : filesIn(kSource + QStringLiteral("/ui"), {"*.cpp", "*.h"})) {
            const QString text = codeOf(file);
            for (auto each = literal.globalMatch(text); each.hasNext();) {
                const auto match = each.next();
                const QString said = joined(match.captured(0));
                const QString before = text.mid(std::max<qsizetype>(0, match.capturedStart() - kBefore),
                                                std::min<qsizetype>(kBefore, match.capturedStart()));
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
        row("(?<!inside the )(?<!inside of the )\\bheadland\\b(?!\\.)",
            {"vorgewende", "kopakker", "fourrière", "cabecera", "cabeceira"});
        row("\\binside (of )?the headland",
            {"innenfläche|innerhalb des vorgewendes", "binnenakker|binnen de kopakker",
             "plein champ|intérieur de la fourrière", "interior|dentro de la cabecera",
             "interior|dentro da cabeceira"});
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

FURROW_TEST(TestTranslations);
#include "tst_translations.moc"
