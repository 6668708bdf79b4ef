#pragma once

#include "planner/jobs/job.h"

#include <cstdio>
#include <format>
#include <print>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

namespace furrow::cli {

/// Turns Ctrl+C into a stop request. Make it before any other thread.
class InterruptWatch {
public:
    InterruptWatch();
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    std::stop_token token() const { return source_.get_token(); }

private:
    std::stop_source source_;
    std::jthread waiter_;
};

/// A context that stops on Ctrl+C and draws a bar on standard error where that is a terminal.
JobContext terminalJob(const InterruptWatch& watch, int threads, bool quiet);

/// The same, with a line on standard error for each tenth of the work, for other programs to read.
JobContext linesJob(const InterruptWatch& watch, int threads);

/// A text of others (names, paths) as a terminal may show it: what would move its cursor, change its colours
/// or begin a line of its own is replaced by a question mark.
std::string harmless(std::string_view text, bool keepLines = false);

/// A line of text on standard output, or on `to`.
template <class... Values>
void say(std::FILE* to, std::format_string<Values...> format, Values&&... values) {
    std::println(to, "{}", harmless(std::format(format, std::forward<Values>(values)...)));
}
template <class... Values>
void say(std::format_string<Values...> format, Values&&... values) {
    say(stdout, format, std::forward<Values>(values)...);
}
/// Several lines.
void sayLines(std::string_view lines);

/// Takes the bar away again.
void clearProgress(bool quiet);

}  // namespace furrow::cli
