#include "ui/files/file_browser.h"

#include "ui/files/native_dialog.h"
#include "ui/files/sticks.h"

#include <QCollator>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QSettings>
#include <QStandardPaths>

#include <algorithm>
#include <utility>

namespace furrow {

namespace {

constexpr int kLookEveryMs = 1000;
constexpr qsizetype kRecentFolders = 5;
constexpr auto kRecentKey = "files/folders";

QStringList recentFolders() {
    return QSettings{}.value(QLatin1String{kRecentKey}).toStringList();
}

QVariantMap placeOf(const QString& name, const QString& path, const QString& kind) {
    return {{QStringLiteral("name"), name}, {QStringLiteral("path"), path}, {QStringLiteral("kind"), kind}};
}

}  // namespace

FileBrowser::FileBrowser(QObject* parent) : QAbstractListModel{parent} {
    timer_.setInterval(kLookEveryMs);
    connect(&timer_, &QTimer::timeout, this, &FileBrowser::lookForSticks);
    connect(&runner_, &JobRunner::slowChanged, this, &FileBrowser::readingChanged);
    connect(this, &FileBrowser::patternsChanged, this, &FileBrowser::refresh);
}

bool FileBrowser::hasDesktopDialog() const {
    return desktopHasFileDialog();
}

bool FileBrowser::canGoUp() const {
    return !folder_.isEmpty() && !QDir{folder_}.isRoot();
}

void FileBrowser::setPatterns(const QStringList& patterns) {
    if (patterns != patterns_) {
        patterns_ = patterns;
        emit patternsChanged();
    }
}

FileBrowser::Listing FileBrowser::listingOf(const QString& folder, const QStringList& patterns,
                                            bool foldersOnly) {
    Listing listing;
    const QDir dir{folder};
    listing.readable = QFileInfo{folder}.isReadable();
    const auto wanted = foldersOnly ? QDir::Dirs : QDir::Dirs | QDir::Files;
    for (const QFileInfo& info : dir.entryInfoList(wanted | QDir::NoDotAndDotDot, QDir::NoSort)) {
        if (info.isDir() || patterns.isEmpty() || QDir::match(patterns, info.fileName())) {
            listing.entries.push_back({info.fileName(), info.isDir(), info.lastModified(), info.size()});
        }
    }
    return listing;
}

void FileBrowser::sort(std::vector<Entry>& entries) const {
    QCollator names;
    names.setNumericMode(true);
    names.setCaseSensitivity(Qt::CaseInsensitive);
    std::ranges::sort(entries, [this, &names](const Entry& a, const Entry& b) {
        if (a.isFolder != b.isFolder) {
            return a.isFolder;
        }
        const Entry& first = descending_ ? b : a;
        const Entry& second = descending_ ? a : b;
        if (order_ == ByDate && first.changed != second.changed) {
            return first.changed < second.changed;
        }
        if (order_ == BySize && !a.isFolder && first.bytes != second.bytes) {
            return first.bytes < second.bytes;
        }
        return order_ == ByName ? names.compare(first.name, second.name) < 0
                                : names.compare(a.name, b.name) < 0;
    });
}

void FileBrowser::show(const QString& folder) {
    const QString wanted = QDir::cleanPath(QDir{folder}.absolutePath());
    if (folder.isEmpty() || !QFileInfo{wanted}.isDir()) {
        return;
    }
    const bool moved = std::exchange(folder_, wanted) != wanted;
    runner_.submit([this, wanted, patterns = patterns_,
                    foldersOnly = foldersOnly_](const JobContext&) -> JobRunner::Delivery {
        return [this, wanted, listing = listingOf(wanted, patterns, foldersOnly)]() mutable {
            if (wanted != folder_) {
                return;
            }
            beginResetModel();
            sort(listing.entries);
            entries_ = std::move(listing.entries);
            endResetModel();
            trouble_ = listing.readable ? QString{} : tr("This folder cannot be read.");
            emit listed();
        };
    });
    if (moved) {
        emit folderChanged();
    }
}

void FileBrowser::showLast() {
    const QStringList recent = recentFolders();
    const auto there =
        std::ranges::find_if(recent, [](const QString& folder) { return QFileInfo{folder}.isDir(); });
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    show(there != recent.end() ? *there : QFileInfo{documents}.isDir() ? documents : QDir::homePath());
}

void FileBrowser::goUp() {
    QDir dir{folder_};
    if (canGoUp() && dir.cdUp()) {
        show(dir.absolutePath());
    }
}

void FileBrowser::refresh() {
    show(folder_);
}

void FileBrowser::sortBy(Order order) {
    descending_ = order == order_ ? !descending_ : order != ByName;
    order_ = order;
    beginResetModel();
    sort(entries_);
    endResetModel();
    emit orderChanged();
    emit listed();
}

QVariantList FileBrowser::places() const {
    QVariantList all;
    QStringList known;
    const auto add = [&](const QString& name, const QString& path, const QString& kind) {
        if (!path.isEmpty() && !known.contains(path) && QFileInfo{path}.isDir()) {
            known << path;
            all << placeOf(name, path, kind);
        }
    };
    add(tr("Home"), QDir::homePath(), QStringLiteral("home"));
    const auto standard = [](QStandardPaths::StandardLocation where) {
        return QStandardPaths::writableLocation(where);
    };
    add(tr("Documents"), standard(QStandardPaths::DocumentsLocation), QStringLiteral("folder"));
    add(tr("Downloads"), standard(QStandardPaths::DownloadLocation), QStringLiteral("folder"));
    add(tr("Desktop"), standard(QStandardPaths::DesktopLocation), QStringLiteral("folder"));
    for (const QVariant& stick : sticks_) {
        all << stick;
        known << stick.toMap().value(QStringLiteral("path")).toString();
    }
    add(tr("Computer"), QDir::rootPath(), QStringLiteral("computer"));
    for (const QString& folder : recentFolders()) {
        add(QDir{folder}.dirName(), folder, QStringLiteral("recent"));
    }
    return all;
}

void FileBrowser::lookForSticks() {
    QVariantList found;
    for (const QStorageInfo& volume : pluggedIn()) {
        found << placeOf(furrow::nameOf(volume), volume.rootPath(), QStringLiteral("stick"));
    }
    if (found != sticks_) {
        sticks_ = found;
        emit placesChanged();
    }
}

void FileBrowser::setWatching(bool watching) {
    if (watching == isWatching()) {
        return;
    }
    if (watching) {
        timer_.start();
        lookForSticks();
    } else {
        timer_.stop();
    }
    emit placesChanged();
}

int FileBrowser::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : count();
}

