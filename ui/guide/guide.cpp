#include "ui/guide/guide.h"

#include "ui/text/display.h"

namespace furrow {

Guide::Guide(QObject* parent) : QObject{parent}, chapters_{guideIn(Display::instance().shownLanguage())} {
    connect(&Display::instance(), &Display::changed, this, [this] {
        chapters_ = guideIn(Display::instance().shownLanguage());
        emit changed();
        emit chapterChanged();
        emit queryChanged();
    });
}

QStringList Guide::chapters() const {
    QStringList titles;
    for (const GuideChapter& chapter : chapters_) {
        titles << chapter.title;
    }
    return titles;
}

void Guide::setChapter(int chapter) {
    if (chapter != chapter_ && chapter < static_cast<int>(chapters_.size())) {
        chapter_ = chapter;
        emit chapterChanged();
    }
}

QVariantList Guide::blocks() const {
    QVariantList blocks;
    if (chapter_ < 0 || chapter_ >= static_cast<int>(chapters_.size())) {
        return blocks;
    }
    for (const GuideBlock& block : chapters_[static_cast<std::size_t>(chapter_)].blocks) {
        blocks << QVariantMap{
            {QStringLiteral("text"), block.text},
            {QStringLiteral("picture"), block.picture.isEmpty()
                                            ? QString{}
                                            : QStringLiteral("qrc:/furrow/guide/pictures/") + block.picture},
            {QStringLiteral("heading"), block.heading}};
    }
    return blocks;
}

void Guide::setQuery(const QString& query) {
    if (query != query_) {
        query_ = query;
        emit queryChanged();
    }
}

QVariantList Guide::hits() const {
    QVariantList hits;
    for (const GuideHit& hit : searchGuide(chapters_, query_)) {
        hits << QVariantMap{{QStringLiteral("chapter"), hit.chapter},
                            {QStringLiteral("block"), hit.block},
                            {QStringLiteral("title"), hit.title},
                            {QStringLiteral("excerpt"), hit.excerpt}};
    }
    return hits;
}

QVariantList Guide::searchable(const QString& group) const {
    QVariantList entries;
    for (int i = 0; i < static_cast<int>(chapters_.size()); ++i) {
        const GuideChapter& chapter = chapters_[static_cast<std::size_t>(i)];
        const auto add = [&](const QString& name, const QString& where, int block) {
            entries << QVariantMap{{QStringLiteral("kind"), QStringLiteral("guide")},
                                   {QStringLiteral("name"), name},
                                   {QStringLiteral("group"), where},
                                   {QStringLiteral("keywords"), chapter.title},
                                   {QStringLiteral("chapter"), i},
                                   {QStringLiteral("block"), block}};
        };
        add(chapter.title, group, 0);
        for (int k = 0; k < static_cast<int>(chapter.blocks.size()); ++k) {
            const GuideBlock& block = chapter.blocks[static_cast<std::size_t>(k)];
            if (!block.heading.isEmpty()) {
                // Sections of the same name are told apart by where they stand.
                add(block.heading, QStringLiteral("%1: %2").arg(group, block.within), k);
            }
        }
    }
    return entries;
}

}  // namespace furrow
