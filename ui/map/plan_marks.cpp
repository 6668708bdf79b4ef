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

QImage capsuleImage(const QString& text, const QColor& face, const QColor& line, const QColor& ink,
                    double devicePixelRatio) {
    const QFont font = markFont(10);
    const double width = std::ceil(std::max(QFontMetricsF{font}.horizontalAdvance(text) + 10.0, 18.0));
    QImage image = emptyImage({width + 2.0, 18.0}, devicePixelRatio);
    QPainter painter{&image};
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box{1.0, 1.5, width, 15.0};
    painter.setPen(QPen{line, 1.1});
    painter.setBrush(face);
    painter.drawRoundedRect(box, 7.5, 7.5);
    painter.setFont(font);
    painter.setPen(ink);
    painter.drawText(box, Qt::AlignCenter, text);
    return image;
}

QPainterPath diamondPath(double half) {
    QPainterPath diamond;
    diamond.moveTo(0.0, -half);
    diamond.lineTo(half, 0.0);
    diamond.lineTo(0.0, half);
    diamond.lineTo(-half, 0.0);
    diamond.closeSubpath();
    return diamond;
}

/// In the upper right corner of a mark of this half width.
void paintMore(QPainter& painter, const QString& more, double half, const MarkStyle& style) {
    const QFont font = markFont(9);
    const double width = std::max(QFontMetricsF{font}.horizontalAdvance(more) + 6.0, 14.0);
    const QRectF box{half - 7.0, -half - 1.0, width, 13.0};
    painter.setPen(QPen{style.finding, 1.1});
    painter.setBrush(style.findingText);
    painter.drawRoundedRect(box, 6.5, 6.5);
    painter.setFont(font);
    painter.setPen(style.finding);
    painter.drawText(box, Qt::AlignCenter, more);
}

}  // namespace

QImage pillImage(const QString& text, const MarkStyle& style, double devicePixelRatio) {
    return capsuleImage(text, style.pill, style.pillLine, style.pillText, devicePixelRatio);
}

QImage orderImage(const QString& text, const MarkStyle& style, double devicePixelRatio) {
    return capsuleImage(text, style.pillText, style.pill, style.pill, devicePixelRatio);
}

QImage findingImage(const QString& text, const QString& more, FindingShape shape, const MarkStyle& style,
                    bool selected, double devicePixelRatio) {
    const double half = selected ? 15.0 : 11.5;
    const double aside = more.isEmpty() ? 1.0 : 24.0;
    QImage image = emptyImage({2.0 * (half + aside), 2.0 * half + 4.0}, devicePixelRatio);
    QPainter painter{&image};
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(half + aside, half + 2.0);
    const bool full = shape == FindingShape::Full;
    painter.setBrush(full ? style.finding : style.findingText);
    const QColor edge = full ? style.findingText : style.finding;
    painter.setPen(QPen{edge, selected ? 2.4 : 1.6, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin});
    if (shape == FindingShape::Disc) {
        painter.drawEllipse(QPointF{}, half - 3.0, half - 3.0);
    } else {
        painter.drawPath(diamondPath(half));
    }
    painter.setFont(markFont(text.size() > 2 ? 8 : selected ? 12 : 10));
    painter.setPen(edge);
    painter.drawText(QRectF{-half, -half, 2.0 * half, 2.0 * half}, Qt::AlignCenter, text);
    if (!more.isEmpty()) {
        paintMore(painter, more, half, style);
    }
    return image;
}

QImage startImage(const MarkStyle& style, double devicePixelRatio) {
    QImage image = emptyImage({20.0, 20.0}, devicePixelRatio);
    QPainter painter{&image};
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen{style.pill, 2.2});
    painter.setBrush(style.start);
    painter.drawEllipse(QPointF{10.0, 10.0}, 8.0, 8.0);
    return image;
}

QImage refillImage(const MarkStyle& style, double devicePixelRatio) {
    QImage image = emptyImage({22.0, 26.0}, devicePixelRatio);
    QPainter painter{&image};
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen{style.pill, 2.2});
    painter.setBrush(style.refill);
    // Its middle is the place.
    painter.translate(11.0, 13.0);
    QPainterPath drop;
    drop.moveTo(0.0, -10.5);
    drop.cubicTo(2.0, -6.0, 7.5, -1.5, 7.5, 3.5);
    drop.arcTo(QRectF{-7.5, -4.0, 15.0, 15.0}, 0.0, -180.0);
    drop.cubicTo(-7.5, -1.5, -2.0, -6.0, 0.0, -10.5);
    painter.drawPath(drop);
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
    add(QStringLiteral("p%1").arg(number), middle,
        [&] { return pillImage(QString::number(number), style_, devicePixelRatio_); });
}

void MarkNode::addOrder(int order, QPointF middle) {
    add(QStringLiteral("o%1").arg(order), middle,
        [&] { return orderImage(QStringLiteral("%1.").arg(order), style_, devicePixelRatio_); });
}

void MarkNode::addStart(QPointF middle) {
    add(QStringLiteral("start"), middle, [&] { return startImage(style_, devicePixelRatio_); });
}

void MarkNode::addEnd(QPointF middle) {
    add(QStringLiteral("end"), middle,
        [&] { return squareImage(style_.end, style_.pill, devicePixelRatio_); });
}

void MarkNode::addRefill(QPointF middle) {
    add(QStringLiteral("refill"), middle, [&] { return refillImage(style_, devicePixelRatio_); });
}

void MarkNode::addFinding(int number, int more, FindingShape shape, QPointF middle, bool selected) {
    const QString others = more > 0 ? QStringLiteral("+%1").arg(more) : QString{};
    add(QStringLiteral("f%1 %2 %3 %4").arg(number).arg(more).arg(static_cast<int>(shape)).arg(selected),
        middle, [&] {
            return findingImage(QString::number(number), others, shape, style_, selected, devicePixelRatio_);
        });
}

template <typename Paint>
void MarkNode::add(const QString& key, QPointF middle, Paint paint) {
    if (!pictures_.contains(key)) {
        const QImage image = paint();
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