QVariant FileBrowser::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const Entry& entry = entries_[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
        case NameRole: return entry.name;
        case PathRole: return pathAt(index.row());
        case FolderRole: return entry.isFolder;
        case ChangedRole: return QLocale{}.toString(entry.changed, QLocale::ShortFormat);
        case SizeRole:
            return entry.isFolder ? QString{}
                                  : QLocale{}.formattedDataSize(entry.bytes, 1, QLocale::DataSizeSIFormat);
        default: return {};
    }
}

QHash<int, QByteArray> FileBrowser::roleNames() const {
    return {{NameRole, "name"},
            {PathRole, "path"},
            {FolderRole, "isFolder"},
            {ChangedRole, "changed"},
            {SizeRole, "size"}};
}

const FileBrowser::Entry* FileBrowser::entryAt(int row) const {
    return row >= 0 && row < count() ? &entries_[static_cast<std::size_t>(row)] : nullptr;
}

QString FileBrowser::pathAt(int row) const {
    const Entry* const entry = entryAt(row);
    return entry == nullptr ? QString{} : QDir{folder_}.filePath(entry->name);
}

QString FileBrowser::nameAt(int row) const {
    const Entry* const entry = entryAt(row);
    return entry == nullptr ? QString{} : entry->name;
}

bool FileBrowser::isFolderAt(int row) const {
    const Entry* const entry = entryAt(row);
    return entry != nullptr && entry->isFolder;
}

int FileBrowser::rowOf(const QString& name) const {
    const auto found = std::ranges::find(entries_, name, &Entry::name);
    return found == entries_.end() ? -1 : static_cast<int>(found - entries_.begin());
}

int FileBrowser::rowBeginning(const QString& text, int from) const {
    for (int k = 0; k < count(); ++k) {
        const int row = (std::max(from, 0) + k) % count();
        if (nameAt(row).startsWith(text, Qt::CaseInsensitive)) {
            return row;
        }
    }
    return -1;
}

QString FileBrowser::absolute(const QString& typed) const {
    QString path = typed.trimmed();
    if (path.isEmpty()) {
        return {};
    }
    if (path == QLatin1String("~") || path.startsWith(QLatin1String("~/"))) {
        path.replace(0, 1, QDir::homePath());
    }
    return QDir::cleanPath(QDir{folder_}.absoluteFilePath(path));
}

FileBrowser::What FileBrowser::whatIs(const QString& path) const {
    const QFileInfo info{path};
    if (path.isEmpty() || info.fileName().size() > 255) {
        return Nothing;
    }
    if (info.isDir()) {
        return Folder;
    }
    if (info.exists()) {
        return File;
    }
    const QFileInfo around{info.path()};
    return !around.isDir() ? NoFolder : around.isWritable() ? NewFile : NotWritable;
}

QString FileBrowser::nameOf(const QString& path) const {
    return QFileInfo{path}.fileName();
}

QString FileBrowser::folderOf(const QString& path) const {
    return QFileInfo{path}.path();
}

QString FileBrowser::withSuffix(const QString& name, const QString& suffix) const {
    return suffix.isEmpty() || name.isEmpty() || !QFileInfo{name}.suffix().isEmpty() ? name
                                                                                     : name + u'.' + suffix;
}

bool FileBrowser::makeFolder(const QString& path) {
    if (path.isEmpty() || !QDir{}.mkpath(path)) {
        return false;
    }
    show(path);
    return true;
}

void FileBrowser::remember(const QString& folder) {
    QStringList recent = recentFolders();
    recent.removeAll(folder);
    recent.prepend(folder);
    QSettings{}.setValue(QLatin1String{kRecentKey}, recent.first(std::min(recent.size(), kRecentFolders)));
    emit placesChanged();
}

}  // namespace furrow
