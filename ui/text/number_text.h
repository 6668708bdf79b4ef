#pragma once

#include <QString>

#include <optional>

namespace furrow {

/// A number typed by a person, with decimal point or comma and nothing behind it.
std::optional<double> parsedNumber(const QString& text);

}  // namespace furrow
