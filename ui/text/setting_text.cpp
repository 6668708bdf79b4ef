#include "ui/text/setting_text.h"

#include "planner/plan/method_registry.h"
#include "ui/text/message_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <string_view>

namespace furrow {

namespace {

struct SettingText {
    Q_DECLARE_TR_FUNCTIONS(SettingText)
};

}  // namespace

QString settingName(const Parameter& parameter) {
    const std::string_view id = parameter.key.substr(0, parameter.key.find('.'));
    const auto stage = std::ranges::find(stages(), id, &StageInfo::id);
    const QString name = shown(parameter.name);
    return stage == stages().end() || stage->name == parameter.name
               ? name
               : SettingText::tr("%1: %2").arg(shown(stage->name), name);
}

}  // namespace furrow
