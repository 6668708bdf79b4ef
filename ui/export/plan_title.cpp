#include "ui/export/plan_title.h"

#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace furrow {

namespace {

struct TitleText {
    Q_DECLARE_TR_FUNCTIONS(PlanTitle)
};

}  // namespace

QString PlanTitle::heading() const {
    if (!plan) {
        return {};
    }
    QStringList parts{fromStd(plan->field().name())};
    if (!name.isEmpty()) {
        parts << name;
    }
    return inOneLine(parts);
}

QString PlanTitle::details() const {
    if (!plan) {
        return {};
    }
    const Machine& machine = plan->request.machine;
    return inOneLine({shown(machine.name()),
                      TitleText::tr("%1 wide").arg(metresText(machine.operatingWidth(), 1)),
                      TitleText::tr("takes %1").arg(durationText(plan->path.duration())),
                      TitleText::tr("planned %1").arg(QLocale{}.toString(finished, QLocale::ShortFormat))});
}

QString PlanTitle::whole() const {
    return plan ? inOneLine({heading(), details()}) : QString{};
}

}  // namespace furrow
