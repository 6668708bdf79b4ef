#include "planner/core/error.h"

namespace furrow {

std::string Error::line() const {
    std::string text;
    if (!where.empty()) {
        text += where + ": ";
    }
    text += what;
    if (!remedy.empty()) {
        text += "; " + remedy;
    }
    return text;
}

Error cancelled() {
    return {.code = ErrorCode::Cancelled, .what = "cancelled"};
}

}  // namespace furrow
