#pragma once

#include <QRectF>
#include <QString>

namespace furrow {

class Canvas;

/// Draws a text as QR code (ISO/IEC 18004, through libqrencode). Nothing for a text that is too long for one.
void drawQrCode(Canvas& canvas, const QRectF& box, const QString& text);

}  // namespace furrow
