#include "ui/controls/icon_item.h"

#include <QFile>
#include <QPainter>
#include <QSvgRenderer>

namespace furrow {

IconItem::IconItem(QQuickItem* parent) : QQuickPaintedItem{parent} {
    setImplicitSize(20, 20);
    setAntialiasing(true);
}

void IconItem::setName(const QString& name) {
    if (name == name_) {
        return;
    }
    name_ = name;
    update();
    emit nameChanged();
}

void IconItem::setColor(const QColor& color) {
    if (color == color_) {
        return;
    }
    color_ = color;
    update();
    emit colorChanged();
}

void IconItem::paint(QPainter* painter) {
    QFile file{QStringLiteral(":/furrow/icons/%1.svg").arg(name_)};
    if (!file.open(QIODevice::ReadOnly)) {
        return;
    }
    QByteArray drawing = file.readAll();
    drawing.replace("currentColor", color_.name(QColor::HexRgb).toLatin1());
    QSvgRenderer renderer{drawing};
    renderer.render(painter, boundingRect());
}

}  // namespace furrow
