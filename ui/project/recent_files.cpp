#include "ui/project/recent_files.h"

#include "ui/project/field_outline.h"
#include "ui/text/display.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>

#include <algorithm>

namespace furrow {

namespace {
constexpr qsizetype kMostEntries = 10;
}

RecentFiles::RecentFiles(QObject* parent) : QAbstractListModel{parent} {
    connect(&Display::instance(), &Display::changed, this, [this] {
        if (rowCount() > 0) {
            emit dataChanged(index(0), index(rowCount() - 1));
        }
    });
}

void RecentFiles::keepIn(const QString& file) {
    file_ = file;
    QFile kept{file};
    beginResetModel();
    entries_.clear();
    if (kept.open(QIODevice::ReadOnly)) {
        for (const QJsonValue& value : QJsonDocument::fromJson(kept.readAll()).array()) {
            const QJsonObject object = value.toObject();
            Entry entry{.path = object.value(u"path").toString(),
                        .fields = object.value(u"fields").toInt(),
                        .outline = {}};
            for (const QJsonValue& point : object.value(u"outline").toArray()) {
                entry.outline.emplace_back(point.toArray().at(0).toDouble(),
                                           point.toArray().at(1).toDouble());
            }
            if (QFileInfo::exists(entry.path)) {
                entries_.push_back(std::move(entry));
            }
        }
    }
    endResetModel();
    emit countChanged();
}

void RecentFiles::add(const QString& path, const Project& project) {
    Entry entry{.path = path, .fields = static_cast<int>(project.fields.size()), .outline = {}};
    if (const ProjectField* field = project.field()) {
        entry.outline = fieldOutline(*field->source);
    }
    const auto known = std::ranges::find(entries_, path, &Entry::path);
    if (known != entries_.end()) {
        const auto row = static_cast<int>(known - entries_.begin());
        beginRemoveRows({}, row, row);
        entries_.erase(known);
        endRemoveRows();
    }
    beginInsertRows({}, 0, 0);
    entries_.prepend(std::move(entry));
    endInsertRows();
    if (entries_.size() > kMostEntries) {
        beginRemoveRows({}, static_cast<int>(kMostEntries), count() - 1);
        entries_.resize(kMostEntries);
        endRemoveRows();
    }
    save();
    emit countChanged();
}

void RecentFiles::clear() {
    beginResetModel();
    entries_.clear();
    endResetModel();
    save();
    emit countChanged();
}

int RecentFiles::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : count();
}

QVariant RecentFiles::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const Entry& entry = entries_.at(index.row());
    const QFileInfo info{entry.path};
    switch (role) {
        case PathRole: return entry.path;
        case Qt::DisplayRole:
        case NameRole: return info.completeBaseName();
        case FolderRole: return QDir::toNativeSeparators(info.path());
        case FieldsRole: return tr("%n field(s)", nullptr, entry.fields);
        case OutlineRole: return QVariant::fromValue(entry.outline);
        default: return {};
    }
}

QHash<int, QByteArray> RecentFiles::roleNames() const {
    return {{PathRole, "path"},
            {NameRole, "name"},
            {FolderRole, "folder"},
            {FieldsRole, "fields"},
            {OutlineRole, "outline"}};
}

void RecentFiles::save() const {
    if (file_.isEmpty()) {
        return;
    }
    QJsonArray list;
    for (const Entry& entry : entries_) {
        QJsonArray outline;
        for (const QPointF point : entry.outline) {
            outline.append(QJsonArray{point.x(), point.y()});
        }
        list.append(QJsonObject{{QStringLiteral("path"), entry.path},
                                {QStringLiteral("fields"), entry.fields},
                                {QStringLiteral("outline"), outline}});
    }
    QDir{}.mkpath(QFileInfo{file_}.path());
    QSaveFile kept{file_};
    // A list that cannot be kept is no reason to disturb anybody.
    if (kept.open(QIODevice::WriteOnly) &&
        kept.write(QJsonDocument{list}.toJson(QJsonDocument::Compact)) > 0) {
        kept.commit();
    }
}

}  // namespace furrow
