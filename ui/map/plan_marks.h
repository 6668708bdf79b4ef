#pragma once

#include <QColor>
#include <QHash>
#include <QImage>
#include <QQuickWindow>
#include <QSGSimpleTextureNode>
#include <QSGTexture>

#include <memory>
#include <vector>

namespace furrow {

/// What an order number and a finding look like.
struct MarkStyle {
    QColor pill;
    QColor pillText;
    QColor pillLine;
    QColor finding;
    QColor findingText;
    QColor end;

    friend bool operator==(const MarkStyle&, const MarkStyle&) = default;
};

/// A number in a pill, as drawn on a swath.
QImage pillImage(const QString& text, const MarkStyle& style, double devicePixelRatio);
/// A number in a diamond, as drawn at a finding.
QImage diamondImage(const QString& text, const MarkStyle& style, bool selected, double devicePixelRatio);

/// Where the path ends.
QImage squareImage(const QColor& face, const QColor& edge, double devicePixelRatio);

/// Small pictures at places of the item, each painted once. Lives in the render thread.
class MarkNode : public QSGNode {
public:
    /// Starts a frame with nothing shown; pictures of another style are forgotten.
    void begin(QQuickWindow* window, const MarkStyle& style, double devicePixelRatio);
    void addPill(int number, QPointF middle);
    void addSquare(QPointF middle);
    void addDiamond(int number, QPointF middle, bool selected);
    /// Removes what was not used.
    void end();

private:
    void add(const QString& key, const QImage& image, QPointF middle);

    QQuickWindow* window_ = nullptr;
    MarkStyle style_;
    double devicePixelRatio_ = 1.0;
    struct Picture {
        std::shared_ptr<QSGTexture> texture;
        QSizeF size;
    };
    QHash<QString, Picture> pictures_;
    std::vector<QSGSimpleTextureNode*> nodes_;
    std::size_t used_ = 0;
};

}  // namespace furrow
