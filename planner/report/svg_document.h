#pragma once

#include "planner/geometry/point.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

/// How a shape is drawn: colours as "#0072b2", "none" or empty for none, lengths in pixels.
struct SvgStyle {
    std::string_view fill = "none";
    std::string_view stroke = "none";
    double width = 1.0;
    std::string_view dash;  ///< "4 3"
    double opacity = 1.0;
};

enum class TextAnchor { Start, Middle, End };

struct TextStyle {
    double size = 12.0;
    std::string_view colour = "#1f2933";
    TextAnchor anchor = TextAnchor::Start;
    bool bold = false;
};

/// Colours that people with any kind of colour blindness can tell apart on white, in order of use (Okabe
/// and Ito 2008, without their yellow, which is too light for lines).
inline constexpr std::string_view kPalette[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                "#e69f00", "#56b4e9", "#000000"};

// What charts and maps share: the margin, and the height of a line of text.
inline constexpr double kMarginPx = 16.0;
inline constexpr double kLinePx = 16.0;
inline constexpr double kTitleSize = 15.0;
inline constexpr double kTextSize = 12.0;
/// Of what is beside the point: units, notes.
inline constexpr std::string_view kQuiet = "#52606d";

/// A picture of plain shapes and text. Positions in pixels, y downwards. Only presentation attributes are
/// used, so that browsers, Qt, Inkscape and office programs show the same.
class SvgDocument {
public:
    void line(Point from, Point to, const SvgStyle& style);
    void polyline(std::span<const Point> points, const SvgStyle& style);
    void polygon(std::span<const std::vector<Point>> rings, const SvgStyle& style);  ///< even-odd
    void circle(Point centre, double radius, const SvgStyle& style);
    void rectangle(Point corner, double width, double height, const SvgStyle& style);
    void text(Point at, std::string_view text, const TextStyle& style = {});  ///< `at` is on its base line

    /// Everything drawn by another document, moved.
    void add(const SvgDocument& other, Point by);

    /// The whole file, on a white ground. @param title  what screen readers say
    std::string file(double width, double height, std::string_view title) const;

private:
    std::string body_;
};

/// A picture with its size in pixels.
struct SvgPart {
    SvgDocument picture;
    double width = 0.0;
    double height = 0.0;
};

/// Pictures in rows under one title, as a file.
std::string svgGrid(std::span<const SvgPart> parts, int columns, std::string_view title,
                    std::string_view note);

/// How wide a text comes out at most, in pixels: by the letters of DejaVu Sans, the widest of the usual
/// fonts. What is laid out by it does not overlap in any of them.
double textWidth(std::string_view text, double size, bool bold = false);

/// Words in lines of at most this width; a word that is longer stands alone.
std::vector<std::string> wrapped(std::string_view text, double size, double width);

}  // namespace furrow
