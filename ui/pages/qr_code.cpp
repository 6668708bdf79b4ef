#include "ui/pages/qr_code.h"

#include "ui/pages/canvas.h"

#include <qrencode.h>

#include <memory>

namespace furrow {

void drawQrCode(Canvas& canvas, const QRectF& box, const QString& text) {
    const QByteArray bytes = text.toUtf8();
    const std::unique_ptr<QRcode, void (*)(QRcode*)> code{
        QRcode_encodeString(bytes.constData(), 0, QR_ECLEVEL_M, QR_MODE_8, 1), QRcode_free};
    if (code == nullptr) {
        return;
    }
    const double module = box.width() / code->width;
    // Runs of dark modules as one: seams between them would be seen.
    QList<QPolygonF> runs;
    for (int row = 0; row < code->width; ++row) {
        for (int begin = 0; begin < code->width;) {
            int end = begin;
            while (end < code->width && (code->data[row * code->width + end] & 1U) != 0) {
                ++end;
            }
            if (end > begin) {
                runs << QPolygonF{QRectF{box.left() + begin * module, box.top() + row * module,
                                         (end - begin) * module, module}};
            }
            begin = end + 1;
        }
    }
    canvas.area(runs, Qt::black);
}

}  // namespace furrow
