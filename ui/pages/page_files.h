#pragma once

#include "ui/pages/work_order_pages.h"

#include <QByteArray>
#include <QString>

#include <functional>

class QPagedPaintDevice;

namespace furrow {

/// All pages as a PDF, texts as text, fonts embedded. Calls `onPage` before each; stops where it says false
/// and gives nothing.
QByteArray pdfOf(const WorkOrderPages& pages, const QString& title,
                 const std::function<bool(int)>& onPage = {});
/// The first page, which has the map, as a picture.
QByteArray pngOf(const WorkOrderPages& pages, int dotsPerInch = 200);
QByteArray svgOf(const WorkOrderPages& pages, const QString& title);

/// Draws all pages on a printer or the like, which has the paper already.
bool paintOn(QPagedPaintDevice& device, const WorkOrderPages& pages, double dotsPerMm,
             const std::function<bool(int)>& onPage = {});

}  // namespace furrow
