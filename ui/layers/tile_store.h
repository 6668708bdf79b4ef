#pragma once

#include "planner/imagery/imagery.h"

#include <QCache>
#include <QHash>
#include <QImage>
#include <QObject>
#include <QSet>

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

namespace furrow {

/// A tile of one of the rasters that are open.
struct TileKey {
    int sheet = 0;
    TileId id;

    friend bool operator==(const TileKey&, const TileKey&) = default;
};

size_t qHash(const TileKey& key, size_t seed = 0);

/// Reads tiles of imagery away from the GUI thread and keeps those that were shown last, in bounded memory.
/// What is wanted last is read first. All but the reading happens in the GUI thread, or while it waits for a
/// frame.
class TileStore : public QObject {
    Q_OBJECT

public:
    explicit TileStore(QObject* parent = nullptr);
    /// Stops what runs and waits for it.
    ~TileStore() override;

    /// Opens imagery; `opened` tells how it went. Gives a number that no other one had.
    int open(const std::filesystem::path& path, std::optional<bool> rowsFromSouth);
    /// Forgets imagery with its tiles.
    void close(int sheet);
    /// Null while it is not open.
    const Imagery* imagery(int sheet) const;

    /// A tile that was read: a null picture where there is nothing. Null where it was not read, or is not
    /// kept.
    const QImage* find(const TileKey& key) const { return tiles_.object(key); }
    /// What is to be read, the most urgent first; what was wanted before and is not begun is given up. Room
    /// is made for so many tiles at least.
    void want(std::vector<TileKey> keys, std::size_t room);
    /// Nothing is read and nothing waits.
    bool isIdle() const;
    /// Pixels that are kept, in bytes.
    qsizetype keptBytes() const { return tiles_.totalCost() * 1024; }

signals:
    void opened(int sheet, const furrow::Result<void>& result);
    /// A tile could not be read.
    void failed(int sheet, const furrow::Error& error);
    void tilesChanged();

private:
    struct Sheet {
        std::shared_ptr<const Imagery> imagery;
        std::stop_source stop;
    };
    void serve(const std::stop_token& stop);
    void readTile(const TileKey& key, const std::shared_ptr<const Imagery>& imagery,
                  const std::stop_token& stop);

    QCache<TileKey, QImage> tiles_;
    int last_ = 0;

    mutable std::mutex mutex_;  ///< of what follows
    std::map<int, Sheet> sheets_;
    std::condition_variable_any wake_;
    std::deque<std::function<void()>> openings_;
    std::deque<TileKey> wanted_;
    QSet<TileKey> running_;
    int busy_ = 0;
    /// Last, so that they end before anything they use.
    std::vector<std::jthread> threads_;
};

}  // namespace furrow
