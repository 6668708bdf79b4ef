#include "app/window/arguments.h"

#include <QCommandLineParser>
#include <QCoreApplication>

#include <cstdio>

namespace furrow {

namespace {

constexpr QLatin1String kFieldId{"field-id"};
constexpr QLatin1String kSelfTest{"self-test"};
constexpr QLatin1String kScreenshot{"screenshot"};
constexpr QLatin1String kSize{"size"};
constexpr QLatin1String kTheme{"colours"};
constexpr QLatin1String kLanguage{"language"};
constexpr QLatin1String kUnits{"units"};

QSize sizeFrom(const QString& text) {
    const QStringList parts = text.split(QLatin1Char('x'));
    return parts.size() == 2 ? QSize{parts[0].toInt(), parts[1].toInt()} : QSize{};
}

}  // namespace

QString windowDescription() {
    return QStringLiteral("Plans how a machine covers a farm field.");
}

QList<QCommandLineOption> windowOptions() {
    return {
        {kFieldId, QStringLiteral("The field of FILE: its id, name or number."), QStringLiteral("ID")},
        {kSelfTest, QStringLiteral("Go through every page and end.")},
        {kScreenshot, QStringLiteral("Save a picture of the window when it is ready and end."),
         QStringLiteral("PNG")},
        {kSize, QStringLiteral("Size of the window."), QStringLiteral("WxH")},
        {kTheme, QStringLiteral("light, dark or sunlight, this time only."), QStringLiteral("NAME")},
        {kLanguage, QStringLiteral("en, de, nl, fr, es, pt_BR or pt_PT, this time only."),
         QStringLiteral("CODE")},
        {kUnits, QStringLiteral("metric or imperial, this time only."), QStringLiteral("NAME")},
    };
}

std::expected<Arguments, int> argumentsOf(const QCoreApplication& application) {
    QCommandLineParser parser;
    parser.setApplicationDescription(windowDescription());
    // QCommandLineParser's own one comes with a second, for options that only process() can list.
    const QCommandLineOption help{{QStringLiteral("h"), QStringLiteral("help")},
                                  QStringLiteral("Displays help on commandline options.")};
    parser.addOption(help);
    const QCommandLineOption version = parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("file"), QStringLiteral("Project or boundary file to open."),
                                 QStringLiteral("[FILE]"));
    parser.addOptions(windowOptions());
    // QCommandLineParser::process would end the program in the midst of everything that main has begun.
    if (!parser.parse(application.arguments())) {
        std::fprintf(stderr, "furrow: %s\n", qPrintable(parser.errorText()));
        return std::unexpected(1);
    }
    if (parser.isSet(help)) {
        std::fputs(qPrintable(parser.helpText()), stdout);
        return std::unexpected(0);
    }
    if (parser.isSet(version)) {
        std::printf("%s %s\n", qPrintable(QCoreApplication::applicationName()),
                    qPrintable(QCoreApplication::applicationVersion()));
        return std::unexpected(0);
    }
    return Arguments{.file = parser.positionalArguments().value(0),
                     .fieldId = parser.value(kFieldId),
                     .screenshot = parser.value(kScreenshot),
                     .theme = parser.value(kTheme),
                     .language = parser.value(kLanguage),
                     .units = parser.value(kUnits),
                     .size = sizeFrom(parser.value(kSize)),
                     .selfTest = parser.isSet(kSelfTest)};
}

}  // namespace furrow
