#include "ui/pages/page_files.h"

#include <QBuffer>
#include <QImage>
#include <QPageSize>
#include <QPagedPaintDevice>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>

#include <cmath>

namespace furrow {

namespace {

constexpr double kMmPerInch = 25.4;

QPageSize pageSizeOf(const WorkOrderPages& pages) {
    return QPageSize{pages.sizeMm(), QPageSize::Millimeter, {}, QPageSize::FuzzyMatch};
}

}  // namespace

bool paintOn(QPagedPaintDevice& device, const WorkOrderPages& pages, double dotsPerMm,
             const std::function<bool(int)>& onPage) {
    QPainter painter;
    if (!painter.begin(&device)) {
        return false;
    }
    for (int page = 0; page < pages.count(); ++page) {
        if ((onPage && !onPage(page)) || (page > 0 && !device.newPage())) {
            return false;
        }
        pages.paint(painter, page, dotsPerMm);
    }
    return painter.end();
}

QByteArray pdfOf(const WorkOrderPages& pages, const QString& title, const std::function<bool(int)>& onPage) {
    constexpr int kDotsPerInch = 1200;
    QByteArray bytes;
    QBuffer buffer{&bytes};
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer{&buffer};
        writer.setPageSize(pageSizeOf(pages));
        writer.setPageMargins({});
        writer.setResolution(kDotsPerInch);
        writer.setTitle(title);
        writer.setCreator(QStringLiteral("Furrow " FURROW_VERSION));
        if (!paintOn(writer, pages, kDotsPerInch / kMmPerInch, onPage)) {
            return {};
        }
    }
    return bytes;
}

QByteArray pngOf(const WorkOrderPages& pages, int dotsPerInch) {
    const double dotsPerMm = dotsPerInch / kMmPerInch;
    QImage image{(pages.sizeMm() * dotsPerMm).toSize(), QImage::Format_RGB32};
    image.setDotsPerMeterX(static_cast<int>(std::lround(1000.0 * dotsPerMm)));
    image.setDotsPerMeterY(image.dotsPerMeterX());
    image.fill(Qt::white);
    QPainter painter{&image};
    pages.paint(painter, 0, dotsPerMm);
    painter.end();
    QByteArray bytes;
    QBuffer buffer{&bytes};
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

QByteArray svgOf(const WorkOrderPages& pages, const QString& title) {
    constexpr int kDotsPerInch = 254;
    constexpr double kDotsPerMm = kDotsPerInch / kMmPerInch;
    QByteArray bytes;
    QBuffer buffer{&bytes};
    buffer.open(QIODevice::WriteOnly);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setTitle(title);
    generator.setResolution(kDotsPerInch);
    generator.setSize((pages.sizeMm() * kDotsPerMm).toSize());
    generator.setViewBox(QRectF{QPointF{}, pages.sizeMm() * kDotsPerMm});
    QPainter painter{&generator};
    painter.fillRect(QRectF{QPointF{}, pages.sizeMm() * kDotsPerMm}, Qt::white);
    pages.paint(painter, 0, kDotsPerMm);
    painter.end();
    return bytes;
}

}  // namespace furrow
