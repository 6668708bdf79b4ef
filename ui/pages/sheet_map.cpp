#include "ui/pages/sheet_map.h"

#include "planner/geometry/simplify.h"
#include "planner/path/blocking.h"
#include "ui/text/display.h"
#include "ui/text/quantity_text.h"
#include "ui/text/unit_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

namespace furrow {

namespace {

struct MapWords {
    Q_DECLARE_TR_FUNCTIONS(WorkOrderPages)
};

constexpr double kKeyHeight = 9.0;
constexpr double kRoom = 5.0;  ///< between the field and the edge of the map
/// Lines are drawn to a quarter of what can be seen.
constexpr double kFinestMm = 0.025;

const TextLook kNumberLook{.points = 6.0, .weight = QFont::DemiBold, .colour = ink::kSwath};
const TextLook kCommentLook{.points = 7.0, .weight = QFont::DemiBold, .colour = Qt::white};
const TextLook kRingLook{.points = 6.0, .weight = QFont::DemiBold, .colour = QColor{0x8A, 0x5F, 0x00}};
const TextLook kFindingLook{.points = 6.0, .weight = QFont::DemiBold, .colour = Qt::white};
const TextLook kNameLook{.points = 7.0, .weight = QFont::Medium, .colour = ink::kText};
const TextLook kKeyLook{.points = 7.0, .weight = QFont::Normal, .colour = ink::kText};

constexpr double kNumberHeight = 2.9;
constexpr double kBetweenNumbers = 0.7;  ///< more than touching: so that they can be read
constexpr double kBeside = 4.0;
constexpr double kFindingHalf = 2.1;
constexpr double kEndHalf = 1.7;

Point plain(QPointF point) {
    return {point.x(), point.y()};
}

QPointF qt(Point point) {
    return {point.x, point.y};
}

PaperBox around(QPointF middle, double half) {
    return {.corner = plain(middle - QPointF{half, half}), .width = 2.0 * half, .height = 2.0 * half};
}

void drawDiamond(Canvas& canvas, QPointF middle, const QString& text, bool blocking,
                 double half = kFindingHalf) {
    canvas.polygon({middle + QPointF{0.0, -half}, middle + QPointF{half, 0.0}, middle + QPointF{0.0, half},
                    middle + QPointF{-half, 0.0}},
                   blocking ? ink::kFailure : ink::kFinding, Qt::white, 0.25);
    TextLook look = kFindingLook;
    look.points = text.size() > 2 ? 4.4 : text.size() > 1 ? 5.4 : 6.0;
    canvas.text(middle + QPointF{0.0, 0.13 * look.points}, text, look, Qt::AlignHCenter);
}

void drawStart(Canvas& canvas, QPointF middle) {
    canvas.circle(middle, kEndHalf - 0.2, ink::kStart, Qt::white, 0.35);
}

void drawEnd(Canvas& canvas, QPointF middle) {
    const double half = kEndHalf - 0.35;
    canvas.rectangle({middle - QPointF{half, half}, QSizeF{2.0 * half, 2.0 * half}}, ink::kText, Qt::white,
                     0.35);
}

void drawGate(Canvas& canvas, QPointF middle) {
    canvas.polygon({middle + QPointF{0.0, -1.5}, middle + QPointF{1.4, 1.1}, middle + QPointF{-1.4, 1.1}},
                   ink::kText, Qt::white, 0.25);
}

void hatch(Canvas& canvas, const QList<QPolygonF>& rings, bool passable) {
    QColor ground = ink::kObstacle;
    ground.setAlpha(passable ? 24 : 70);
    canvas.area(rings, ground, ink::kObstacle, passable ? 0.2 : 0.35);
}

void addRings(const Polygon& polygon, std::vector<Ring>& rings) {
    rings.push_back(polygon.outer);
    std::ranges::copy(polygon.holes, std::back_inserter(rings));
}

}  // namespace

QString commentLetter(std::size_t index) {
    QString letters;
    for (++index; index > 0; index = (index - 1) / 26) {
        letters.prepend(static_cast<char16_t>(u'A' + (index - 1) % 26));
    }
    return letters;
}

SheetMap::SheetMap(const OrderSheet& sheet, std::span<const ReviewComment> comments, const QRectF& box)
    : map_{box.adjusted(0.0, 0.0, 0.0, -kKeyHeight)},
      key_{box.left(), box.bottom() - kKeyHeight, box.width(), kKeyHeight} {
    const Bounds extent = bounds(sheet.field);
    scale_ = roundMapScale(extent, map_.width() - 2.0 * kRoom, map_.height() - 2.0 * kRoom);
    centre_ = 0.5 * (extent.min + extent.max);
    layShapes(sheet);
    layMarks(sheet, comments);
}

QPointF SheetMap::onPage(Point place) const {
    const Point way = (1000.0 / scale_) * (place - centre_);
    return map_.center() + QPointF{way.x, -way.y};
}

QPolygonF SheetMap::onPage(const Polyline& line) const {
    QPolygonF points;
    for (const Point& point : simplified(line, metres(kFinestMm * scale_ / 1000.0))) {
        points << onPage(point);
    }
    return points;
}

QList<QPolygonF> SheetMap::onPage(const MultiPolygon& polygons) const {
    std::vector<Ring> rings;
    for (const Polygon& polygon : polygons) {
        addRings(polygon, rings);
    }
    QList<QPolygonF> all;
    for (const Ring& ring : rings) {
        QPolygonF points;
        for (const Point& point : ring) {
            points << onPage(point);
        }
        all << points;
    }
    return all;
}

void SheetMap::layShapes(const OrderSheet& sheet) {
    field_ = onPage(sheet.field);
    mainland_ = onPage(sheet.mainland);
    for (const SheetObstacle& obstacle : sheet.obstacles) {
        (obstacle.passable ? passable_ : solid_).push_back(onPage(obstacle.outline));
    }
    for (const SheetWay& way : sheet.ways) {
        ways_.push_back({.line = onPage(way.line), .reverse = way.reverse, .drivable = way.drivable});
    }
    for (const SheetPass& pass : sheet.passes) {
        const QPolygonF line = onPage(pass.line);
        if (pass.kind == SegmentKind::HeadlandPass) {
            rings_.push_back(line);
            continue;
        }
        swaths_.push_back(line);
        Polyline places;
        for (const QPointF& point : line) {
            places.push_back(plain(point));
        }
        swathLines_.push_back(std::move(places));
        swathNumbers_.push_back(pass.number);
    }
    start_ = onPage(sheet.start);
    end_ = onPage(sheet.end);
}

void SheetMap::layMarks(const OrderSheet& sheet, std::span<const ReviewComment> comments) {
    LabelPlaces places{{.corner = plain(map_.topLeft()), .width = map_.width(), .height = map_.height()}};
    places.block(around(start_, kEndHalf));
    places.block(around(end_, kEndHalf));
    layGates(sheet, places);
    layFindings(sheet, places);
    layComments(sheet, comments, places);
    layNumbers(sheet, places);
    layArrows(places);
}

void SheetMap::layGates(const OrderSheet& sheet, LabelPlaces& places) {
    for (const SheetGate& gate : sheet.gates) {
        gates_.push_back(onPage(gate.place));
        places.block(around(gates_.back(), 1.5));
    }
    const auto name = [&](QPointF at, const std::string& text, double off) {
        if (text.empty()) {
            return;
        }
        const QString shownName = elided(fromStd(text), 40.0, kNameLook);
        const double width = textWidthMm(shownName, kNameLook) + 1.0;
        const double aside = off + 0.5 * width;
        LabelWish wish{.places = {}, .width = width, .height = 3.2};
        if (off == 0.0) {
            wish.places.push_back(plain(at));
        }
        for (const QPointF& way : {QPointF{aside, 0.0}, QPointF{-aside, 0.0}, QPointF{0.0, off + 2.0},
                                   QPointF{0.0, -off - 2.0}, QPointF{aside, 3.0}, QPointF{-aside, -3.0}}) {
            wish.places.push_back(plain(at + way));
        }
        if (const auto place = places.place(wish)) {
            names_.push_back({.middle = qt(*place), .text = shownName, .width = width});
        }
    };
    for (std::size_t i = 0; i < sheet.gates.size(); ++i) {
        name(gates_[i], sheet.gates[i].name, 2.0);
    }
    for (const SheetObstacle& obstacle : sheet.obstacles) {
        const Bounds box = bounds(obstacle.outline);
        name(onPage(0.5 * (box.min + box.max)), obstacle.name, 0.0);
    }
}

void SheetMap::layFindings(const OrderSheet& sheet, LabelPlaces& places) {
    const double size = 2.0 * kFindingHalf;
    for (std::size_t i = 0; i < sheet.findings.size(); ++i) {
        const Point at = plain(onPage(sheet.findings[i].place));
        LabelWish wish{.places = {at}, .width = size, .height = size};
        for (const double far : {0.7, 1.4}) {
            for (int eighth = 0; eighth < 8; ++eighth) {
                wish.places.push_back(at + far * size * direction(eighth * std::numbers::pi / 4.0));
            }
        }
        if (const auto place = places.place(wish)) {
            findings_.push_back({.middle = qt(*place),
                                 .text = QString::number(i + 1),
                                 .width = size,
                                 .blocking = isBlocking(sheet.findings[i])});
        }
    }
}

void SheetMap::layComments(const OrderSheet& sheet, std::span<const ReviewComment> comments,
                           LabelPlaces& places) {
    for (std::size_t i = 0; i < comments.size(); ++i) {
        if (!comments[i].place || !sheet.frame) {
            continue;
        }
        const QString letter = commentLetter(i);
        const Point at = plain(onPage(sheet.frame->toLocal(*comments[i].place)));
        LabelWish wish{.places = {at}, .width = textWidthMm(letter, kCommentLook) + 2.2, .height = 3.6};
        for (int eighth = 0; eighth < 8; ++eighth) {
            wish.places.push_back(at + 4.0 * direction(eighth * std::numbers::pi / 4.0));
        }
        if (const auto place = places.place(wish)) {
            comments_.push_back({.middle = qt(*place), .text = letter, .width = wish.width});
        }
    }
}

void SheetMap::layNumbers(const OrderSheet& sheet, LabelPlaces& places) {
    // By the numbers of the swaths, as on the screen and in findings: their order stands in its table.
    std::vector<std::size_t> byNumber(swathLines_.size());
    std::ranges::iota(byNumber, std::size_t{0});
    std::ranges::stable_sort(byNumber, {}, [this](std::size_t i) { return swathNumbers_[i]; });
    std::vector<LabelWish> wishes;
    for (const std::size_t i : byNumber) {
        const QString text = QString::number(swathNumbers_[i]);
        LabelWish wish{.places = {},
                       .width = textWidthMm(text, kNumberLook) + 1.6 + kBetweenNumbers,
                       .height = kNumberHeight + kBetweenNumbers};
        for (const double share : {0.5, 0.45, 0.55}) {
            wish.places.push_back(pointAt(swathLines_[i], share).place);
        }
        if (i == byNumber.front() || i == byNumber.back()) {
            // The first and the last swath have their number even if that stands beside.
            for (int eighth = 0; eighth < 8; ++eighth) {
                wish.places.push_back(wish.places.front() +
                                      kBeside * direction(eighth * std::numbers::pi / 4.0));
            }
        }
        wishes.push_back(std::move(wish));
    }
    const auto placed = placeNumbers(wishes, places);
    for (std::size_t i = 0; i < placed.size(); ++i) {
        if (placed[i]) {
            numbers_.push_back({.middle = qt(*placed[i]),
                                .text = QString::number(swathNumbers_[byNumber[i]]),
                                .width = wishes[i].width - kBetweenNumbers});
        }
    }
    // Of a ring that is driven in several pieces the first one has the name.
    std::vector<int> named;
    for (const SheetPass& pass : sheet.passes) {
        if (pass.kind != SegmentKind::HeadlandPass || std::ranges::contains(named, pass.number)) {
            continue;
        }
        const QString text = MapWords::tr("H%1", "headland pass").arg(pass.number);
        LabelWish wish{.places = {}, .width = textWidthMm(text, kRingLook) + 1.2, .height = kNumberHeight};
        for (int twelfth = 1; twelfth < 12; ++twelfth) {
            wish.places.push_back(plain(onPage(pointAt(pass.line, twelfth / 12.0).place)));
        }
        if (const auto place = places.place(wish)) {
            named.push_back(pass.number);
            ringNumbers_.push_back({.middle = qt(*place), .text = text, .width = wish.width});
        }
    }
}

void SheetMap::layArrows(LabelPlaces& places) {
    constexpr double kShortestMm = 6.0;
    constexpr double kLong = 1.5;
    constexpr double kWide = 0.55;
    for (std::size_t i = 0; i < swathLines_.size(); ++i) {
        if (lengthM(swathLines_[i]) < kShortestMm) {
            continue;
        }
        // Near its beginning: those of both directions stand in two groups, and all of neither is left out.
        const double share = 0.25;
        LabelWish wish{.places = {}, .width = 1.6, .height = 1.6};
        std::vector<PointOnLine> spots;
        for (const double off : {0.0, 0.06, -0.06}) {
            spots.push_back(pointAt(swathLines_[i], share + off));
            wish.places.push_back(spots.back().place);
        }
        const auto place = places.place(wish);
        if (!place) {
            continue;
        }
        const auto spot = std::ranges::find(spots, *place, &PointOnLine::place);
        const QPointF way = qt(spot->way);
        const QPointF across{-way.y(), way.x()};
        const QPointF tip = qt(*place) + 0.5 * kLong * way;
        arrows_.push_back({.tip = {tip, tip - kLong * way + kWide * across, tip - 0.7 * kLong * way,
                                   tip - kLong * way - kWide * across}});
    }
}

void SheetMap::draw(Canvas& canvas) const {
    canvas.rectangle(map_.united(key_), Qt::white, ink::kLine, 0.25);
    canvas.clip(map_);
    canvas.area(field_, ink::kHeadlandGround);
    canvas.area(mainland_, QBrush{Qt::white});
    for (const auto& rings : passable_) {
        hatch(canvas, rings, true);
    }
    for (const auto& rings : solid_) {
        hatch(canvas, rings, false);
    }
    for (const QPolygonF& ring : rings_) {
        canvas.polyline(ring, ink::kHeadland, 0.22, Qt::DashLine);
    }
    for (const QPolygonF& swath : swaths_) {
        canvas.polyline(swath, ink::kSwath, swaths_.size() > 120 ? 0.15 : 0.25);
    }
    for (const Way& way : ways_) {
        canvas.polyline(way.line, way.drivable ? ink::kTurn : ink::kFailure, way.drivable ? 0.2 : 0.6,
                        way.reverse ? Qt::DashLine : Qt::SolidLine);
    }
    canvas.area(field_, Qt::NoBrush, ink::kText, 0.45);
    for (const Arrow& arrow : arrows_) {
        canvas.polygon(arrow.tip, ink::kSwath);
    }
    const auto pills = [&canvas](const std::vector<Mark>& marks, const TextLook& look) {
        for (const Mark& mark : marks) {
            const QRectF box{mark.middle.x() - 0.5 * mark.width, mark.middle.y() - 0.5 * kNumberHeight,
                             mark.width, kNumberHeight};
            canvas.rectangle(box.adjusted(0.15, 0.15, -0.15, -0.15), Qt::white, look.colour, 0.15, 1.2);
            canvas.text(mark.middle + QPointF{0.0, 0.78}, mark.text, look, Qt::AlignHCenter);
        }
    };
    pills(ringNumbers_, kRingLook);
    pills(numbers_, kNumberLook);
    for (const Mark& mark : names_) {
        const QRectF box{mark.middle.x() - 0.5 * mark.width, mark.middle.y() - 1.6, mark.width, 3.2};
        canvas.rectangle(box, QColor{255, 255, 255, 215});
        canvas.text(mark.middle + QPointF{0.0, 0.9}, mark.text, kNameLook, Qt::AlignHCenter);
    }
    for (const QPointF& gate : gates_) {
        drawGate(canvas, gate);
    }
    drawEnd(canvas, end_);
    drawStart(canvas, start_);
    for (const Mark& mark : findings_) {
        drawDiamond(canvas, mark.middle, mark.text, mark.blocking);
    }
    for (const Mark& mark : comments_) {
        canvas.rectangle({mark.middle.x() - 0.5 * mark.width, mark.middle.y() - 1.8, mark.width, 3.6},
                         ink::kText, Qt::white, 0.2, 1.0);
        canvas.text(mark.middle + QPointF{0.0, 0.95}, mark.text, kCommentLook, Qt::AlignHCenter);
    }
    canvas.unclip();
    drawKey(canvas);
}

void SheetMap::drawKey(Canvas& canvas) const {
    canvas.line(key_.topLeft(), key_.topRight(), ink::kLine, 0.25);
    const double middle = key_.center().y();
    const double base = middle + 0.9;
    double x = key_.left() + 4.5;
    // North is up.
    canvas.polygon({{x, middle - 3.2}, {x + 1.5, middle + 2.2}, {x, middle + 1.1}, {x - 1.5, middle + 2.2}},
                   ink::kText);
    x += 2.6;
    canvas.text({x, base}, MapWords::tr("N", "north"), {.points = 8.0, .weight = QFont::DemiBold});
    x += 6.0;

    const QuantityText& quantities = *Display::instance().quantities();
    const double lengthM = quantities.roundLengthBelow(0.028 * scale_);
    const double bar = 1000.0 * lengthM / scale_;
    canvas.rectangle({x, middle + 1.0, 0.5 * bar, 0.9}, ink::kText, ink::kText, 0.15);
    canvas.rectangle({x + 0.5 * bar, middle + 1.0, 0.5 * bar, 0.9}, Qt::white, ink::kText, 0.15);
    canvas.text({x, middle - 0.2}, QStringLiteral("0"), kKeyLook);
    const QString length = quantities.scaleText(lengthM);
    canvas.text({x + bar + 0.5 * textWidthMm(length, kKeyLook), middle - 0.2}, length, kKeyLook,
                Qt::AlignRight);
    x += bar + 0.5 * textWidthMm(length, kKeyLook) + 4.0;
    const QString scale = MapWords::tr("1 : %1", "scale of a map").arg(numberText(scale_, 0));
    const TextLook bold{.points = 8.0, .weight = QFont::DemiBold};
    canvas.text({x, base}, scale, bold);
    x += textWidthMm(scale, bold) + 6.0;

    // What does not fit any more is what explains itself.
    const auto entry = [&](const QString& name, auto sample) {
        const double width = 7.5 + textWidthMm(name, kKeyLook) + 3.2;
        if (x + width > key_.right()) {
            return;
        }
        sample(QPointF{x, middle});
        canvas.text({x + 7.5, base}, name, kKeyLook);
        x += width;
    };
    const auto sampleLine = [&canvas](const QColor& colour, double width,
                                      Qt::PenStyle style = Qt::SolidLine) {
        return [&canvas, colour, width, style](QPointF at) {
            canvas.line(at, at + QPointF{6.0, 0.0}, colour, width, style);
        };
    };
    entry(MapWords::tr("Start"), [&](QPointF at) { drawStart(canvas, at + QPointF{4.6, 0.0}); });
    entry(MapWords::tr("End"), [&](QPointF at) { drawEnd(canvas, at + QPointF{4.6, 0.0}); });
    if (!swaths_.empty()) {
        entry(MapWords::tr("Swath"), sampleLine(ink::kSwath, 0.35));
    }
    if (!rings_.empty()) {
        entry(MapWords::tr("Headland pass"), sampleLine(ink::kHeadland, 0.35, Qt::DashLine));
    }
    entry(MapWords::tr("Implement up"), sampleLine(ink::kTurn, 0.35));
    if (!findings_.empty()) {
        entry(MapWords::tr("Finding"), [&](QPointF at) {
            drawDiamond(canvas, at + QPointF{4.6, 0.0}, QStringLiteral("1"), findings_.front().blocking, 1.8);
        });
    }
    if (!gates_.empty()) {
        entry(MapWords::tr("Gate"), [&](QPointF at) { drawGate(canvas, at + QPointF{4.6, 0.0}); });
    }
    if (!solid_.empty() || !passable_.empty()) {
        entry(MapWords::tr("Obstacle"), [&](QPointF at) {
            const QRectF box{at + QPointF{1.5, -1.2}, QSizeF{4.5, 2.4}};
            hatch(canvas, {QPolygonF{box}}, solid_.empty());
        });
    }
}

}  // namespace furrow
