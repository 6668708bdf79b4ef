#include "ui/layers/imagery_model.h"

#include "planner/project/project_edits.h"
#include "ui/map/map_frame.h"
#include "ui/text/display.h"
#include "ui/text/unit_text.h"

#include <QDateTime>
#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace furrow {

namespace {

/// How often is looked whether the files are still there, and the same.
constexpr int kWatchMs = 2000;

/// Tells one state of a file from another; 0 where it is not there.
qint64 stampOf(const std::string& path) {
    const QFileInfo file{fromStd(path)};
    return file.exists() ? file.lastModified().toMSecsSinceEpoch() ^ (file.size() << 20) : 0;
}

bool isSameSource(const ImageryLayer& a, const ImageryLayer& b) {
    return a.path == b.path && a.rowsFromSouth == b.rowsFromSouth;
}

QGeoRectangle areaOf(const ImageryFacts& facts) {
    return QGeoRectangle{QGeoCoordinate{facts.northEast.latDeg, facts.southWest.lonDeg},
                         QGeoCoordinate{facts.southWest.latDeg, facts.northEast.lonDeg}};
}

}  // namespace

ImageryModel::ImageryModel(Document& document, QObject* parent)
    : QAbstractListModel{parent}, document_{document} {
    watch_.setInterval(kWatchMs);
    connect(&watch_, &QTimer::timeout, this, [this] {
        if (!watcher_.isBusy()) {
            watch();
        }
    });
    connect(&document_, &Document::projectChanged, this, &ImageryModel::follow);
    connect(&store_, &TileStore::opened, this, &ImageryModel::take);
    connect(&store_, &TileStore::failed, this, &ImageryModel::takeFailure);
    connect(&Display::instance(), &Display::changed, this, [this] {
        if (count() > 0) {
            emit dataChanged(index(0), index(count() - 1));
        }
        emit messageChanged();
    });
}

int ImageryModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant ImageryModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || !has(index.row())) {
        return {};
    }
    const Row& row = rows_[indexOf(index.row())];
    const Imagery* imagery = store_.imagery(row.sheet);
    switch (role) {
        case Qt::DisplayRole:
        case NameRole: return fromStd(row.layer.name);
        case PathRole: return fromStd(row.layer.path);
        case ShownRole: return row.layer.visible;
        case OpacityRole: return row.layer.opacity;
        case StateRole: return QVariant::fromValue(row.state);
        case ProblemRole: return sentence(row.error.what);
        case RemedyRole: return sentence(row.error.remedy);
        case HeightsRole: return imagery != nullptr && imagery->facts().kind == ImageryKind::Heights;
        case TilesRole: return imagery != nullptr && imagery->facts().isTileFolder;
        case RowsFromSouthRole: return imagery != nullptr && imagery->facts().rowsFromSouth;
        default: return {};
    }
}

QHash<int, QByteArray> ImageryModel::roleNames() const {
    return {{NameRole, "name"},     {PathRole, "path"},
            {ShownRole, "shown"},   {OpacityRole, "strength"},
            {StateRole, "state"},   {ProblemRole, "problem"},
            {RemedyRole, "remedy"}, {HeightsRole, "heights"},
            {TilesRole, "tiles"},   {RowsFromSouthRole, "rowsFromSouth"}};
}

std::vector<ImagerySheet> ImageryModel::sheets() const {
    std::vector<ImagerySheet> sheets;
    for (const Row& row : rows_) {
        if (row.layer.visible) {
            sheets.push_back({row.sheet, row.layer.opacity});
        }
    }
    return sheets;
}

void ImageryModel::addUrls(const QList<QUrl>& urls) {
    QStringList paths;
    for (const QUrl& url : urls) {
        if (url.isLocalFile()) {
            paths << url.toLocalFile();
        }
    }
    add(paths);
}

