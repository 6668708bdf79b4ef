#pragma once

#include "ui/guide/guide_text.h"

#include <QtQml/qqmlregistration.h>
#include <QObject>
#include <QVariant>

namespace furrow {

/// The user's guide in the language of the window: its chapters, the one that is read, and what is found.
class Guide : public QObject {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(QStringList chapters READ chapters NOTIFY changed FINAL)
    /// The one that is read; -1 for the list of all.
    Q_PROPERTY(int chapter READ chapter WRITE setChapter NOTIFY chapterChanged FINAL)
    /// Of it: text, picture (a URL) and heading of each.
    Q_PROPERTY(QVariantList blocks READ blocks NOTIFY chapterChanged FINAL)
    Q_PROPERTY(QString query READ query WRITE setQuery NOTIFY queryChanged FINAL)
    /// What is found: chapter, block, title and excerpt of each.
    Q_PROPERTY(QVariantList hits READ hits NOTIFY queryChanged FINAL)

public:
    explicit Guide(QObject* parent = nullptr);

    QStringList chapters() const;
    int chapter() const { return chapter_; }
    void setChapter(int chapter);
    QVariantList blocks() const;
    QString query() const { return query_; }
    void setQuery(const QString& query);
    QVariantList hits() const;
    /// Every section for the search of commands: name, group, chapter and block.
    /// @param group  the name of the guide, which begins that of the group
    Q_INVOKABLE QVariantList searchable(const QString& group) const;

signals:
    void changed();
    void chapterChanged();
    void queryChanged();

private:
    std::vector<GuideChapter> chapters_;
    int chapter_ = -1;
    QString query_;
};

}  // namespace furrow
