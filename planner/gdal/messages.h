#pragma once

#include <cpl_error.h>

#include <string>

namespace furrow {

/// Keeps what GDAL would print; the first failure is the one that explains the others.
class GdalMessages {
public:
    GdalMessages() { CPLPushErrorHandlerEx(&GdalMessages::keep, this); }
    ~GdalMessages() { CPLPopErrorHandler(); }
    GdalMessages(const GdalMessages&) = delete;
    GdalMessages& operator=(const GdalMessages&) = delete;

    bool failed() const { return !failure_.empty(); }
    const std::string& failure() const { return failure_; }
    void forget() { failure_.clear(); }

private:
    static void CPL_STDCALL keep(CPLErr severity, CPLErrorNum, const char* message) {
        auto* self = static_cast<GdalMessages*>(CPLGetErrorHandlerUserData());
        if (severity >= CE_Failure && self->failure_.empty()) {
            self->failure_ = message;
        }
    }
    std::string failure_;
};

}  // namespace furrow
