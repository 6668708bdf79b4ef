#include "ui/text/quantity_text.h"

#include "planner/units/quantity.h"
#include "planner/units/unit_system.h"
#include "ui/text/display.h"
#include "ui/text/number_text.h"
#include "ui/text/unit_text.h"

#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>

namespace furrow {

namespace {

struct TypedUnit {
    const char* text;
    QuantityText::Kind kind;
    double si;
};

// What people write behind a number, in small letters. Words of languages only where they are in daily use.
constexpr std::array kTypedUnits{
    TypedUnit{"m", QuantityText::Length, 1.0},
    TypedUnit{"cm", QuantityText::Length, 0.01},
    TypedUnit{"mm", QuantityText::Length, 0.001},
    TypedUnit{"km", QuantityText::Length, 1000.0},
    TypedUnit{"ft", QuantityText::Length, kFootM},
    TypedUnit{"feet", QuantityText::Length, kFootM},
    TypedUnit{"foot", QuantityText::Length, kFootM},
    TypedUnit{"'", QuantityText::Length, kFootM},
    TypedUnit{"in", QuantityText::Length, kInchM},
    TypedUnit{"inch", QuantityText::Length, kInchM},
    TypedUnit{"inches", QuantityText::Length, kInchM},
    TypedUnit{"\"", QuantityText::Length, kInchM},
    TypedUnit{"''", QuantityText::Length, kInchM},
    TypedUnit{"yd", QuantityText::Length, kYardM},
    TypedUnit{"mi", QuantityText::Length, kMileM},
    TypedUnit{"m2", QuantityText::Area, 1.0},
    TypedUnit{"ha", QuantityText::Area, kHectareM2},
    TypedUnit{"ac", QuantityText::Area, kAcreM2},
    TypedUnit{"acre", QuantityText::Area, kAcreM2},
    TypedUnit{"acres", QuantityText::Area, kAcreM2},
    TypedUnit{"ft2", QuantityText::Area, kFootM* kFootM},
    TypedUnit{"km/h", QuantityText::Speed, kKilometrePerHourMps},
    TypedUnit{"kmh", QuantityText::Speed, kKilometrePerHourMps},
    TypedUnit{"kph", QuantityText::Speed, kKilometrePerHourMps},
    TypedUnit{"m/s", QuantityText::Speed, 1.0},
    TypedUnit{"mph", QuantityText::Speed, kMilePerHourMps},
    TypedUnit{"°", QuantityText::Angle, 1.0},
    TypedUnit{"deg", QuantityText::Angle, 1.0},
    TypedUnit{"s", QuantityText::Duration, 1.0},
    TypedUnit{"min", QuantityText::Duration, 60.0},
};

std::optional<double> unitNamed(const QString& text, QuantityText::Kind kind) {
    const auto found = std::ranges::find_if(kTypedUnits, [&](const TypedUnit& unit) {
        return unit.kind == kind && text == QString::fromUtf8(unit.text);
    });
    return found == kTypedUnits.end() ? std::nullopt : std::optional{found->si};
}

double siOf(QuantityText::Kind kind) {
    const bool imperial = Display::instance().isImperial();
    switch (kind) {
        case QuantityText::Length: return imperial ? kFootM : 1.0;
        case QuantityText::Area: return imperial ? kAcreM2 : kHectareM2;
        case QuantityText::Speed: return imperial ? kMilePerHourMps : kKilometrePerHourMps;
        case QuantityText::Angle:
        case QuantityText::Duration:
        case QuantityText::Count:
        case QuantityText::Number: break;
    }
    return 1.0;
}

/// Typographic marks and blanks as the keyboard has them.
QString plain(QString text) {
    text = text.toLower();
    for (const QChar prime : {QChar{u'′'}, QChar{u'’'}, QChar{u'‘'}, QChar{u'´'}}) {
        text.replace(prime, QLatin1Char('\''));
    }
    for (const QChar twice : {QChar{u'″'}, QChar{u'”'}, QChar{u'“'}}) {
        text.replace(twice, QLatin1Char('"'));
    }
    text.replace(QChar{u'²'}, QLatin1Char('2'));
    text.replace(QChar{u'−'}, QLatin1Char('-'));
    return text.simplified();
}

double roundBelow(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    const double digits = value / power;
    return power * (digits >= 5.0 ? 5.0 : digits >= 2.0 ? 2.0 : 1.0);
}

}  // namespace

std::optional<double> QuantityText::parsed(const QString& text, Kind kind) {
    const QString typed = plain(text);
    if (const auto number = parsedNumber(typed)) {
        return kind == Count && *number != std::trunc(*number) ? std::nullopt
                                                               : std::optional{*number * siOf(kind)};
    }
    static const QRegularExpression withUnit{QStringLiteral(R"(^([+-]?[\d.,]+) ?([^\d\s.,+-][^\s.,+-]*)$)")};
    if (const QRegularExpressionMatch match = withUnit.match(typed); match.hasMatch()) {
        const auto number = parsedNumber(match.captured(1));
        const auto unit = unitNamed(match.captured(2), kind);
        if (number && unit) {
            return *number * *unit;
        }
    }
    // Feet and then inches: 10'6", 10' 6, 10 ft 6 in.
    static const QRegularExpression feetAndInches{
        QStringLiteral(R"(^([+-]?\d+) ?('|ft|feet|foot) ?(\d+(?:[.,]\d*)?) ?("|''|in|inch|inches)?$)")};
    const QRegularExpressionMatch match = feetAndInches.match(typed);
    if (kind != Length || !match.hasMatch()) {
        return std::nullopt;
    }
    const double feet = parsedNumber(match.captured(1)).value_or(0.0);
    const double inches = parsedNumber(match.captured(3)).value_or(12.0);
    if (inches >= 12.0) {
        return std::nullopt;
    }
    return std::copysign(std::abs(feet) * kFootM + inches * kInchM,
                         match.captured(1).startsWith(QLatin1Char('-')) ? -1.0 : 1.0);
}

QString QuantityText::text(double value, Kind kind, int decimals) const {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(value / siOf(kind), 'f', decimals);
}

QString QuantityText::unit(Kind kind) const {
    const bool imperial = Display::instance().isImperial();
    switch (kind) {
        case Length: return imperial ? tr("ft") : tr("m");
        case Area: return imperial ? tr("ac") : tr("ha");
        case Speed: return imperial ? tr("mph") : tr("km/h");
        case Angle: return tr("°");
        case Duration: return tr("s");
        case Count:
        case Number: break;
    }
    return {};
}

double QuantityText::unitSize(Kind kind) const {
    return siOf(kind);
}

double QuantityText::roundStep(double step, Kind kind) const {
    const double size = siOf(kind);
    return size == 1.0 ? step : std::max(roundBelow(step / size * 1.0001), 0.1) * size;
}

QString QuantityText::complaint(const QString& text, Kind kind, double from, double to, int decimals) const {
    const auto typed = parsed(text, kind);
    if (!typed) {
        switch (kind) {
            case Length: return tr("This is not a length. Type it like 7.3 m, 24 ft or 10'6\".");
            case Area: return tr("This is not an area. Type it like 12.5 ha or 30 ac.");
            case Speed: return tr("This is not a speed. Type it like 8 km/h or 5 mph.");
            case Angle: return tr("This is not an angle. Type it in degrees, like 87.5.");
            case Duration: return tr("This is not a time. Type it like 45 s or 2 min.");
            case Number: return tr("This is not a number.");
            case Count: return tr("This is not a whole number.");
        }
    }
    // Half a last digit beyond the end is the end, shown rounded.
    const double slack = 0.5 * std::pow(10.0, -decimals) * siOf(kind);
    if (*typed < from - slack || *typed > to + slack) {
        const QString unitText = unit(kind);
        const auto named = [&](double end) {
            const QString number = shortNumberText(end / siOf(kind), decimals);
            return unitText.isEmpty() ? number
                   : kind == Angle    ? number + unitText
                                      : tr("%1 %2").arg(number, unitText);
        };
        return tr("Type something from %1 to %2.").arg(named(from), named(to));
    }
    return {};
}

double QuantityText::roundLengthBelow(double metres) const {
    if (!(metres > 0.0)) {
        return 1.0;
    }
    if (!Display::instance().isImperial()) {
        return roundBelow(metres);
    }
    return metres >= kMileM ? roundBelow(metres / kMileM) * kMileM : roundBelow(metres / kFootM) * kFootM;
}

QString QuantityText::scaleText(double metres) const {
    const bool imperial = Display::instance().isImperial();
    const double large = imperial ? kMileM : 1000.0;
    const double small = imperial ? kFootM : 1.0;
    if (metres >= large * (1.0 - 1e-9)) {
        const QString number = shortNumberText(metres / large, 2);
        return imperial ? tr("%1 mi").arg(number) : tr("%1 km").arg(number);
    }
    const QString number = shortNumberText(metres / small, 2);
    return imperial ? tr("%1 ft").arg(number) : tr("%1 m").arg(number);
}

}  // namespace furrow
