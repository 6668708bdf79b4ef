#include "planner/core/error.h"

namespace furrow {

std::string Error::line() const {
    std::string text;
    if (!where.empty()) {
        text += where.text() + ": ";
    }
    text += what.text();
    if (!remedy.empty()) {
        text += "; " + remedy.text();
    }
    return text;
}

Error cancelled() {
    return {.code = ErrorCode::Cancelled, .what = "cancelled"};
}

}  // namespace furrow
