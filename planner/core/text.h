#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace furrow {

/// Letters of ASCII made small; the others stay.
std::string inSmallLetters(std::string_view text);

/// ".geojson" of "Home Field.GeoJSON".
std::string extensionInSmallLetters(const std::filesystem::path& path);

/// Without the blanks, tabs and line ends around it.
std::string_view trimmed(std::string_view text);

/// The whole text as a number, as people and machines write it: blanks around it and a plus sign allowed,
/// "nan" and "inf" among them.
std::optional<double> numberIn(std::string_view text, bool decimalComma = false);

/// The whole text as a finite number, blanks around it allowed; nothing for anything else.
std::optional<double> decimalIn(std::string_view text);

/// A plain decimal: no blanks, no exponent, no comma.
std::optional<double> plainDecimalIn(std::string_view text);

}  // namespace furrow
