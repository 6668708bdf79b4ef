#include "ui/map/plan_marks.h"

#include <QFont>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <cmath>

namespace furrow {

namespace {

QFont markFont(int pixels) {
    QFont font{QStringLiteral("Inter")};
    font.setPixelSize(pixels);
    font.setWeight(QFont::DemiBold);
    font.setFeature("tnum", 1);
    return font;
}

QImage emptyImage(QSizeF size, double devicePixelRatio) {
    QImage image{(size * devicePixelRatio).toSize(), QImage::Format_ARGB32_Premultiplied};
    image.setDevicePixelRatio(devicePixelRatio);
    image.fill(Qt::transparent);
    return image;
}

}  // namespace

QImage pillImage(const QString& text, const MarkStyle& style, double devicePixelRatio) {
    const QFont font = markFont(10);
    const double width = std::ceil(std::max(QFontMetricsF{font}.horizontalAdvance(text) + 10.0, 18.0));
    QImage image = emptyImage({width + 2.0, 18.0}, devicePixelRatio);
    QPainter painter{&image};
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box{1.0, 1.5, width, 15.0};
    painter.setPen(QPen{style.pillLine, 1.1});
    painter.setBrush(style.pill);
    painter.drawRoundedRect(box, 7.5, 7.5);
    painter.setFont(font);
    painter.setPen(style.pillText);
    painter.drawText(box, Qt::AlignCenter, text);
    return image;
}

QImage diamondImage(const QString& text, const MarkStyle& style, bool selected, double devicePixelRatio) {
    const double half = selected ? 15.0 : 11.5;
    QImage image = emptyImage({2.0 * half + 2.0, 2.0 * half + 2.0}, devicePixelRatio);
    QPainter painter{&image};
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(half + 1.0, half + 1.0);
    QPainterPath diamond;
    diamond.moveTo(0.0, -half);
    diamond.lineTo(half, 0.0);
    diamond.lineTo(0.0, half);
    diamond.lineTo(-half, 0.0);
    diamond.closeSubpath();
    painter.setPen(
        QPen{style.findingText, selected ? 2.2 : 1.4, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin});
    painter.setBrush(style.finding);
    painter.drawPath(diamond);
    painter.setFont(markFont(text.size() > 2 ? 8 : selected ? 12 : 10));
    painter.setPen(style.findingText);
    painter.drawText(QRectF{-half, -half, 2.0 * half, 2.0 * half}, Qt::AlignCenter, text);
    return image;
}

QImage squareImage(const QColor& face, const QColor& edge, double devicePixelRatio) {
    QImage image = emptyImage({16.0, 16.0}, devicePixelRatio);
    QPainter painter{&image};
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen{edge, 2.0, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin});
    painter.setBrush(face);
    painter.drawRoundedRect(QRectF{2.0, 2.0, 12.0, 12.0}, 1.5, 1.5);
    return image;
}

void MarkNode::begin(QQuickWindow* window, const MarkStyle& style, double devicePixelRatio) {
    if (style != style_ || devicePixelRatio != devicePixelRatio_) {
        // Nodes hold textures, so they go first.
        for (QSGSimpleTextureNode* node : nodes_) {
            removeChildNode(node);
            delete node;
        }
        nodes_.clear();
        pictures_.clear();
    }
    window_ = window;
    style_ = style;
    devicePixelRatio_ = devicePixelRatio;
    used_ = 0;
}

void MarkNode::addPill(int number, QPointF middle) {
    const QString key = QStringLiteral("p%1").arg(number);
    add(key,
        pictures_.contains(key) ? QImage{} : pillImage(QString::number(number), style_, devicePixelRatio_),
        middle);
}

void MarkNode::addSquare(QPointF middle) {
    const QString key = QStringLiteral("end");
    add(key, pictures_.contains(key) ? QImage{} : squareImage(style_.end, style_.pill, devicePixelRatio_),
        middle);
}

void MarkNode::addDiamond(int number, QPointF middle, bool selected) {
    const QString key =
        QStringLiteral("%1%2").arg(selected ? QLatin1Char('s') : QLatin1Char('d')).arg(number);
    add(key,
        pictures_.contains(key) ? QImage{}
                                : diamondImage(QString::number(number), style_, selected, devicePixelRatio_),
        middle);
}

void MarkNode::add(const QString& key, const QImage& image, QPointF middle) {
    if (!image.isNull()) {
        pictures_.insert(key,
                         {std::shared_ptr<QSGTexture>{window_->createTextureFromImage(
                              image, QQuickWindow::CreateTextureOptions{QQuickWindow::TextureHasAlphaChannel,
                                                                        QQuickWindow::TextureCanUseAtlas})},
                          QSizeF{image.size()} / devicePixelRatio_});
    }
    const Picture& picture = pictures_[key];
    if (used_ == nodes_.size()) {
        auto* node = new QSGSimpleTextureNode;
        node->setFiltering(QSGTexture::Linear);
        nodes_.push_back(node);
        // A node without a texture must not be in the tree.
        node->setTexture(picture.texture.get());
        appendChildNode(node);
    }
    QSGSimpleTextureNode* node = nodes_[used_++];
    if (node->texture() != picture.texture.get()) {
        node->setTexture(picture.texture.get());
    }
    // On whole device pixels, so that the figures stay sharp.
    const QPointF corner = middle - QPointF{picture.size.width(), picture.size.height()} / 2.0;
    const QRectF box{
        QPointF{std::round(corner.x() * devicePixelRatio_), std::round(corner.y() * devicePixelRatio_)} /
            devicePixelRatio_,
        picture.size};
    if (node->rect() != box) {
        node->setRect(box);
    }
}

void MarkNode::end() {
    while (nodes_.size() > used_) {
        removeChildNode(nodes_.back());
        delete nodes_.back();
        nodes_.pop_back();
    }
}

}  // namespace furrow
