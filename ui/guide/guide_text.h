#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace furrow {

/// A piece of a chapter as it is shown: text in Markdown, or a picture.
struct GuideBlock {
    QString text;     ///< Markdown, or what the picture shows
    QString picture;  ///< its file name; empty for text
    QString heading;  ///< of the section that begins here; empty where none does
    QString within;   ///< the section that it belongs to, or the chapter

    friend bool operator==(const GuideBlock&, const GuideBlock&) = default;
};

struct GuideChapter {
    QString title;
    std::vector<GuideBlock> blocks;
};

/// A place where what was looked for stands.
struct GuideHit {
    int chapter = 0;
    int block = 0;
    QString title;    ///< of the chapter, or of the section
    QString excerpt;  ///< some words around it
};

/// A chapter from its file. Each heading, paragraph, list and picture is a block.
GuideChapter guideChapter(const QString& markdown);

/// The blocks that hold every word of the query, together with the heading above them; headings first. Cost:
/// O(text).
std::vector<GuideHit> searchGuide(const std::vector<GuideChapter>& chapters, const QString& query);

/// The chapters in this language ("de"); in English where there is no translation.
std::vector<GuideChapter> guideIn(const QString& language);

}  // namespace furrow
