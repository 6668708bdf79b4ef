#pragma once

#include "ui/pages/page_flow.h"

#include <QCoreApplication>

#include <vector>

namespace furrow {

/// Translates what stands on a work order.
struct OrderWords {
    Q_DECLARE_TR_FUNCTIONS(WorkOrderPages)
};

inline const TextLook kHeading{.points = 11.0, .weight = QFont::DemiBold, .colour = ink::kText};

/// A heading over a line.
/// @param heightBelow  of what stays on its page, in mm
void layHeading(PageFlow& flow, const QString& text, double heightBelow);

/// The lists of a plan, which may go on over several pages: findings, comments, kinds of turn, and the order
/// of the passes.
class OrderLists {
public:
    OrderLists(const OrderedPlan& plan, PageFlow& flow);

    void lay();

private:
    struct Paragraph {
        QString text;
        TextLook look;
    };

    void layFindings();
    void layComments();
    void layTurns();
    void layPasses();
    void layRemark(const QString& mark, const QColor& colour, const std::vector<Paragraph>& text,
                   const QString& aside);

    const OrderedPlan& plan_;
    const OrderSheet& sheet_;
    PageFlow& flow_;
};

}  // namespace furrow
