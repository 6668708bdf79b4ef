#include "ui/pages/page_flow.h"

namespace furrow {

void PageFlow::newPage() {
    pages_.emplace_back();
    y_ = kMargin;
}

void PageFlow::need(double heightMm) {
    if (heightMm > rest()) {
        newPage();
    }
}

QRectF PageFlow::take(double heightMm) {
    const QRectF box{left(), y_, width(), heightMm};
    y_ += heightMm;
    return box;
}

}  // namespace furrow
