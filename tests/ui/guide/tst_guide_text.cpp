#include "planner/io/delivery/terminals.h"
#include "planner/machine/machine_file.h"
#include "planner/path/finding.h"
#include "planner/plan/method_registry.h"
#include "tests/support/test_program.h"
#include "ui/guide/guide_text.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include <utility>

using namespace furrow;

namespace {

const QString kSource = QStringLiteral(FURROW_SOURCE_DIR);

QString textOf(const QString& file) {
    QFile text{kSource + QLatin1Char('/') + file};
    return text.open(QIODevice::ReadOnly) ? QString::fromUtf8(text.readAll()) : QString{};
}

QString chapter(const QString& name) {
    return textOf(QStringLiteral("resources/guide/en/%1.md").arg(name));
}

QString fromView(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// All texts of the window in this language, as its translation has them.
QStringList windowTexts(const QString& language) {
    const QRegularExpression text{language == u"en" ? QStringLiteral("<source>([^<]*)</source>")
                                                    : QStringLiteral("<translation>([^<]*)</translation>")};
    const QString of = language == u"en" ? QStringLiteral("de") : language;
    QStringList texts;
    const QString all = textOf(QStringLiteral("translations/furrow_%1.ts").arg(of));
    for (auto each = text.globalMatch(all); each.hasNext();) {
        texts << each.next()
                     .captured(1)
                     .replace(QStringLiteral("&apos;"), QStringLiteral("'"))
                     .replace(QStringLiteral("&quot;"), QStringLiteral("\""))
                     .replace(QStringLiteral("&amp;"), QStringLiteral("&"));
    }
    return texts;
}

}  // namespace

/// The guide says what there is, in the words of the window.
class TestGuideText : public QObject {
    Q_OBJECT

private slots:
    void aChapterFallsIntoBlocks() {
        const GuideChapter read =
            guideChapter(QStringLiteral("# Title\n\nBefore.\n\n## One\n\nText **bold**.\n\n"
                                        "![A picture](pictures/a.png)\n\nAfter.\n"));
        QCOMPARE(read.title, QStringLiteral("Title"));
        QCOMPARE(read.blocks.size(), std::size_t{5});
        QCOMPARE(read.blocks[0].text, QStringLiteral("Before."));
        QCOMPARE(read.blocks[1].heading, QStringLiteral("One"));
        QCOMPARE(read.blocks[2].text, QStringLiteral("Text **bold**."));
        QCOMPARE(read.blocks[3].picture, QStringLiteral("a.png"));
        QCOMPARE(read.blocks[3].text, QStringLiteral("A picture"));
        QCOMPARE(read.blocks[4].text, QStringLiteral("After."));
    }
    void wordsAreFound() {
        const std::vector<GuideChapter> chapters{
            guideChapter(QStringLiteral("# One\n\n## Headland\n\nWide as a turn.\n")),
            guideChapter(QStringLiteral("# Two\n\n## Else\n\nThe headland is a **strip**.\n"))};
        const auto hits = searchGuide(chapters, QStringLiteral("headland"));
        QCOMPARE(hits.size(), std::size_t{2});
        QCOMPARE(hits[0].chapter, 0);
        QCOMPARE(hits[1].title, QStringLiteral("Else"));
        QCOMPARE(hits[1].excerpt, QStringLiteral("The headland is a strip."));
        QCOMPARE(searchGuide(chapters, QStringLiteral("strip headland")).size(), std::size_t{1});
        QVERIFY(searchGuide(chapters, QStringLiteral("tractor")).empty());
        QVERIFY(searchGuide(chapters, QStringLiteral("  ")).empty());
    }
    void sectionsKnowWhatTheyBelongTo() {
        const GuideChapter read =
            guideChapter(QStringLiteral("# All\n\n## One\n\n### Order\n\nText.\n\n## Two\n\n### Order\n"));
        QStringList sections;
        for (const GuideBlock& block : read.blocks) {
            sections << block.heading + QLatin1Char('<') + block.within;
        }
        QCOMPARE(sections, (QStringList{"One<All", "Order<One", "<", "Two<All", "Order<Two"}));
    }
    void noTwoSectionsAreToldAlike_data() {
        QTest::addColumn<QString>("language");
        for (const char* language : {"en", "de", "nl", "fr", "es", "pt_BR"}) {
            QTest::newRow(language) << QString::fromLatin1(language);
        }
    }
    void noTwoSectionsAreToldAlike() {
        QFETCH(QString, language);
        QStringList told;
        for (const GuideChapter& each : guideIn(language)) {
            for (const GuideBlock& block : each.blocks) {
                if (!block.heading.isEmpty()) {
                    told << block.within + QStringLiteral(": ") + block.heading;
                }
            }
        }
        QVERIFY(told.size() > 100);
        QStringList twice;
        for (const QString& each : std::as_const(told)) {
            if (told.count(each) > 1) {
                twice << each;
            }
        }
        QCOMPARE(twice, QStringList{});
    }
    void everySettingAndMethodIsExplained() {
        const QString text = chapter(QStringLiteral("04-settings"));
        QStringList missing;
        const auto want = [&](std::string_view id) {
            if (!text.contains(QLatin1Char('`') + fromView(id) + QLatin1Char('`'))) {
                missing << fromView(id);
            }
        };
        for (const Parameter* parameter : generalParameters()) {
            want(parameter->key);
        }
        for (const StageInfo& stage : stages()) {
            want(stage.method->key);
            for (const Parameter* parameter : stage.parameters) {
                want(parameter->key);
            }
            for (const MethodInfo& method : stage.methods) {
                want(method.id);
                for (const Parameter* parameter : method.parameters) {
                    want(parameter->key);
                }
            }
        }
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join(QStringLiteral(", "))));
    }
    void everyFindingIsExplained() {
        const QString text = chapter(QStringLiteral("05-findings"));
        QStringList missing;
        for (int kind = 0; kind < static_cast<int>(FindingKind::Setting); ++kind) {
            const QString id = fromView(kindId(static_cast<FindingKind>(kind)));
            if (!text.contains(QLatin1Char('`') + id + QLatin1Char('`'))) {
                missing << id;
            }
        }
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join(QStringLiteral(", "))));
    }
    void everyTerminalIsExplained() {
        const QString text = chapter(QStringLiteral("06-terminals"));
        for (const Terminal& terminal : terminals()) {
            QVERIFY2(text.contains(fromView(terminal.name)), terminal.name.data());
        }
    }
    void chaptersAreWhole_data() {
        QTest::addColumn<QString>("language");
        for (const char* language : {"en", "de", "es", "fr", "nl", "pt_BR"}) {
            QTest::newRow(language) << QString::fromLatin1(language);
        }
    }
    // The same sections and pictures in every language, and the buttons as the window calls them.
    void chaptersAreWhole() {
        QFETCH(QString, language);
        const QStringList texts = windowTexts(language);
        QVERIFY(texts.size() > 500);
        static const QRegularExpression bold{QStringLiteral("[*]{2}([^*]+)[*]{2}")};
        QStringList strange;
        for (const char* name : {"01-first-plan", "02-steps", "03-window"}) {
            const QString file = QLatin1String{name};
            const QString text = textOf(QStringLiteral("resources/guide/%1/%2.md").arg(language, file));
            const GuideChapter own = guideChapter(text);
            const GuideChapter english = guideChapter(chapter(file));
            QVERIFY2(!own.title.isEmpty(), name);
            QCOMPARE(own.blocks.size(), english.blocks.size());
            for (std::size_t i = 0; i < own.blocks.size(); ++i) {
                QCOMPARE(own.blocks[i].picture, english.blocks[i].picture);
                QCOMPARE(own.blocks[i].heading.isEmpty(), english.blocks[i].heading.isEmpty());
                if (!own.blocks[i].picture.isEmpty()) {
                    QVERIFY2(QFile::exists(kSource + QStringLiteral("/resources/guide/pictures/") +
                                           own.blocks[i].picture),
                             qPrintable(own.blocks[i].picture));
                }
            }
            for (auto each = bold.globalMatch(text); each.hasNext();) {
                const QString said = each.next().captured(1);
                // A key.
                const bool known = said.size() == 1 || std::ranges::any_of(texts, [&](const QString& shown) {
                                       return shown.startsWith(said, Qt::CaseInsensitive);
                                   });
                if (!known) {
                    strange << file + QStringLiteral(": ") + said;
                }
            }
        }
        QVERIFY2(strange.isEmpty(), qPrintable(strange.join(QStringLiteral(", "))));
    }
};

FURROW_TEST(TestGuideText);
#include "tst_guide_text.moc"
