#include "ui/plan/plan_title.h"

#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace furrow {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(PlanTitle)
};

const QString kSeparator = QStringLiteral(" · ");

}  // namespace

QString PlanTitle::heading() const {
    if (!plan) {
        return {};
    }
    QStringList parts{fromStd(plan->field().name())};
    if (!name.isEmpty()) {
        parts << name;
    }
    return parts.join(kSeparator);
}

QString PlanTitle::details() const {
    if (!plan) {
        return {};
    }
    const Machine& machine = plan->request.machine;
    return QStringList{shown(machine.name()), Text::tr("%1 wide").arg(metresText(machine.operatingWidth(), 1)),
                       Text::tr("takes %1").arg(durationText(plan->path.duration())),
                       Text::tr("planned %1").arg(QLocale{}.toString(finished, QLocale::ShortFormat))}
        .join(kSeparator);
}

QString PlanTitle::whole() const {
    return plan ? QStringList{heading(), details()}.join(kSeparator) : QString{};
}

}  // namespace furrow
