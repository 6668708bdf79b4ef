#include "ui/map/map_camera.h"

#include "planner/core/place_text.h"
#include "ui/text/unit_text.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace furrow {

MapCamera::MapCamera(QObject* parent)
    : QObject{parent}, center_{worldPoint(GeoPoint{.lonDeg = 12.0, .latDeg = 48.0})} {
    animation_.setStartValue(0.0);
    animation_.setEndValue(1.0);
    animation_.setEasingCurve(QEasingCurve::OutCubic);
    connect(&animation_, &QVariantAnimation::valueChanged, this,
            [this](const QVariant& value) { show(value.toDouble()); });
}

void MapCamera::show(double share) {
    const double zoom = fromZoom_ + share * (toZoom_ - fromZoom_);
    if (anchored_) {
        const double pixels = 256.0 * std::exp2(zoom);
        set({anchorPlace_.x - (anchorPixel_.x() - viewport_.width() / 2.0) / pixels,
             anchorPlace_.y - (anchorPixel_.y() - viewport_.height() / 2.0) / pixels},
            zoom);
    } else {
        set({fromCenter_.x + share * (toCenter_.x - fromCenter_.x),
             fromCenter_.y + share * (toCenter_.y - fromCenter_.y)},
            zoom);
    }
}

double MapCamera::metresPerPixel() const {
    const double latRad = geoPoint(center_).latDeg * std::numbers::pi / 180.0;
    return 40075016.685578488 * std::cos(latRad) / scale();
}

void MapCamera::setViewport(QSizeF viewport) {
    if (viewport == viewport_ || viewport.isEmpty()) {
        return;
    }
    viewport_ = viewport;
    emit viewportChanged();
    if (const auto shown = fitted_) {
        const QMarginsF& margins = shown->margins;
        fit(shown->area, margins.left(), margins.top(), margins.right(), margins.bottom(), false);
    } else {
        set(center_, zoom_);
    }
    emit changed();
}

void MapCamera::setMotion(int motion) {
    if (motion != motion_) {
        motion_ = motion;
        emit motionChanged();
    }
}

double MapCamera::scale() const {
    return 256.0 * std::exp2(zoom_);
}

QPointF MapCamera::toItem(WorldPoint place) const {
    WorldPoint way = place - center_;
    way.x -= std::round(way.x);
    return {viewport_.width() / 2.0 + way.x * scale(), viewport_.height() / 2.0 + way.y * scale()};
}

WorldPoint MapCamera::toWorld(QPointF pixel) const {
    const double x = center_.x + (pixel.x() - viewport_.width() / 2.0) / scale();
    return {x - std::floor(x), center_.y + (pixel.y() - viewport_.height() / 2.0) / scale()};
}

void MapCamera::panBy(double dx, double dy) {
    fitted_.reset();
    animation_.stop();
    set({center_.x - dx / scale(), center_.y - dy / scale()}, zoom_);
}

void MapCamera::zoomAt(QPointF pixel, double levels, bool animated) {
    fitted_.reset();
    const bool running = animation_.state() == QAbstractAnimation::Running && anchored_;
    const double target = std::clamp((running ? toZoom_ : zoom_) + levels, leastZoom(), kMaxZoom);
    if (!running || anchorPixel_ != pixel) {
        anchorPixel_ = pixel;
        const WorldPoint way{(pixel.x() - viewport_.width() / 2.0) / scale(),
                             (pixel.y() - viewport_.height() / 2.0) / scale()};
        anchorPlace_ = {center_.x + way.x, center_.y + way.y};
    }
    animation_.stop();
    anchored_ = true;
    fromZoom_ = zoom_;
    toZoom_ = target;
    if (!animated || motion_ <= 0) {
        show(1.0);
        return;
    }
    animation_.setDuration(motion_);
    animation_.start();
}

void MapCamera::zoomBy(double levels) {
    zoomAt({viewport_.width() / 2.0, viewport_.height() / 2.0}, levels, true);
}

void MapCamera::turnWheel(QPointF pixel, double eighths) {
    constexpr double kEighthsPerNotch = 120.0;
    constexpr double kLevelsPerNotch = 0.5;
    const double notches = eighths / kEighthsPerNotch;
    // Touch pads send many small turns: these are the motion already.
    zoomAt(pixel, notches * kLevelsPerNotch, std::abs(notches) >= 0.5);
}

QGeoCoordinate MapCamera::placeNamedBy(const QString& text) const {
    const auto place = furrow::placeNamedBy(text.toStdString());
    return place ? QGeoCoordinate{place->latDeg, place->lonDeg} : QGeoCoordinate{};
}

QString MapCamera::nameOf(const QGeoCoordinate& place) const {
    return placeText(geoPoint(place));
}

void MapCamera::goTo(const QGeoCoordinate& place, double zoom) {
    if (place.isValid()) {
        moveTo(worldPoint(place), zoom, false);
    }
}

void MapCamera::centreOn(const QGeoCoordinate& place, double leastZoom, bool animated) {
    if (place.isValid()) {
        moveTo(worldPoint(place), std::max(zoom_, leastZoom), animated);
    }
}

void MapCamera::fit(const QGeoRectangle& area, double left, double top, double right, double bottom,
                    bool animated) {
    if (!area.isValid()) {
        return;
    }
    const WorldPoint corner = worldPoint(area.topLeft());
    WorldPoint opposite = worldPoint(area.bottomRight());
    if (opposite.x < corner.x) {
        opposite.x += 1.0;
    }
    const double width = std::max(viewport_.width() - left - right, 64.0);
    const double height = std::max(viewport_.height() - top - bottom, 64.0);
    const double widest = std::max(opposite.x - corner.x, 1e-9);
    const double highest = std::max(opposite.y - corner.y, 1e-9);
    const double zoom =
        std::clamp(std::log2(std::min(width / widest, height / highest) / 256.0), leastZoom(), kMaxZoom);
    const double pixels = 256.0 * std::exp2(zoom);
    moveTo({(corner.x + opposite.x) / 2.0 - (left - right) / 2.0 / pixels,
            (corner.y + opposite.y) / 2.0 - (top - bottom) / 2.0 / pixels},
           zoom, animated);
    fitted_ = {.area = area, .margins = {left, top, right, bottom}};
}

void MapCamera::moveTo(WorldPoint center, double zoom, bool animated) {
    fitted_.reset();
    animation_.stop();
    // A movement over many screens would only be a blur.
    const double way = std::hypot(center.x - center_.x, center.y - center_.y) * scale();
    if (!animated || motion_ <= 0 || way > 4.0 * viewport_.width() || std::abs(zoom - zoom_) > 4.0) {
        set(center, zoom);
        return;
    }
    anchored_ = false;
    fromCenter_ = center_;
    toCenter_ = center;
    fromZoom_ = zoom_;
    toZoom_ = zoom;
    animation_.setDuration(motion_);
    animation_.start();
}

void MapCamera::set(WorldPoint center, double zoom) {
    zoom = std::clamp(zoom, leastZoom(), kMaxZoom);
    const double half = viewport_.height() / 2.0 / (256.0 * std::exp2(zoom));
    center.x -= std::floor(center.x);
    center.y = half < 0.5 ? std::clamp(center.y, half, 1.0 - half) : 0.5;
    if (center == center_ && zoom == zoom_) {
        return;
    }
    center_ = center;
    zoom_ = zoom;
    emit changed();
}

double MapCamera::leastZoom() const {
    return std::log2(std::max(viewport_.width(), viewport_.height()) / 256.0);
}

}  // namespace furrow
