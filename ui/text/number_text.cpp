#include "ui/text/number_text.h"

#include <QRegularExpression>

namespace furrow {

std::optional<double> parsedNumber(const QString& text) {
    static const QRegularExpression pattern{QStringLiteral(R"(^\s*([+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+))\s*$)")};
    const QRegularExpressionMatch match = pattern.match(text);
    if (!match.hasMatch()) {
        return std::nullopt;
    }
    bool ok = false;
    const double value = match.captured(1).replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&ok);
    return ok ? std::optional{value} : std::nullopt;
}

}  // namespace furrow
