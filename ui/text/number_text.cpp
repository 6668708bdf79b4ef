#include "ui/controls/number_text.h"

#include <QLocale>
#include <QRegularExpression>

namespace furrow {

std::optional<double> parsedNumber(const QString& text) {
    static const QRegularExpression pattern{QStringLiteral(R"(^\s*([+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+))\s*[^\d\s.,]*\s*$)")};
    const QRegularExpressionMatch match = pattern.match(text);
    if (!match.hasMatch()) {
        return std::nullopt;
    }
    bool ok = false;
    const double value = match.captured(1).replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&ok);
    return ok ? std::optional{value} : std::nullopt;
}

QString NumberText::text(double value, int decimals) const {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(value, 'f', decimals);
}

}  // namespace furrow