void ImageryModel::add(const QStringList& paths) {
    if (paths.isEmpty()) {
        return;
    }
    // What is asked for while others are still being looked at is added together with them.
    adding_ << paths;
    reader_.submit([this, paths = adding_](const JobContext& job) -> JobRunner::Delivery {
        std::vector<ImageryLayer> good;
        std::optional<Error> bad;
        for (const QString& path : paths) {
            if (job.stop.stop_requested()) {
                return {};
            }
            const QString whole = QFileInfo{path}.absoluteFilePath();
            if (const auto opened = openImagery(whole.toStdU16String())) {
                good.push_back({.path = whole.toStdString(),
                                .name = QFileInfo{whole}.completeBaseName().toStdString(),
                                .rowsFromSouth = {},
                                .others = {}});
            } else if (!bad) {
                bad = opened.error();
            }
        }
        return [this, good = std::move(good), bad] {
            adding_.clear();
            tell({}, {});
            if (bad) {
                tell(
                    [what = bad->what, name = QFileInfo{fromStd(bad->where.text())}.fileName()] {
                        return tr("%1: %2").arg(name, sentence(what));
                    },
                    [remedy = bad->remedy] { return sentence(remedy); });
            }
            if (!good.empty()) {
                document_.change(
                    [name = fromStd(good.front().name), one = good.size() == 1] {
                        return one ? tr("Add %1").arg(name) : tr("Add imagery");
                    },
                    withImagery(*document_.project(), good));
                // They lie above the others.
                for (std::size_t i = rows_.size() - good.size(); i < rows_.size(); ++i) {
                    rows_[i].announce = true;
                }
            }
        };
    });
}

void ImageryModel::change(int row, const char* text, const std::function<void(ImageryLayer&)>& edit,
                          const QString& key, bool live) {
    if (!has(row)) {
        return;
    }
    ImageryLayer layer = rows_[indexOf(row)].layer;
    edit(layer);
    document_.change([text] { return tr(text); },
                     withImageryLayer(*document_.project(), indexOf(row), std::move(layer)), key,
                     live ? Document::Follows::More : Document::Follows::Nothing);
}

void ImageryModel::remove(int row) {
    if (has(row)) {
        document_.change(
            [name = fromStd(rows_[indexOf(row)].layer.name)] { return tr("Remove %1").arg(name); },
            withoutImageryLayer(*document_.project(), indexOf(row)));
    }
}

void ImageryModel::move(int row, int steps) {
    if (has(row) && has(row + steps)) {
        document_.change([] { return tr("Move a layer"); },
                         withImageryMoved(*document_.project(), indexOf(row), indexOf(row + steps)));
    }
}

void ImageryModel::rename(int row, const QString& name) {
    if (!name.trimmed().isEmpty()) {
        change(row, QT_TR_NOOP("Rename a layer"),
               [&](ImageryLayer& layer) { layer.name = name.trimmed().toStdString(); });
    }
}

void ImageryModel::show(int row, bool shown) {
    change(row, shown ? QT_TR_NOOP("Show a layer") : QT_TR_NOOP("Hide a layer"),
           [&](ImageryLayer& layer) { layer.visible = shown; });
}

void ImageryModel::setOpacity(int row, double opacity, bool live) {
    change(
        row, QT_TR_NOOP("Change how strong a layer is"),
        [&](ImageryLayer& layer) { layer.opacity = std::clamp(opacity, 0.0, 1.0); },
        QStringLiteral("imagery.opacity.%1").arg(row), live);
    if (!live) {
        document_.endDrag();
    }
}

void ImageryModel::setRowsFromSouth(int row, bool fromSouth) {
    change(row, QT_TR_NOOP("Turn the rows of tiles round"),
           [&](ImageryLayer& layer) { layer.rowsFromSouth = fromSouth; });
}

void ImageryModel::tryAgain(int row) {
    if (has(row)) {
        open(rows_[indexOf(row)]);
        changed(indexOf(row));
    }
}

QGeoRectangle ImageryModel::areaOf(int row) const {
    const Imagery* imagery = has(row) ? store_.imagery(rows_[indexOf(row)].sheet) : nullptr;
    return imagery == nullptr ? QGeoRectangle{} : furrow::areaOf(imagery->facts());
}

double ImageryModel::contourStep(int row, double zoom) const {
    const Imagery* imagery = has(row) ? store_.imagery(rows_[indexOf(row)].sheet) : nullptr;
    return imagery == nullptr ? 0.0
                              : imagery->contourStepM(std::min(static_cast<int>(std::ceil(zoom - 0.25)),
                                                               imagery->facts().finestZoom));
}

void ImageryModel::open(Row& row) {
    if (row.sheet != 0) {
        store_.close(row.sheet);
    }
    row.state = State::Opening;
    row.error = {};
    row.stamp.reset();
    row.doubt.reset();
    row.sheet = store_.open(row.layer.path, row.layer.rowsFromSouth);
}

