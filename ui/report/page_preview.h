#pragma once

#include "ui/report/printing.h"

#include <QtQml/qqmlregistration.h>
#include <QQuickPaintedItem>

namespace furrow {

/// One page as it will be printed.
class PagePreview : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(
        furrow::Printing* printing READ printing WRITE setPrinting NOTIFY printingChanged REQUIRED FINAL)
    /// From 0.
    Q_PROPERTY(int page READ page WRITE setPage NOTIFY pageChanged REQUIRED FINAL)

public:
    explicit PagePreview(QQuickItem* parent = nullptr);

    Printing* printing() const { return printing_; }
    void setPrinting(Printing* printing);
    int page() const { return page_; }
    void setPage(int page);

    void paint(QPainter* painter) override;

signals:
    void printingChanged();
    void pageChanged();

private:
    Printing* printing_ = nullptr;
    int page_ = 0;
};

}  // namespace furrow
