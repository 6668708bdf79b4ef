#pragma once

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QString>
#include <QTemporaryDir>

#include <lz4frame.h>
#include <zstd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <numbers>

// The samples of recorded tracks (tests/data/tracks/make_samples.py says where their four corners are).

namespace furrow::test {

inline constexpr double kStartS = 1777888800.0;  // date -u -d 2026-05-04T10:00:00Z +%s
inline constexpr double kPi = std::numbers::pi;

inline QString sample(const QString& name) {
    return QStringLiteral(FURROW_TEST_DATA_DIR "/tracks/") + name;
}

inline std::filesystem::path pathOf(const QString& name) {
    return name.toStdString();
}

inline QByteArray bytesOf(const QString& path) {
    QFile file{path};
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray{};
}

inline QString written(const QTemporaryDir& folder, const QString& name, const QByteArray& bytes) {
    QFile file{folder.filePath(name)};
    QDir{}.mkpath(QFileInfo{file}.path());
    file.remove();  // writing over a file waits for the disk
    if (!file.open(QIODevice::WriteOnly)) {
        return {};
    }
    file.write(bytes);
    return file.fileName();
}

inline bool near(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
}

template <class T>
T numberAt(const QByteArray& bytes, qsizetype at) {
    T value{};
    std::memcpy(&value, bytes.constData() + at, sizeof(T));
    return value;
}

template <class T>
QByteArray bytesOfNumber(T value) {
    return QByteArray{reinterpret_cast<const char*>(&value), sizeof(T)};
}

inline QByteArray packed(const QByteArray& bytes, const QByteArray& compression) {
    QByteArray out(static_cast<qsizetype>(ZSTD_compressBound(static_cast<std::size_t>(bytes.size())) + 1000),
                   '\0');
    const auto room = static_cast<std::size_t>(out.size());
    const auto size = static_cast<std::size_t>(bytes.size());
    return out.first(static_cast<qsizetype>(
        compression == "zstd" ? ZSTD_compress(out.data(), room, bytes.constData(), size, 3)
                              : LZ4F_compressFrame(out.data(), room, bytes.constData(), size, nullptr)));
}

/// The sample with its only chunk compressed; `statedSize` in place of its size, where that is given.
inline QByteArray withCompressedChunk(const QByteArray& compression, quint64 statedSize = 0) {
    const QByteArray plain = bytesOf(sample("odometry.mcap"));
    // Magic, header record, chunk record: opcode, length, 16 bytes of times, size, checksum, name, records.
    const qsizetype chunk = 8 + 9 + static_cast<qsizetype>(numberAt<quint64>(plain, 9));
    const auto length = static_cast<qsizetype>(numberAt<quint64>(plain, chunk + 1));
    const QByteArray body = plain.mid(chunk + 9, length);
    const QByteArray records = body.mid(16 + 8 + 4 + 4 + 8);
    const QByteArray small = packed(records, compression);
    const QByteArray made =
        body.first(16) +
        bytesOfNumber<quint64>(statedSize > 0 ? statedSize : static_cast<quint64>(records.size())) +
        body.mid(24, 4) + bytesOfNumber<quint32>(static_cast<quint32>(compression.size())) + compression +
        bytesOfNumber<quint64>(static_cast<quint64>(small.size())) + small;
    return plain.first(chunk + 1) + bytesOfNumber<quint64>(static_cast<quint64>(made.size())) + made +
           plain.mid(chunk + 9 + length);
}

}  // namespace furrow::test
