#include "planner/io/formats/dxf/dxf.h"

#include "planner/core/separated_text.h"
#include "planner/core/text.h"
#include "planner/gdal/utm_zone.h"

#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace furrow {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Pairs of a group code and a value.
class DrawingPairs {
public:
    explicit DrawingPairs(std::string_view text) : text_{text} {}

    bool next() {
        if (text_.empty()) {
            return false;
        }
        code_ = decimalIn(nextLine(text_));
        value_ = nextLine(text_);
        number_ += 2;
        return code_.has_value();
    }
    bool is(double code) const { return code_ == code; }
    std::string_view value() const { return value_; }
    std::size_t number() const { return number_; }

private:
    std::string_view text_;
    std::optional<double> code_;
    std::string_view value_;
    std::size_t number_ = 0;
};

class DrawingContent {
public:
    explicit DrawingContent(ReceivedContent& found) : found_{found} {}

    void take(const FileInMemory& file) {
        constexpr std::string_view kCode = "_EPSG";
        const std::size_t at = file.path.rfind(kCode);
        const std::size_t end = file.path.rfind('.');
        const auto epsg =
            at == std::string::npos || end < at
                ? std::nullopt
                : decimalIn(std::string_view{file.path}.substr(at + kCode.size(), end - at - kCode.size()));
        found_.namesCrs = epsg.has_value();
        const UtmZone zone{.epsg = static_cast<int>(epsg.value_or(0.0))};
        DrawingPairs pairs{file.bytes};
        std::string layer;
        std::string entity;
        bool inside = false;
        bool ended = false;
        while (pairs.next()) {
            if (pairs.is(0)) {
                entity = pairs.value();
                ended = entity == "EOF";
                if (entity == "POLYLINE") {
                    inside = true;
                    layer.clear();
                    lines_.push_back({.layer = {}, .first = places_.size()});
                } else if (entity == "VERTEX") {
                    places_.emplace_back(kNan, kNan);
                } else if (entity == "SEQEND" && inside) {
                    inside = false;
                    lines_.back().layer = layer;
                }
            } else if (inside && pairs.is(8) && layer.empty()) {
                layer = pairs.value();
            } else if (entity == "VERTEX" && !places_.empty() && (pairs.is(10) || pairs.is(20))) {
                (pairs.is(10) ? places_.back().first : places_.back().second) =
                    decimalIn(pairs.value()).value_or(kNan);
            }
        }
        if (!ended || inside) {
            found_.faults.push_back(badLine(pairs.number()));
        }
        const auto geo = zone.unproject(places_);
        if (!geo) {
            found_.namesCrs = false;
            return;
        }
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const std::size_t behind = i + 1 < lines_.size() ? lines_[i + 1].first : geo->size();
            add(lines_[i].layer, {geo->begin() + static_cast<std::ptrdiff_t>(lines_[i].first),
                                  geo->begin() + static_cast<std::ptrdiff_t>(behind)});
        }
        if (!path_.samples.empty()) {
            found_.paths.push_back(std::move(path_));
        }
    }

private:
    struct Line {
        std::string layer;
        std::size_t first = 0;  ///< of its places
    };

    void add(const std::string& layer, GeoRing points) {
        if (layer == "PATH") {
            for (const GeoPoint& point : points) {
                path_.samples.push_back({.geo = point});
            }
        } else if (layer == "SWATH") {
            found_.lines.push_back({.name = layer, .points = std::move(points), .widthM = std::nullopt});
        } else {
            found_.areas.push_back({.kind = layer == "BOUNDARY" || layer == "HOLE" ? ReceivedArea::Kind::Field
                                            : layer == "OBSTACLE" ? ReceivedArea::Kind::Obstacle
                                                                  : ReceivedArea::Kind::Other,
                                    .name = layer,
                                    .rings = {.outer = std::move(points), .holes = {}},
                                    .statedM2 = std::nullopt});
        }
    }

    ReceivedContent& found_;
    ReceivedPath path_;
    std::vector<Line> lines_;
    std::vector<std::pair<double, double>> places_;
};

}  // namespace

std::vector<ReceivedContent> findDxf(std::span<const FileInMemory> files, const ExportJob&) {
    std::vector<ReceivedContent> all;
    for (const FileInMemory& file : files) {
        ReceivedContent& found = all.emplace_back(ReceivedContent{.file = file.path, .repeatsFirst = false});
        DrawingContent{found}.take(file);
    }
    return all;
}

}  // namespace furrow
