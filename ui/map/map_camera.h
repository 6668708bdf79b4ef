#pragma once

#include "ui/map/map_frame.h"

#include <QtQml/qqmlregistration.h>
#include <QGeoRectangle>
#include <QMarginsF>
#include <QObject>
#include <QPointF>
#include <QSizeF>
#include <QVariantAnimation>

#include <optional>

namespace furrow {

/// What part of the world the map shows. North is up.
class MapCamera : public QObject {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(QGeoCoordinate center READ center NOTIFY changed FINAL)
    Q_PROPERTY(double zoomLevel READ zoomLevel NOTIFY changed FINAL)
    Q_PROPERTY(double metresPerPixel READ metresPerPixel NOTIFY changed FINAL)
    Q_PROPERTY(QSizeF viewport READ viewport WRITE setViewport NOTIFY viewportChanged FINAL)
    Q_PROPERTY(int motion READ motion WRITE setMotion NOTIFY motionChanged FINAL)

public:
    explicit MapCamera(QObject* parent = nullptr);

    static constexpr double kMaxZoom = 24.0;

    QGeoCoordinate center() const { return coordinate(center_); }
    WorldPoint worldCenter() const { return center_; }
    double zoomLevel() const { return zoom_; }
    double metresPerPixel() const;
    QSizeF viewport() const { return viewport_; }
    void setViewport(QSizeF viewport);
    int motion() const { return motion_; }
    /// How long a movement takes, ms; 0 for none.
    void setMotion(int motion);

    /// Pixels around the world.
    double scale() const;
    /// A place on the map's item, through the copy of the world that is nearest to the middle.
    QPointF toItem(WorldPoint place) const;
    WorldPoint toWorld(QPointF pixel) const;

    Q_INVOKABLE QPointF position(const QGeoCoordinate& place) const { return toItem(worldPoint(place)); }
    Q_INVOKABLE QGeoCoordinate coordinateAt(QPointF pixel) const { return coordinate(toWorld(pixel)); }
    /// Where a typed place is ("48.1371, 11.5754"); invalid where the text names none.
    Q_INVOKABLE QGeoCoordinate placeNamedBy(const QString& text) const;
    /// "48.13710° N, 11.57540° E".
    Q_INVOKABLE QString nameOf(const QGeoCoordinate& place) const;
    Q_INVOKABLE void panBy(double dx, double dy);
    /// Zooms by this many levels; what is under `pixel` stays there.
    Q_INVOKABLE void zoomAt(QPointF pixel, double levels, bool animated);
    Q_INVOKABLE void zoomBy(double levels);
    /// What a wheel was turned by, in eighths of a degree, with the pointer at `pixel`.
    Q_INVOKABLE void turnWheel(QPointF pixel, double eighths);
    /// Exactly this place and zoom, at once.
    Q_INVOKABLE void goTo(const QGeoCoordinate& place, double zoom);
    Q_INVOKABLE void centreOn(const QGeoCoordinate& place, double leastZoom, bool animated);
    /// Shows all of `area` inside the item less these margins; in an item of another size, too, until the map
    /// is moved.
    Q_INVOKABLE void fit(const QGeoRectangle& area, double left, double top, double right, double bottom,
                         bool animated);

signals:
    void changed();
    void viewportChanged();
    void motionChanged();

private:
    struct Fitted {
        QGeoRectangle area;
        QMarginsF margins;
    };

    void set(WorldPoint center, double zoom);
    /// Of the way of the running movement.
    void show(double share);
    void moveTo(WorldPoint center, double zoom, bool animated);
    double leastZoom() const;

    WorldPoint center_;
    double zoom_ = 3.0;
    QSizeF viewport_{800.0, 600.0};
    int motion_ = 140;
    QVariantAnimation animation_;
    WorldPoint fromCenter_;
    WorldPoint toCenter_;
    double fromZoom_ = 3.0;
    double toZoom_ = 3.0;
    /// Where a zoom is anchored, and what is there.
    bool anchored_ = false;
    QPointF anchorPixel_;
    WorldPoint anchorPlace_;
    std::optional<Fitted> fitted_;
};

}  // namespace furrow
