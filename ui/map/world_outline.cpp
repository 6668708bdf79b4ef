#include "ui/map/world_outline.h"

#include "ui/map/even_odd_fill.h"
#include "ui/map/simplify.h"

#include <QFile>

#include <algorithm>
#include <array>
#include <span>

namespace furrow {

namespace {

using Lines = std::vector<std::vector<MapPoint>>;

constexpr double kDegreesPerStep = 0.005;
/// Pixels of zoom 22 that a coarse level may be off: half a pixel up to zoom 4 and 7.
constexpr std::array<float, 3> kTolerances{131072.0F, 16384.0F, 0.0F};
constexpr std::size_t kPiecePoints = 1500;

class Reader {
public:
    explicit Reader(const QByteArray& bytes) : bytes_{bytes} {}

    qint64 number() {
        quint64 value = 0;
        for (int shift = 0; at_ < bytes_.size(); shift += 7) {
            const auto byte = static_cast<quint8>(bytes_[at_++]);
            value |= quint64{byte & 127U} << shift;
            if (byte < 128) {
                break;
            }
        }
        return (value & 1U) != 0 ? -static_cast<qint64>(value / 2) - 1 : static_cast<qint64>(value / 2);
    }
    Lines lines() {
        Lines lines(static_cast<std::size_t>(number()));
        for (auto& line : lines) {
            qint64 lon = 0;
            qint64 lat = 0;
            for (qint64 left = number(); left > 0; --left) {
                lon += number();
                lat += number();
                const WorldPoint place =
                    worldPoint(GeoPoint{.lonDeg = static_cast<double>(lon) * kDegreesPerStep,
                                        .latDeg = static_cast<double>(lat) * kDegreesPerStep});
                // Not the short way around: the outline runs from edge to edge of the square.
                line.push_back({static_cast<float>((place.x - 0.5) * kUnitsPerWorld),
                                static_cast<float>((place.y - 0.5) * kUnitsPerWorld)});
            }
        }
        return lines;
    }

private:
    const QByteArray& bytes_;
    qsizetype at_ = 4;
};

std::vector<WorldLevel::Lines> linePieces(const Lines& lines, bool closed) {
    std::vector<WorldLevel::Lines> pieces;
    LineMesh mesh;
    QRectF box;
    std::size_t points = 0;
    const auto flush = [&] {
        if (points > 0) {
            pieces.push_back({box, std::move(mesh)});
            mesh = {};
            box = {};
            points = 0;
        }
    };
    for (std::vector<MapPoint> line : lines) {
        if (closed) {
            line.push_back(line.front());
        }
        // Short lines share a piece with their neighbours in the file, long ones are cut.
        for (std::size_t from = 0; from + 1 < line.size(); from += kPiecePoints) {
            const auto part = std::span{line}.subspan(from, std::min(kPiecePoints + 1, line.size() - from));
            mesh.add(part);
            box = points == 0 ? boxOf(part) : box.united(boxOf(part));
            points += part.size();
            if (points >= kPiecePoints) {
                flush();
            }
        }
    }
    flush();
    return pieces;
}

std::vector<WorldLevel::Land> landPieces(const Lines& rings) {
    const FillMesh triangles = evenOddTriangles(rings);
    std::vector<WorldLevel::Land> pieces;
    for (std::size_t from = 0; from < triangles.size(); from += 6 * kPiecePoints) {
        const auto part =
            std::span{triangles}.subspan(from, std::min(6 * kPiecePoints, triangles.size() - from));
        pieces.push_back({boxOf(part), FillMesh{part.begin(), part.end()}});
    }
    return pieces;
}

Lines coarser(const Lines& lines, float tolerance, std::size_t leastPoints) {
    Lines result;
    for (const auto& line : lines) {
        std::vector<MapPoint> fewer = tolerance > 0.0F ? simplified(line, tolerance) : line;
        if (fewer.size() >= leastPoints) {
            result.push_back(std::move(fewer));
        }
    }
    return result;
}

}  // namespace

std::shared_ptr<const WorldOutline> readWorldOutline() {
    auto outline = std::make_shared<WorldOutline>();
    QFile file{QStringLiteral(":/furrow/map/world_outline.bin")};
    if (!file.open(QIODevice::ReadOnly)) {
        return outline;
    }
    const QByteArray bytes = file.readAll();
    if (!bytes.startsWith("FWO1")) {
        return outline;
    }
    Reader reader{bytes};
    const Lines land = reader.lines();
    const Lines borders = reader.lines();
    for (const float tolerance : kTolerances) {
        const Lines rings = coarser(land, tolerance, 3);
        outline->levels.push_back(
            {landPieces(rings), linePieces(rings, true), linePieces(coarser(borders, tolerance, 2), false)});
    }
    return outline;
}

}  // namespace furrow
