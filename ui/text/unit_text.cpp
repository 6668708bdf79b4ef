#include "ui/plan/unit_text.h"

#include "planner/units/angle.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

namespace furrow {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(UnitText)
};

}  // namespace

QString fromStd(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
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
    const double hectares = inHectares(area);
    if (hectares < 0.01) {
        return Text::tr("%1 m²").arg(numberText(area.si(), 0));
    }
    return Text::tr("%1 ha").arg(numberText(hectares, hectares < 1.0 ? 2 : hectares < 1000.0 ? 1 : 0));
}

QString lengthText(Length length) {
    const double metresSi = length.si();
    if (metresSi >= 1000.0) {
        return Text::tr("%1 km").arg(numberText(metresSi / 1000.0, metresSi < 100000.0 ? 1 : 0));
    }
    return Text::tr("%1 m").arg(numberText(metresSi, metresSi < 100.0 ? 1 : 0));
}

QString metresText(Length length, int decimals) {
    return Text::tr("%1 m").arg(numberText(length.si(), decimals));
}

QString speedText(Speed speed) {
    return Text::tr("%1 km/h").arg(shortNumberText(speed.si() * 3.6, 1));
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

QString percentText(double share, int decimals) {
    return Text::tr("%1 %").arg(numberText(share * 100.0, decimals));
}

QString bearingText(Angle swathHeading) {
    const auto bearing = static_cast<int>(std::llround(lineBearingDeg(swathHeading))) % 180;
    return Text::tr("%1°").arg(bearing);
}

}  // namespace furrow
