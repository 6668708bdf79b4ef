#pragma once

#include <QColor>
#include <QFont>
#include <QPainter>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <QStringList>

namespace furrow {

/// Colours on paper: on white, told apart by colour-blind people and by a black and white printer.
namespace ink {
inline const QColor kText{0x17, 0x23, 0x1C};
inline const QColor kQuiet{0x5B, 0x6B, 0x61};
inline const QColor kLine{0xC4, 0xCE, 0xC7};
inline const QColor kGround{0xF4, 0xF6, 0xF2};
inline const QColor kAccent{0x1B, 0x6B, 0x43};
inline const QColor kFailure{0xA3, 0x26, 0x2A};
inline const QColor kFailureGround{0xFD, 0xEC, 0xEA};
inline const QColor kHeadland{0xE6, 0x9F, 0x00};
inline const QColor kHeadlandGround{0xFB, 0xF1, 0xD6};
inline const QColor kSwath{0x00, 0x72, 0xB2};
inline const QColor kTurn{0xD5, 0x5E, 0x00};
inline const QColor kFinding{0xB0, 0x30, 0x7A};
inline const QColor kObstacle{0x7A, 0x2F, 0x2F};
inline const QColor kStart{0x00, 0x9E, 0x73};
}  // namespace ink

/// How a text looks. Sizes in points, as everywhere on paper.
struct TextLook {
    double points = 9.0;
    QFont::Weight weight = QFont::Normal;
    QColor colour = ink::kText;
};

// What the pages of a work order share.
inline const TextLook kLabel{.points = 7.0, .weight = QFont::Normal, .colour = ink::kQuiet};
inline const TextLook kBody{.points = 8.5, .weight = QFont::Normal, .colour = ink::kText};
inline const TextLook kTitle{.points = 20.0, .weight = QFont::DemiBold, .colour = ink::kText};

double textWidthMm(const QString& text, const TextLook& look = {});
/// From one line to the next.
double lineHeightMm(const TextLook& look = {});
/// The lines of a text that is at most this wide; words that are wider are broken.
QStringList wrappedLines(const QString& text, double widthMm, const TextLook& look = {});
/// Cut at its end where it is wider.
QString elided(const QString& text, double widthMm, const TextLook& look = {});

/// Draws on a page in millimetres from its upper left corner, y downwards.
class Canvas {
public:
    /// @param dotsPerMm  of the painter's device
    Canvas(QPainter& painter, double dotsPerMm);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    /// `at` is on the base line.
    void text(QPointF at, const QString& text, const TextLook& look = {}, Qt::Alignment side = Qt::AlignLeft);
    void line(QPointF from, QPointF to, const QColor& colour, double widthMm = 0.2,
              Qt::PenStyle style = Qt::SolidLine);
    void polyline(const QPolygonF& points, const QColor& colour, double widthMm,
                  Qt::PenStyle style = Qt::SolidLine);
    void rectangle(const QRectF& box, const QColor& fill, const QColor& stroke = Qt::transparent,
                   double widthMm = 0.2, double radius = 0.0);
    /// Even-odd.
    void area(const QList<QPolygonF>& rings, const QBrush& fill, const QColor& stroke = Qt::transparent,
              double widthMm = 0.2);
    void polygon(const QPolygonF& points, const QColor& fill, const QColor& stroke = Qt::transparent,
                 double widthMm = 0.2);
    void circle(QPointF middle, double radiusMm, const QColor& fill, const QColor& stroke, double widthMm);
    void clip(const QRectF& box);
    void unclip();

private:
    QPainter& painter_;
};

}  // namespace furrow
