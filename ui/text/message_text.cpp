#include "ui/text/message_text.h"

#include "planner/core/place_message.h"
#include "ui/text/unit_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>

namespace furrow {

namespace {

/// Of the texts that translations/collect finds in the planner.
constexpr auto kContext = "Planner";

// What has as many decimals is a coordinate, which files and other programs write with a point.
constexpr int kCoordinateDecimals = 6;
// Characters.
constexpr qsizetype kLongestAmount = 12;

QString capital(QString text) {
    if (!text.isEmpty()) {
        text[0] = text[0].toUpper();
    }
    return text;
}

QString plainNumber(double number, int decimals) {
    if (decimals >= kCoordinateDecimals) {
        return QString::number(number, 'f', decimals);
    }
    return decimals < 0 ? shortNumberText(number, kCoordinateDecimals) : numberText(number, decimals);
}

QString quantity(const MessageArgument& argument) {
    switch (argument.unit) {
        case MessageUnit::Metres:
            return argument.decimals < 0 ? shortLengthText(metres(argument.number))
                                         : metresText(metres(argument.number), argument.decimals);
        case MessageUnit::SquareMetres:
            return squareMetresText(squareMetres(argument.number), argument.decimals);
        case MessageUnit::Hectares:
            return hectaresText(squareMetres(argument.number * 1e4), argument.decimals);
        case MessageUnit::MetresPerSecond: return speedText(metresPerSecond(argument.number));
        case MessageUnit::MetresPerSecondSquared:
            return accelerationText(Acceleration::fromSi(argument.number), argument.decimals);
        case MessageUnit::Degrees:
            return plainNumber(argument.number, argument.decimals) + QStringLiteral("°");
        case MessageUnit::Percent:
            return percentText(argument.number / 100.0, std::max(argument.decimals, 0));
        case MessageUnit::None: break;
    }
    return argument.isWhole ? QLocale{}.toString(static_cast<qlonglong>(argument.number))
                            : plainNumber(argument.number, argument.decimals);
}

/// A number and its unit stay on one line.
QString unbroken(QString text) {
    return text.replace(QLatin1Char(' '), QChar{QChar::Nbsp});
}

/// A number with a word ("3 min", "1 h 20 min", "24 passes"), and not a sentence.
bool isAmount(const QString& text) {
    return text.size() <= kLongestAmount &&
           std::ranges::any_of(text, [](QChar each) { return each.isDigit(); });
}

QString argumentText(const MessageArgument& argument) {
    switch (argument.kind) {
        case MessageArgument::Kind::Words: return fromStd(argument.message.text());
        case MessageArgument::Kind::Message: {
            const QString text = shown(argument.message);
            return isAmount(text) ? unbroken(text) : text;
        }
        case MessageArgument::Kind::Number: break;
    }
    return unbroken(quantity(argument));
}

/// Keys of settings are for the command line; in the window a setting has a name and a place.
QString withoutKeys(QString text) {
    static const QRegularExpression key{QStringLiteral(" \\([a-z]+\\.[a-z_]+\\)")};
    return text.remove(key);
}

/// %1 ... in one go: what an argument holds is not looked at again.
QString filled(const QString& pattern, const std::vector<MessageArgument>& arguments, std::size_t first) {
    QString text;
    for (qsizetype i = 0; i < pattern.size(); ++i) {
        const bool place =
            pattern[i] == QLatin1Char('%') && i + 1 < pattern.size() && pattern[i + 1].isDigit();
        const std::size_t index =
            place ? first + static_cast<std::size_t>(pattern[i + 1].digitValue()) - 1 : arguments.size();
        if (index < arguments.size()) {
            text += argumentText(arguments[index]);
            ++i;
        } else {
            text += pattern[i];
        }
    }
    return text;
}

}  // namespace

QString shown(const Message& message) {
    if (message.empty()) {
        return {};
    }
    if (isPlace(message)) {
        return placeText({.lonDeg = message.arguments()[0].number, .latDeg = message.arguments()[1].number});
    }
    const std::string& key = message.key();
    QString text;
    if (message.count()) {
        const QString source = fromStd(key);
        const QString counted =
            QCoreApplication::translate(kContext, key.c_str(), nullptr, static_cast<int>(*message.count()));
        const QString number = QLocale{}.toString(static_cast<qlonglong>(*message.count()));
        // English needs no translation: the planner has put one or many already.
        const bool translated = counted != QString{source}.replace(QLatin1String{"%n"}, number);
        text = translated ? counted : fromStd(message.englishPattern()).replace(QLatin1String{"%n"}, number);
        text = filled(withoutKeys(text), message.arguments(), 1);
    } else {
        text = withoutKeys(QCoreApplication::translate(kContext, key.c_str()));
        if (!message.arguments().empty()) {
            text = filled(text, message.arguments(), 0);
        }
    }
    return message.isCapitalised() ? capital(text) : text;
}

QString sentence(const Message& message) {
    return capital(shown(message));
}

QString shown(std::string_view text) {
    return text.empty() ? QString{} : QCoreApplication::translate(kContext, std::string{text}.c_str());
}

QStringList sentences(const std::vector<Message>& messages) {
    QStringList lines;
    for (const Message& message : messages) {
        lines << sentence(message);
    }
    return lines;
}

QString text(const LazyText& said) {
    return said ? said() : QString{};
}

QString shown(const std::string& text) {
    return shown(std::string_view{text});
}

QString shown(const char* text) {
    return shown(std::string_view{text});
}

}  // namespace furrow