void ImageryModel::follow() {
    const std::vector<ImageryLayer>& layers = document_.project()->imagery;
    const int before = count();
    for (std::size_t i = rows_.size(); i-- > 0;) {
        if (std::ranges::none_of(
                layers, [&](const ImageryLayer& layer) { return isSameSource(layer, rows_[i].layer); })) {
            beginRemoveRows({}, rowOf(i), rowOf(i));
            store_.close(rows_[i].sheet);
            rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(i));
            endRemoveRows();
        }
    }
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const auto from =
            std::ranges::find_if(rows_.begin() + static_cast<std::ptrdiff_t>(i), rows_.end(),
                                 [&](const Row& row) { return isSameSource(row.layer, layers[i]); });
        if (from == rows_.end()) {
            // Above it in the list are those behind it here.
            const int place = static_cast<int>(rows_.size() - i);
            beginInsertRows({}, place, place);
            Row row{.layer = layers[i], .error = {}, .stamp = {}, .doubt = {}};
            open(row);
            rows_.insert(rows_.begin() + static_cast<std::ptrdiff_t>(i), std::move(row));
            endInsertRows();
        } else if (const auto at = static_cast<std::size_t>(from - rows_.begin()); at != i) {
            // Up in memory is down in the list: from row(at) to below row(i).
            beginMoveRows({}, rowOf(at), rowOf(at), {}, rowOf(i) + 1);
            std::rotate(rows_.begin() + static_cast<std::ptrdiff_t>(i), from, from + 1);
            endMoveRows();
        }
        if (rows_[i].layer != layers[i]) {
            rows_[i].layer = layers[i];
            changed(i);
        }
    }
    for (std::size_t i = rows_.size(); i-- > layers.size();) {
        beginRemoveRows({}, rowOf(i), rowOf(i));
        store_.close(rows_[i].sheet);
        rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(i));
        endRemoveRows();
    }
    if (count() != before) {
        emit countChanged();
    }
    if (rows_.empty()) {
        watch_.stop();
    } else if (!watch_.isActive()) {
        watch_.start();
    }
    emit sheetsChanged();
}

void ImageryModel::take(int sheet, const Result<void>& result) {
    const auto row = std::ranges::find(rows_, sheet, &Row::sheet);
    if (row == rows_.end()) {
        return;
    }
    const auto index = static_cast<std::size_t>(row - rows_.begin());
    row->state = result ? State::Ready : State::Failed;
    row->error = result ? Error{} : result.error();
    changed(index);
    watch();
    emit sheetsChanged();
    if (result && std::exchange(row->announce, false)) {
        emit added(areaOf(rowOf(index)));
    }
}

void ImageryModel::takeFailure(int sheet, const Error& error) {
    const auto row = std::ranges::find(rows_, sheet, &Row::sheet);
    if (row == rows_.end() || row->state == State::Failed) {
        return;
    }
    row->doubt = error;
    watch();
}

void ImageryModel::watch() {
    std::vector<std::string> paths;
    std::ranges::transform(rows_, std::back_inserter(paths), [](const Row& row) { return row.layer.path; });
    watcher_.submit(
        [this, paths = std::move(paths)](const JobContext&) -> JobRunner::Delivery {
            std::map<std::string, qint64> stamps;
            for (const std::string& path : paths) {
                stamps[path] = stampOf(path);
            }
            return [this, stamps = std::move(stamps)] { takeStamps(stamps); };
        },
        JobRunner::Replace::WhenDone);
}

void ImageryModel::takeStamps(const std::map<std::string, qint64>& stamps) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        Row& row = rows_[i];
        const auto found = stamps.find(row.layer.path);
        if (found == stamps.end() || row.state == State::Opening) {
            continue;
        }
        const qint64 stamp = found->second;
        const bool same = std::exchange(row.stamp, stamp).value_or(stamp) == stamp;
        const auto doubt = std::exchange(row.doubt, std::nullopt);
        if (same && !doubt) {
            continue;
        }
        if (stamp == 0) {
            row.state = State::Failed;
            row.error = {.code = ErrorCode::ReadFailed,
                         .what = "the file is not there any more",
                         .where = row.layer.path,
                         .remedy = "put it back, or remove the layer"};
        } else if (same) {
            row.state = State::Failed;
            row.error = *doubt;
        } else {
            // It came back, or another picture is there under the same name.
            open(row);
        }
        changed(i);
    }
}

void ImageryModel::changed(std::size_t index) {
    const QModelIndex row = createIndex(rowOf(index), 0);
    emit dataChanged(row, row);
}

void ImageryModel::tell(LazyText message, LazyText remedy) {
    if (text(message) != text(message_) || text(remedy) != text(remedy_)) {
        message_ = std::move(message);
        remedy_ = std::move(remedy);
        emit messageChanged();
    }
}

}  // namespace furrow
