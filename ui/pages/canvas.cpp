#include "ui/pages/canvas.h"

#include <QFontMetricsF>
#include <QPainterPath>
#include <QPen>

#include <cmath>

namespace furrow {

namespace {

// Fonts have whole sizes: a page is drawn in hundredths of a millimetre, whatever the device.
constexpr double kUnitsPerMm = 100.0;
constexpr double kMmPerPoint = 25.4 / 72.0;

QFont fontOf(const TextLook& look) {
    QFont font{QStringLiteral("Inter")};
    font.setPixelSize(static_cast<int>(std::lround(look.points * kMmPerPoint * kUnitsPerMm)));
    font.setWeight(look.weight);
    font.setHintingPreference(QFont::PreferNoHinting);
    // Other shapes of : and - between figures are not read back as what they are.
    font.setFeature("calt", 0);
    return font;
}

QPointF units(QPointF mm) {
    return kUnitsPerMm * mm;
}

QPolygonF units(const QPolygonF& mm) {
    QPolygonF all;
    all.reserve(mm.size());
    for (const QPointF& point : mm) {
        all << units(point);
    }
    return all;
}

QRectF units(const QRectF& mm) {
    return {units(mm.topLeft()), mm.size() * kUnitsPerMm};
}

QPen penOf(const QColor& colour, double widthMm, Qt::PenStyle style = Qt::SolidLine) {
    if (colour.alpha() == 0 || widthMm <= 0.0) {
        return Qt::NoPen;
    }
    QPen pen{colour, widthMm * kUnitsPerMm, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin};
    if (style != Qt::SolidLine) {
        pen.setDashPattern({1.4 / widthMm, 0.9 / widthMm});
    }
    return pen;
}

}  // namespace

double textWidthMm(const QString& text, const TextLook& look) {
    return QFontMetricsF{fontOf(look)}.horizontalAdvance(text) / kUnitsPerMm;
}

double lineHeightMm(const TextLook& look) {
    constexpr double kLeading = 1.3;
    return kLeading * look.points * kMmPerPoint;
}

QStringList wrappedLines(const QString& text, double widthMm, const TextLook& look) {
    const QFontMetricsF metrics{fontOf(look)};
    const double width = widthMm * kUnitsPerMm;
    QStringList lines;
    for (const QString& paragraph : text.split(QLatin1Char('\n'))) {
        QString line;
        for (QString word : paragraph.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
            const QString longer = line.isEmpty() ? word : line + QLatin1Char(' ') + word;
            if (metrics.horizontalAdvance(longer) <= width) {
                line = longer;
                continue;
            }
            if (!line.isEmpty()) {
                lines << line;
            }
            while (word.size() > 1 && metrics.horizontalAdvance(word) > width) {
                qsizetype fits = word.size() - 1;
                while (fits > 1 && metrics.horizontalAdvance(word.left(fits)) > width) {
                    --fits;
                }
                lines << word.left(fits);
                word = word.mid(fits);
            }
            line = word;
        }
        if (!line.isEmpty()) {
            lines << line;
        }
    }
    return lines;
}

QString elided(const QString& text, double widthMm, const TextLook& look) {
    return QFontMetricsF{fontOf(look)}.elidedText(text, Qt::ElideRight, widthMm * kUnitsPerMm);
}

Canvas::Canvas(QPainter& painter, double dotsPerMm) : painter_{painter} {
    painter_.save();
    painter_.scale(dotsPerMm / kUnitsPerMm, dotsPerMm / kUnitsPerMm);
    painter_.setRenderHint(QPainter::Antialiasing);
    painter_.setRenderHint(QPainter::TextAntialiasing);
}

Canvas::~Canvas() {
    painter_.restore();
}

void Canvas::text(QPointF at, const QString& text, const TextLook& look, Qt::Alignment side) {
    if (text.isEmpty()) {
        return;
    }
    const double share = side == Qt::AlignRight ? 1.0 : side == Qt::AlignHCenter ? 0.5 : 0.0;
    painter_.setFont(fontOf(look));
    painter_.setPen(look.colour);
    painter_.drawText(units(at - QPointF{share * textWidthMm(text, look), 0.0}), text);
}

void Canvas::line(QPointF from, QPointF to, const QColor& colour, double widthMm, Qt::PenStyle style) {
    painter_.setPen(penOf(colour, widthMm, style));
    painter_.drawLine(units(from), units(to));
}

void Canvas::polyline(const QPolygonF& points, const QColor& colour, double widthMm, Qt::PenStyle style) {
    painter_.setPen(penOf(colour, widthMm, style));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawPolyline(units(points));
}

void Canvas::rectangle(const QRectF& box, const QColor& fill, const QColor& stroke, double widthMm,
                       double radius) {
    painter_.setPen(penOf(stroke, widthMm));
    painter_.setBrush(fill.alpha() == 0 ? QBrush{Qt::NoBrush} : QBrush{fill});
    if (radius > 0.0) {
        painter_.drawRoundedRect(units(box), radius * kUnitsPerMm, radius * kUnitsPerMm);
    } else {
        painter_.drawRect(units(box));
    }
}

void Canvas::area(const QList<QPolygonF>& rings, const QBrush& fill, const QColor& stroke, double widthMm) {
    QPainterPath path;
    path.setFillRule(Qt::OddEvenFill);
    for (const QPolygonF& ring : rings) {
        path.addPolygon(units(ring));
        path.closeSubpath();
    }
    painter_.setPen(penOf(stroke, widthMm));
    painter_.setBrush(fill);
    painter_.drawPath(path);
}

void Canvas::polygon(const QPolygonF& points, const QColor& fill, const QColor& stroke, double widthMm) {
    painter_.setPen(penOf(stroke, widthMm));
    painter_.setBrush(fill);
    painter_.drawPolygon(units(points));
}

void Canvas::circle(QPointF middle, double radiusMm, const QColor& fill, const QColor& stroke,
                    double widthMm) {
    painter_.setPen(penOf(stroke, widthMm));
    painter_.setBrush(fill);
    painter_.drawEllipse(units(middle), radiusMm * kUnitsPerMm, radiusMm * kUnitsPerMm);
}

void Canvas::clip(const QRectF& box) {
    painter_.save();
    painter_.setClipRect(units(box), Qt::IntersectClip);
}

void Canvas::unclip() {
    painter_.restore();
}

}  // namespace furrow
