#include "ui/text/unit_text.h"

#include "planner/units/angle.h"
#include "planner/units/unit_system.h"
#include "ui/text/display.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(UnitText)
};

bool imperial() {
    return Display::instance().isImperial();
}

QString feetText(double feet, int decimals) {
    return Text::tr("%1 ft").arg(numberText(feet, decimals));
}

}  // namespace

QString fromStd(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString placeText(GeoPoint place) {
    constexpr int kDecimals = 6;
    return QStringLiteral("%1° %2, %3° %4")
        .arg(numberText(std::abs(place.latDeg), kDecimals), place.latDeg < 0.0 ? "S" : "N",
             numberText(std::abs(place.lonDeg), kDecimals), place.lonDeg < 0.0 ? "W" : "E");
}

QString numberText(double value, int decimals) {
    return QLocale{}.toString(value, 'f', decimals);
}

QString shortNumberText(double value, int mostDecimals) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    for (int decimals = 0; decimals < mostDecimals; ++decimals) {
        const double power = std::pow(10.0, decimals);
        if (std::abs(std::round(value * power) / power - value) < 0.5 * std::pow(10.0, -mostDecimals)) {
            return locale.toString(value, 'f', decimals);
        }
    }
    return locale.toString(value, 'f', mostDecimals);
}

QString areaText(Area area) {
    const double large = imperial() ? area.si() / kAcreM2 : inHectares(area);
    if (large < 0.01) {
        return squareMetresText(area, 0);
    }
    return hectaresText(area, large < 1.0 ? 2 : large < 1000.0 ? 1 : 0);
}

QString squareMetresText(Area area, int decimals) {
    return imperial()
               ? Text::tr("%1 ft²").arg(numberText(area.si() / (kFootM * kFootM), std::max(decimals - 1, 0)))
               : Text::tr("%1 m²").arg(numberText(area.si(), std::max(decimals, 0)));
}

QString hectaresText(Area area, int decimals) {
    return imperial() ? Text::tr("%1 ac").arg(numberText(area.si() / kAcreM2, std::max(decimals, 0)))
                      : Text::tr("%1 ha").arg(numberText(inHectares(area), std::max(decimals, 0)));
}

QString lengthText(Length length) {
    const double metresSi = length.si();
    if (imperial()) {
        const double miles = metresSi / kMileM;
        return miles >= 1.0 ? Text::tr("%1 mi").arg(numberText(miles, miles < 100.0 ? 1 : 0))
                            : feetText(metresSi / kFootM, metresSi / kFootM < 100.0 ? 1 : 0);
    }
    if (metresSi >= 1000.0) {
        return Text::tr("%1 km").arg(numberText(metresSi / 1000.0, metresSi < 100000.0 ? 1 : 0));
    }
    return Text::tr("%1 m").arg(numberText(metresSi, metresSi < 100.0 ? 1 : 0));
}

QString metresText(Length length, int decimals) {
    return imperial() ? feetText(length.si() / kFootM, decimals)
                      : Text::tr("%1 m").arg(numberText(length.si(), decimals));
}

QString metresText(Length least, Length most) {
    const double perUnit = imperial() ? kFootM : 1.0;
    const QString first = shortNumberText(least.si() / perUnit, 1);
    const QString last = shortNumberText(most.si() / perUnit, 1);
    if (first == last) {
        return metresText(most, 1);
    }
    const QString both = QStringLiteral("%1 – %2").arg(first, last);
    return imperial() ? Text::tr("%1 ft").arg(both) : Text::tr("%1 m").arg(both);
}

QString shortLengthText(Length length) {
    return imperial() ? Text::tr("%1 ft").arg(shortNumberText(length.si() / kFootM, 2))
                      : Text::tr("%1 m").arg(shortNumberText(length.si(), 3));
}

QString speedText(Speed speed) {
    return imperial() ? Text::tr("%1 mph").arg(shortNumberText(speed.si() / kMilePerHourMps, 1))
                      : Text::tr("%1 km/h").arg(shortNumberText(speed.si() / kKilometrePerHourMps, 1));
}

QString accelerationText(Acceleration acceleration, int decimals) {
    return imperial() ? Text::tr("%1 ft/s²").arg(numberText(acceleration.si() / kFootM, decimals))
                      : Text::tr("%1 m/s²").arg(numberText(acceleration.si(), decimals));
}

QString durationText(Duration duration) {
    const auto minutes = static_cast<qint64>(std::llround(duration.si() / 60.0));
    if (minutes < 1) {
        return Text::tr("%1 s").arg(std::llround(duration.si()));
    }
    if (minutes < 60) {
        return Text::tr("%1 min").arg(minutes);
    }
    return Text::tr("%1 h %2 min").arg(minutes / 60).arg(minutes % 60);
}

QString exactDurationText(Duration duration) {
    const auto whole = static_cast<qint64>(std::llround(duration.si()));
    if (whole < 60) {
        return Text::tr("%1 s").arg(whole);
    }
    const QString rest = QStringLiteral("%1").arg(whole % 60, 2, 10, QLatin1Char{'0'});
    return whole < 3600 ? Text::tr("%1 min %2 s").arg(whole / 60).arg(rest)
                        : Text::tr("%1 h %2 min %3 s").arg(whole / 3600).arg(whole / 60 % 60).arg(rest);
}

QString percentText(double share, int decimals) {
    return Text::tr("%1 %").arg(numberText(share * 100.0, decimals));
}

QString bearingText(Angle swathHeading) {
    const auto bearing = static_cast<int>(std::llround(lineBearingDeg(swathHeading))) % 180;
    return Text::tr("%1°").arg(bearing);
}

QString inOneLine(const QStringList& parts) {
    return parts.join(QStringLiteral(" · "));
}

}  // namespace furrow
