#include "ui/project/problem.h"

#include "planner/plan/method_registry.h"
#include "ui/map/map_frame.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"

namespace furrow {

Problem::Problem(QObject* parent) : QObject{parent} {
    connect(&Display::instance(), &Display::changed, this, &Problem::changed);
}

QString Problem::text() const {
    return error_ ? sentence(error_->what) : QString{};
}

QString Problem::where() const {
    if (!error_) {
        return {};
    }
    // A setting by the name it has in the panel.
    const auto parameter = findParameter(error_->where.text());
    return parameter ? shown((*parameter)->name) : shown(error_->where);
}

QString Problem::remedy() const {
    return error_ ? sentence(error_->remedy) : QString{};
}

QGeoCoordinate Problem::place() const {
    return error_ && error_->place ? coordinate(*error_->place) : QGeoCoordinate{};
}

void Problem::show(const Error& error) {
    if (error.code != ErrorCode::Cancelled) {
        error_ = error;
        emit changed();
    }
}

void Problem::clear() {
    if (error_) {
        error_.reset();
        emit changed();
    }
}

void Problem::dismiss() {
    clear();
    emit dismissed();
}

}  // namespace furrow
