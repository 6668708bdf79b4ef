#pragma once

#include "ui/jobs/job_runner.h"

#include <QtQml/qqmlregistration.h>
#include <QAbstractListModel>
#include <QDateTime>
#include <QTimer>
#include <QUrl>
#include <QVariantList>

#include <vector>

namespace furrow {

/// The files of a folder, and the places to go to from it. Folders are read away from the GUI thread: some
/// lie on a network. Nothing is made but what is asked for.
class FileBrowser : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    /// Absolute; empty until one is shown.
    Q_PROPERTY(QString folder READ folder NOTIFY folderChanged FINAL)
    Q_PROPERTY(bool canGoUp READ canGoUp NOTIFY folderChanged FINAL)
    Q_PROPERTY(bool reading READ isReading NOTIFY readingChanged FINAL)
    /// Why the folder cannot be listed; empty where it is.
    Q_PROPERTY(QString trouble READ trouble NOTIFY listed FINAL)
    Q_PROPERTY(int count READ count NOTIFY listed FINAL)
    /// Of the files that are shown: "*.furrow"; all of them without one.
    Q_PROPERTY(QStringList patterns READ patterns WRITE setPatterns NOTIFY patternsChanged FINAL)
    Q_PROPERTY(bool foldersOnly MEMBER foldersOnly_ NOTIFY patternsChanged FINAL)
    Q_PROPERTY(Order order READ order NOTIFY orderChanged FINAL)
    Q_PROPERTY(bool descending READ isDescending NOTIFY orderChanged FINAL)
    /// Home, documents, what is plugged in and folders that were used, each with name, path and kind ("home",
    /// "folder", "stick", "recent", "computer").
    Q_PROPERTY(QVariantList places READ places NOTIFY placesChanged FINAL)
    /// Looks for what is plugged in or out, once a second.
    Q_PROPERTY(bool watching READ isWatching WRITE setWatching NOTIFY placesChanged FINAL)
    /// The desktop brings a dialog of its own.
    Q_PROPERTY(bool desktopDialog READ hasDesktopDialog CONSTANT FINAL)

public:
    enum Role { NameRole = Qt::UserRole + 1, PathRole, FolderRole, ChangedRole, SizeRole };
    enum Order { ByName, ByDate, BySize };
    Q_ENUM(Order)
    /// What a path is.
    enum What {
        Nothing,      ///< no name at all, or one that no file can have
        Folder,       ///< that is there
        File,         ///< that is there
        NewFile,      ///< a folder in which it can be made
        NoFolder,     ///< the folder around it is not there
        NotWritable,  ///< nothing can be made in the folder around it
    };
    Q_ENUM(What)

    explicit FileBrowser(QObject* parent = nullptr);

    const QString& folder() const { return folder_; }
    bool canGoUp() const;
    bool isReading() const { return runner_.isSlow(); }
    const QString& trouble() const { return trouble_; }
    int count() const { return static_cast<int>(entries_.size()); }
    const QStringList& patterns() const { return patterns_; }
    void setPatterns(const QStringList& patterns);
    Order order() const { return order_; }
    bool isDescending() const { return descending_; }
    QVariantList places() const;
    bool isWatching() const { return timer_.isActive(); }
    void setWatching(bool watching);
    bool hasDesktopDialog() const;

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

    /// Lists a folder; one that is not there leaves what is shown.
    Q_INVOKABLE void show(const QString& folder);
    /// The folder that was used last for files like these, or the documents.
    Q_INVOKABLE void showLast();
    Q_INVOKABLE void goUp();
    /// Lists it again.
    Q_INVOKABLE void refresh();
    /// By another column; by the same one the other way round.
    Q_INVOKABLE void sortBy(furrow::FileBrowser::Order order);
    Q_INVOKABLE QString pathAt(int row) const;
    Q_INVOKABLE QString nameAt(int row) const;
    Q_INVOKABLE bool isFolderAt(int row) const;
    /// -1 where there is none of that name.
    Q_INVOKABLE int rowOf(const QString& name) const;
    /// The first from this row on, all around, whose name begins so; -1 where none does.
    Q_INVOKABLE int rowBeginning(const QString& text, int from) const;
    /// What somebody typed as an absolute path: also "~" and names in the folder that is shown.
    Q_INVOKABLE QString absolute(const QString& typed) const;
    Q_INVOKABLE furrow::FileBrowser::What whatIs(const QString& path) const;
    Q_INVOKABLE QString nameOf(const QString& path) const;
    Q_INVOKABLE QString folderOf(const QString& path) const;
    Q_INVOKABLE QUrl urlOf(const QString& path) const { return QUrl::fromLocalFile(path); }
    Q_INVOKABLE QString pathOf(const QUrl& url) const { return url.toLocalFile(); }
    /// "plan.pdf" from "plan": where a name has no ending of its own.
    Q_INVOKABLE QString withSuffix(const QString& name, const QString& suffix) const;
    /// Makes a folder with those above it, and shows it. False where it cannot be made.
    Q_INVOKABLE bool makeFolder(const QString& path);
    /// A folder was used: it is among the places from now on.
    Q_INVOKABLE void remember(const QString& folder);

signals:
    void folderChanged();
    void readingChanged();
    void listed();
    void patternsChanged();
    void orderChanged();
    void placesChanged();

private:
    struct Entry {
        QString name;
        bool isFolder = false;
        QDateTime changed;
        qint64 bytes = 0;
    };
    struct Listing {
        std::vector<Entry> entries;
        bool readable = true;
    };
    static Listing listingOf(const QString& folder, const QStringList& patterns, bool foldersOnly);
    void sort(std::vector<Entry>& entries) const;
    const Entry* entryAt(int row) const;
    void lookForSticks();

    QString folder_;
    QString trouble_;
    QStringList patterns_;
    bool foldersOnly_ = false;
    Order order_ = ByName;
    bool descending_ = false;
    std::vector<Entry> entries_;
    QVariantList sticks_;
    QTimer timer_;
    JobRunner runner_;
};

}  // namespace furrow
