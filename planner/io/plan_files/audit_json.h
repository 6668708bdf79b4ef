#pragma once

#include "planner/audit/audit.h"
#include "planner/geodesy/local_frame.h"

#include <span>
#include <string>

namespace furrow {

/// The figures of an audit and the findings as one JSON object, SI units; null for what could not be
/// measured. Keys as in summary.json.
std::string auditJson(const AuditReport& report, std::span<const Finding> findings, const LocalFrame& frame);

}  // namespace furrow
