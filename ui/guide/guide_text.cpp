#include "ui/guide/guide_text.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>

#include <algorithm>

namespace furrow {

namespace {

constexpr qsizetype kExcerptLetters = 110;
constexpr std::size_t kMostHits = 40;
const QString kGuide = QStringLiteral(":/furrow/guide/%1/%2.md");

/// Without the signs of Markdown, as it is read.
QString plain(QString markdown) {
    static const QRegularExpression signs{QStringLiteral(R"(^#+ |^[-*] |\*\*|`|\|)"),
                                          QRegularExpression::MultilineOption};
    return markdown.remove(signs).simplified();
}

QString excerptOf(const QString& text, const QString& word) {
    const qsizetype at = std::max<qsizetype>(0, text.indexOf(word, 0, Qt::CaseInsensitive));
    const qsizetype space = text.lastIndexOf(QLatin1Char(' '), std::max<qsizetype>(0, at - 30));
    const qsizetype from = at < 30 ? 0 : space + 1;
    QString excerpt = text.mid(from, kExcerptLetters);
    if (from > 0) {
        excerpt.prepend(QStringLiteral("… "));
    }
    if (from + kExcerptLetters < text.size()) {
        excerpt += QStringLiteral(" …");
    }
    return excerpt;
}

bool holdsAny(const QString& text, const QStringList& words) {
    return std::ranges::any_of(words,
                               [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

bool holdsAll(const QString& text, const QStringList& words) {
    return std::ranges::all_of(words,
                               [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

}  // namespace

GuideChapter guideChapter(const QString& markdown) {
    static const QRegularExpression picture{QStringLiteral(R"(^!\[([^\]]*)\]\(pictures/([^)]+)\)$)")};
    GuideChapter chapter;
    GuideBlock block;
    const auto flush = [&] {
        block.text = block.text.trimmed();
        if (!block.text.isEmpty()) {
            chapter.blocks.push_back(block);
        }
        block = {};
    };
    QString section;
    for (const QString& line : markdown.split(QLatin1Char('\n'))) {
        const QString trimmed = line.trimmed();
        if (const auto shown = picture.match(trimmed); shown.hasMatch()) {
            flush();
            chapter.blocks.push_back(
                {.text = shown.captured(1), .picture = shown.captured(2), .heading = {}});
        } else if (trimmed.startsWith(QStringLiteral("# "))) {
            chapter.title = trimmed.mid(2);
        } else if (trimmed.startsWith(QLatin1Char('#'))) {
            flush();
            const bool isInSection = trimmed.startsWith(QStringLiteral("###"));
            block = {.text = trimmed,
                     .picture = {},
                     .heading = plain(trimmed),
                     .within = isInSection ? section : chapter.title};
            section = isInSection ? section : block.heading;
            flush();
        } else if (trimmed.isEmpty()) {
            flush();
        } else {
            block.text += line + QLatin1Char('\n');
        }
    }
    flush();
    return chapter;
}

std::vector<GuideHit> searchGuide(const std::vector<GuideChapter>& chapters, const QString& query) {
    const QStringList words = query.simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    std::vector<GuideHit> inHeadings;
    std::vector<GuideHit> inTexts;
    if (words.isEmpty()) {
        return inHeadings;
    }
    for (int i = 0; i < static_cast<int>(chapters.size()); ++i) {
        const GuideChapter& chapter = chapters[static_cast<std::size_t>(i)];
        QString section = chapter.title;
        for (int k = 0; k < static_cast<int>(chapter.blocks.size()); ++k) {
            const GuideBlock& block = chapter.blocks[static_cast<std::size_t>(k)];
            if (!block.heading.isEmpty()) {
                section = block.heading;
            }
            const QString text = plain(block.text);
            if (!block.picture.isEmpty() || !holdsAny(text, words) ||
                !holdsAll(section + QLatin1Char(' ') + text, words)) {
                continue;
            }
            auto& hits = holdsAll(block.heading, words) ? inHeadings : inTexts;
            hits.push_back(
                {.chapter = i, .block = k, .title = section, .excerpt = excerptOf(text, words.front())});
        }
    }
    std::ranges::move(inTexts, std::back_inserter(inHeadings));
    inHeadings.resize(std::min(inHeadings.size(), kMostHits));
    return inHeadings;
}

std::vector<GuideChapter> guideIn(const QString& language) {
    std::vector<GuideChapter> chapters;
    const QDir english{QStringLiteral(":/furrow/guide/en")};
    for (const QString& file : english.entryList({QStringLiteral("*.md")}, QDir::Files, QDir::Name)) {
        const QString name = file.chopped(3);
        const QString own = kGuide.arg(language, name);
        QFile text{QFile::exists(own) ? own : kGuide.arg(QStringLiteral("en"), name)};
        if (text.open(QIODevice::ReadOnly)) {
            chapters.push_back(guideChapter(QString::fromUtf8(text.readAll())));
        }
    }
    return chapters;
}

}  // namespace furrow
