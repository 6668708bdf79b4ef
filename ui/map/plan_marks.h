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

/// How a finding is marked: full what blocks, an outline what wants a look, a disc what is just so.
enum class FindingShape { Full, Outline, Disc };

/// What a number and a finding look like.
struct MarkStyle {
    QColor pill;
    QColor pillText;
    QColor pillLine;
    QColor finding;
    QColor findingText;
    QColor start;
    QColor end;
    QColor refill;

    friend bool operator==(const MarkStyle&, const MarkStyle&) = default;
};

/// A number in a pill, as drawn on a swath.
QImage pillImage(const QString& text, const MarkStyle& style, double devicePixelRatio);
/// The same in dark: a place in an order.
QImage orderImage(const QString& text, const MarkStyle& style, double devicePixelRatio);
/// A number as drawn at a finding, with "+4" for others that have no room beside it.
QImage findingImage(const QString& text, const QString& more, FindingShape shape, const MarkStyle& style,
                    bool selected, double devicePixelRatio);

/// Where the path begins and ends.
QImage startImage(const MarkStyle& style, double devicePixelRatio);
/// A drop: where the tank is filled or the bunker emptied.
QImage refillImage(const MarkStyle& style, double devicePixelRatio);
QImage squareImage(const QColor& face, const QColor& edge, double devicePixelRatio);

/// Small pictures at places of the item, each painted once. Lives in the render thread.
class MarkNode : public QSGNode {
public:
    /// Starts a frame with nothing shown; pictures of another style are forgotten.
    void begin(QQuickWindow* window, const MarkStyle& style, double devicePixelRatio);
    void addPill(int number, QPointF middle);
    void addOrder(int order, QPointF middle);
    void addStart(QPointF middle);
    void addEnd(QPointF middle);
    void addRefill(QPointF middle);
    /// A finding, and how many others stand behind its mark.
    void addFinding(int number, int more, FindingShape shape, QPointF middle, bool selected);
    /// Removes what was not used.
    void end();

private:
    /// Paints the picture of this key where it is not known yet.
    template <typename Paint>
    void add(const QString& key, QPointF middle, Paint paint);

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
