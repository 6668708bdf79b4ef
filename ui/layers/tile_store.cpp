#include "ui/layers/tile_store.h"

#include "planner/jobs/wide_registers.h"
#include "ui/jobs/job_runner.h"

#include <algorithm>
#include <utility>

namespace furrow {

namespace {

constexpr int kThreads = 2;
/// What is kept at least, KiB; more where a large window shows more at once.
constexpr qsizetype kKeptKiB = 24 * 1024;

int costKiB(const QImage& image) {
    return std::max(1, static_cast<int>(image.sizeInBytes() / 1024));
}

/// A picture of its own memory; one without transparency says so and is drawn in less time.
QImage imageOf(const TilePicture& tile) {
    const QImage image{tile.rgba.data(), tile.side, tile.side, tile.side * 4,
                       QImage::Format_RGBA8888_Premultiplied};
    bool opaque = true;
    for (std::size_t i = 3; i < tile.rgba.size() && opaque; i += 4) {
        opaque = tile.rgba[i] == 255;
    }
    return opaque ? image.convertToFormat(QImage::Format_RGBX8888) : image.copy();
}

}  // namespace

size_t qHash(const TileKey& key, size_t seed) {
    return qHashMulti(seed, key.sheet, key.id.zoom, key.id.column, key.id.row);
}

TileStore::TileStore(QObject* parent) : QObject{parent}, tiles_{kKeptKiB} {
    for (int i = 0; i < kThreads; ++i) {
        threads_.emplace_back([this](const std::stop_token& stop) { serve(stop); });
    }
}

TileStore::~TileStore() {
    {
        const std::scoped_lock lock{mutex_};
        for (auto& [number, sheet] : sheets_) {
            sheet.stop.request_stop();
        }
    }
    for (std::jthread& thread : threads_) {
        thread.request_stop();
    }
    wake_.notify_all();
}

int TileStore::open(const std::filesystem::path& path, std::optional<bool> rowsFromSouth) {
    const int sheet = ++last_;
    {
        const std::scoped_lock lock{mutex_};
        sheets_[sheet];
        openings_.emplace_back([this, sheet, path, rowsFromSouth] {
            auto made = openImagery(path, rowsFromSouth);
            QMetaObject::invokeMethod(
                this,
                [this, sheet, made = std::move(made)] {
                    {
                        const std::scoped_lock own{mutex_};
                        const auto place = sheets_.find(sheet);
                        if (place == sheets_.end()) {
                            return;
                        }
                        if (made) {
                            place->second.imagery = *made;
                        }
                    }
                    emit opened(sheet, made ? Result<void>{} : std::unexpected(made.error()));
                },
                Qt::QueuedConnection);
        });
    }
    wake_.notify_one();
    return sheet;
}

void TileStore::close(int sheet) {
    {
        const std::scoped_lock lock{mutex_};
        if (const auto place = sheets_.find(sheet); place != sheets_.end()) {
            place->second.stop.request_stop();
            sheets_.erase(place);
        }
        std::erase_if(wanted_, [sheet](const TileKey& key) { return key.sheet == sheet; });
    }
    for (const TileKey& key : tiles_.keys()) {
        if (key.sheet == sheet) {
            tiles_.remove(key);
        }
    }
}

const Imagery* TileStore::imagery(int sheet) const {
    const std::scoped_lock lock{mutex_};
    const auto place = sheets_.find(sheet);
    return place == sheets_.end() ? nullptr : place->second.imagery.get();
}

void TileStore::want(std::vector<TileKey> keys, std::size_t room) {
    constexpr qsizetype kTileKiB = qsizetype{kTileSide} * kTileSide * 4 / 1024;
    tiles_.setMaxCost(std::max(kKeptKiB, kTileKiB * static_cast<qsizetype>(room + room / 2)));
    {
        const std::scoped_lock lock{mutex_};
        std::erase_if(keys,
                      [this](const TileKey& key) { return running_.contains(key) || tiles_.contains(key); });
        wanted_.assign(keys.begin(), keys.end());
    }
    wake_.notify_all();
}

bool TileStore::isIdle() const {
    const std::scoped_lock lock{mutex_};
    return openings_.empty() && wanted_.empty() && busy_ == 0;
}

void TileStore::serve(const std::stop_token& stop) {
    giveWayToTheWindow();
    clearWideRegisters();
    bool worked = false;
    while (true) {
        std::function<void()> work;
        {
            std::unique_lock lock{mutex_};
            const auto isWanted = [this] { return !openings_.empty() || !wanted_.empty(); };
            if (std::exchange(worked, false) && !wake_.wait_for(lock, stop, kIdleBeforeReturning, isWanted)) {
                lock.unlock();
                returnFreeMemory();
                lock.lock();
            }
            if (!wake_.wait(lock, stop, isWanted)) {
                return;
            }
            worked = true;
            ++busy_;
            if (!openings_.empty()) {
                work = std::move(openings_.front());
                openings_.pop_front();
            } else {
                const TileKey key = wanted_.front();
                wanted_.pop_front();
                const auto place = sheets_.find(key.sheet);
                if (place != sheets_.end() && place->second.imagery) {
                    running_.insert(key);
                    work = [this, key, imagery = place->second.imagery,
                            stopped = place->second.stop.get_token()] { readTile(key, imagery, stopped); };
                }
            }
        }
        if (work) {
            work();
        }
        const std::scoped_lock lock{mutex_};
        --busy_;
    }
}

void TileStore::readTile(const TileKey& key, const std::shared_ptr<const Imagery>& imagery,
                         const std::stop_token& stop) {
    auto tile = imagery->tile(key.id, {.stop = stop, .progress = {}, .threads = 1});
    const QImage image = tile && *tile ? imageOf(**tile) : QImage{};
    std::optional<Error> error = tile ? std::optional<Error>{} : tile.error();
    QMetaObject::invokeMethod(
        this,
        [this, key, image, error = std::move(error)] {
            {
                const std::scoped_lock lock{mutex_};
                running_.remove(key);
                if (!sheets_.contains(key.sheet)) {
                    return;
                }
            }
            if (error && error->code == ErrorCode::Cancelled) {
                return;
            }
            // What cannot be read is shown as nothing, so that it is not tried with every frame.
            tiles_.insert(key, new QImage{image}, costKiB(image));
            if (error) {
                emit failed(key.sheet, *error);
            }
            emit tilesChanged();
        },
        Qt::QueuedConnection);
}

}  // namespace furrow
