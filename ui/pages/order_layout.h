#pragma once

#include "ui/pages/page_flow.h"

namespace furrow {

/// Lays out the pages of one plan.
class OrderLayout {
public:
    OrderLayout(const OrderedPlan& plan, const QString& farm, PageFlow& flow);

    void lay();

private:
    struct Row {
        QString name;
        QString value;
    };

    void layHead();
    void layOrder();
    void layBanner();
    void layMap();
    void layFigures();
    void layFacts();
    void layRecord();
    void layHash();

    void rowsSideBySide(const QString& leftTitle, const std::vector<Row>& left, const QString& rightTitle,
                        const std::vector<Row>& right);
    std::vector<Row> machineRows() const;
    std::vector<Row> planRows() const;
    std::vector<Row> figureRows() const;
    QString rateText() const;
    QString totalText() const;

    const OrderedPlan& plan_;
    const OrderSheet& sheet_;
    QString farm_;
    PageFlow& flow_;
};

/// "Draft", "Issued" ...
QString statusText(WorkOrderStatus status);

/// Problems of a plan that cannot be driven; empty for one that can.
QString problemText(const OrderSheet& sheet);

}  // namespace furrow
