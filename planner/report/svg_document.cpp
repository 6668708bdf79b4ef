#include "planner/report/svg_document.h"

#include <algorithm>
#include <cmath>
#include <format>
#include <iterator>

namespace furrow {

namespace {

/// Hundredths of a pixel are finer than any screen.
std::string px(double value) {
    std::string text = std::format("{:.2f}", std::isfinite(value) ? value : 0.0);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) {
        text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

std::string attributes(const SvgStyle& style) {
    std::string text = std::format(" fill=\"{}\"", style.fill.empty() ? "none" : style.fill);
    if (style.stroke != "none" && !style.stroke.empty()) {
        text += std::format(" stroke=\"{}\" stroke-width=\"{}\"", style.stroke, px(style.width));
        if (!style.dash.empty()) {
            text += std::format(" stroke-dasharray=\"{}\"", style.dash);
        }
    }
    if (style.opacity < 1.0) {
        text += std::format(" opacity=\"{}\"", px(style.opacity));
    }
    return text;
}

/// Text for XML; control characters, which XML does not know, become blanks.
std::string escaped(std::string_view text) {
    std::string safe;
    for (const char letter : text) {
        switch (letter) {
            case '&': safe += "&amp;"; break;
            case '<': safe += "&lt;"; break;
            case '>': safe += "&gt;"; break;
            case '"': safe += "&quot;"; break;
            default: safe += static_cast<unsigned char>(letter) < 0x20 ? ' ' : letter;
        }
    }
    return safe;
}

void appendPoints(std::string& body, std::span<const Point> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::format_to(std::back_inserter(body), "{}{} {}", i == 0 ? "M" : "L", px(points[i].x),
                       px(points[i].y));
    }
}

/// Widths of DejaVu Sans in thousandths of its size, by classes that are never too narrow.
int letterWidth(char letter) {
    constexpr std::string_view kNarrow = " .,:;'!|iljI[]()/\\";
    constexpr std::string_view kMedium = "ftrs-J\"*";
    constexpr std::string_view kWide = "mwMW@%+=<>~OQGDHNU";
    if (kNarrow.find(letter) != std::string_view::npos) {
        return 400;
    }
    if (kMedium.find(letter) != std::string_view::npos) {
        return 530;
    }
    if (kWide.find(letter) != std::string_view::npos) {
        return letter == 'm' || letter == 'W' || letter == '@' || letter == '%' ? 1000 : 860;
    }
    return letter >= 'A' && letter <= 'Z' ? 720 : 640;
}

}  // namespace

void SvgDocument::line(Point from, Point to, const SvgStyle& style) {
    const Point points[] = {from, to};
    polyline(points, style);
}

void SvgDocument::polyline(std::span<const Point> points, const SvgStyle& style) {
    if (points.size() < 2) {
        return;
    }
    body_ += "<path d=\"";
    appendPoints(body_, points);
    body_ += "\"" + attributes(style) + " stroke-linejoin=\"round\" stroke-linecap=\"round\"/>\n";
}

void SvgDocument::polygon(std::span<const std::vector<Point>> rings, const SvgStyle& style) {
    body_ += "<path d=\"";
    for (const std::vector<Point>& ring : rings) {
        appendPoints(body_, ring);
        body_ += "Z";
    }
    body_ += "\" fill-rule=\"evenodd\"" + attributes(style) + " stroke-linejoin=\"round\"/>\n";
}

void SvgDocument::circle(Point centre, double radius, const SvgStyle& style) {
    std::format_to(std::back_inserter(body_), "<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>\n", px(centre.x),
                   px(centre.y), px(radius), attributes(style));
}

void SvgDocument::rectangle(Point corner, double width, double height, const SvgStyle& style) {
    std::format_to(std::back_inserter(body_), "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}/>\n",
                   px(corner.x), px(corner.y), px(width), px(height), attributes(style));
}

void SvgDocument::text(Point at, std::string_view text, const TextStyle& style) {
    constexpr std::string_view kAnchors[] = {"start", "middle", "end"};
    std::format_to(std::back_inserter(body_),
                   "<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\" text-anchor=\"{}\"{}>{}</text>\n",
                   px(at.x), px(at.y), px(style.size), style.colour, kAnchors[static_cast<int>(style.anchor)],
                   style.bold ? " font-weight=\"bold\"" : "", escaped(text));
}

void SvgDocument::add(const SvgDocument& other, Point by) {
    body_ += std::format("<g transform=\"translate({} {})\">\n{}</g>\n", px(by.x), px(by.y), other.body_);
}

std::string SvgDocument::file(double width, double height, std::string_view title) const {
    return std::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"Inter, 'DejaVu Sans', Arial, sans-serif\">\n"
        "<title>{2}</title>\n"
        "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n{3}</svg>\n",
        px(width), px(height), escaped(title), body_);
}

std::string svgGrid(std::span<const SvgPart> parts, int columns, std::string_view title,
                    std::string_view note) {
    constexpr double kMarginPx = 16.0;
    constexpr double kTitleSize = 18.0;
    constexpr double kTextSize = 12.0;
    SvgDocument all;
    const auto across = static_cast<std::size_t>(std::max(1, columns));
    double width = 0.0;
    for (std::size_t row = 0; row < parts.size(); row += across) {
        double rowWidth = 0.0;
        for (const SvgPart& part : parts.subspan(row, std::min(across, parts.size() - row))) {
            rowWidth += part.width;
        }
        width = std::max(width, rowWidth);
    }
    double top = kMarginPx;
    for (const std::string& line : wrapped(title, kTitleSize * 1.12, width - 2.0 * kMarginPx)) {
        top += kTitleSize + 2.0;
        all.text({kMarginPx, top}, line, {.size = kTitleSize, .bold = true});
    }
    for (const std::string& line : wrapped(note, kTextSize, width - 2.0 * kMarginPx)) {
        top += kTextSize + 4.0;
        all.text({kMarginPx, top}, line, {.size = kTextSize, .colour = "#52606d"});
    }
    top += 6.0;
    for (std::size_t row = 0; row < parts.size(); row += across) {
        double left = 0.0;
        double height = 0.0;
        for (const SvgPart& part : parts.subspan(row, std::min(across, parts.size() - row))) {
            all.add(part.picture, {left, top});
            left += part.width;
            height = std::max(height, part.height);
        }
        top += height;
    }
    return all.file(width, top, title);
}

double textWidth(std::string_view text, double size, bool bold) {
    int sum = 0;
    for (const char letter : text) {
        // Of letters with several bytes the first one counts; none of ours is wider than this.
        const auto byte = static_cast<unsigned char>(letter);
        sum += byte < 0x80 ? letterWidth(letter) : byte >= 0xC0 ? 700 : 0;
    }
    return 1e-3 * sum * size * (bold ? 1.12 : 1.0);
}

std::vector<std::string> wrapped(std::string_view text, double size, double width) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t blank = text.find(' ');
        const std::string word{text.substr(0, blank)};
        text.remove_prefix(blank == std::string_view::npos ? text.size() : blank + 1);
        if (word.empty()) {
            continue;
        }
        if (!lines.empty() && textWidth(lines.back() + " " + word, size) <= width) {
            lines.back() += " " + word;
        } else {
            lines.push_back(word);
        }
    }
    return lines;
}

}  // namespace furrow
