#pragma once

namespace furrow::cli {

class InterruptWatch;
struct ReportArguments;

/// Prints what `furrow-cli report` was asked for. The application has to exist. @return the exit status
int runReport(const ReportArguments& arguments, const InterruptWatch& watch);

}  // namespace furrow::cli
