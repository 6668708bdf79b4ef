#include "ui/report/page_preview.h"

#include <QPainter>

namespace furrow {

PagePreview::PagePreview(QQuickItem* parent) : QQuickPaintedItem{parent} {
    setFillColor(Qt::white);
    setAntialiasing(true);
    connect(this, &QQuickItem::widthChanged, this, [this] { update(); });
}

void PagePreview::setPrinting(Printing* printing) {
    if (printing == printing_) {
        return;
    }
    if (printing_ != nullptr) {
        disconnect(printing_, nullptr, this, nullptr);
    }
    printing_ = printing;
    if (printing_ != nullptr) {
        connect(printing_, &Printing::pagesChanged, this, [this] { update(); });
    }
    emit printingChanged();
    update();
}

void PagePreview::setPage(int page) {
    if (page == page_) {
        return;
    }
    page_ = page;
    emit pageChanged();
    update();
}

void PagePreview::paint(QPainter* painter) {
    const auto pages = printing_ != nullptr ? printing_->pages() : nullptr;
    if (pages != nullptr && page_ >= 0 && page_ < pages->count()) {
        pages->paint(*painter, page_, width() / pages->sizeMm().width());
    }
}

}  // namespace furrow
