#pragma once

#include "ui/map/mesh.h"

#include <QColor>
#include <QSGGeometryNode>

namespace furrow {

/// How a line looks at every zoom.
struct LineStyle {
    QColor color;
    double widthPx = 1.0;
    double dashPx = 0.0;    ///< drawn part of a dash
    double periodPx = 0.0;  ///< dash and gap; 0 for a full line

    friend bool operator==(const LineStyle&, const LineStyle&) = default;
};

/// Lines of constant width in pixels.
class LineNode : public QSGGeometryNode {
public:
    LineNode();

    void setMesh(const LineMesh& mesh);
    void setStyle(const LineStyle& style);
    /// Pixels of the item in one unit, device pixels in one pixel.
    void setScale(double pixelsPerUnit, double devicePixelRatio);
    /// A blocked node is not drawn.
    void setShown(bool shown);
    bool isSubtreeBlocked() const override { return !shown_; }

private:
    bool shown_ = true;
};

/// A filled area, plain or hatched.
class FillNode : public QSGGeometryNode {
public:
    FillNode();

    void setMesh(const FillMesh& mesh);
    /// `hatchPx`: distance between the lines of a hatching, 0 for a plain fill.
    void setStyle(const QColor& color, double hatchPx = 0.0);
    void setScale(double pixelsPerUnit, double devicePixelRatio);
    void setShown(bool shown);
    bool isSubtreeBlocked() const override { return !shown_; }

private:
    bool shown_ = true;
};

}  // namespace furrow
