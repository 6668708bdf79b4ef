#include "app/window/screenshot.h"
#include "app/window/self_test.h"
#include "ui/shell/session.h"
#include "ui/shell/window_tools.h"
#include "ui/text/display.h"

#include <QCommandLineParser>
#include <QGuiApplication>
#include <QQmlApplicationEngine>
#include <QQuickWindow>
#include <QStandardPaths>

#include <algorithm>
#include <cstdio>

namespace {

struct Arguments {
    QString file;
    QString fieldId;
    QString screenshot;
    QString theme;
    QString language;
    QString units;
    QSize size;
    bool selfTest = false;
};

QSize sizeFrom(const QString& text) {
    const QStringList parts = text.split(QLatin1Char('x'));
    return parts.size() == 2 ? QSize{parts[0].toInt(), parts[1].toInt()} : QSize{};
}

Arguments argumentsOf(const QGuiApplication& application) {
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Plans how a machine covers a farm field."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("file"), QStringLiteral("Boundary file to open."),
                                 QStringLiteral("[FILE]"));
    const QCommandLineOption fieldId{QStringLiteral("field-id"),
                                     QStringLiteral("The field of FILE: its id, name or number."),
                                     QStringLiteral("ID")};
    const QCommandLineOption selfTest{QStringLiteral("self-test"),
                                      QStringLiteral("Go through every page and end.")};
    const QCommandLineOption screenshot{
        QStringLiteral("screenshot"),
        QStringLiteral("Save a picture of the window when it is ready and end."), QStringLiteral("PNG")};
    const QCommandLineOption size{QStringLiteral("size"), QStringLiteral("Size of the window."),
                                  QStringLiteral("WxH")};
    const QCommandLineOption theme{QStringLiteral("colours"),
                                   QStringLiteral("light, dark or sunlight, this time only."),
                                   QStringLiteral("NAME")};
    const QCommandLineOption language{QStringLiteral("language"),
                                      QStringLiteral("en, de, nl, fr, es, pt_BR or pt_PT, this time only."),
                                      QStringLiteral("CODE")};
    const QCommandLineOption units{QStringLiteral("units"),
                                   QStringLiteral("metric or imperial, this time only."),
                                   QStringLiteral("NAME")};
    parser.addOptions({fieldId, selfTest, screenshot, size, theme, language, units});
    parser.process(application);
    return {.file = parser.positionalArguments().value(0),
            .fieldId = parser.value(fieldId),
            .screenshot = parser.value(screenshot),
            .theme = parser.value(theme),
            .language = parser.value(language),
            .units = parser.value(units),
            .size = sizeFrom(parser.value(size)),
            .selfTest = parser.isSet(selfTest)};
}

/// As Theme.Mode; 0 is what the system says.
int themeMode(const QString& name) {
    return static_cast<int>(
        QStringList{QString{}, QStringLiteral("light"), QStringLiteral("dark"), QStringLiteral("sunlight")}
            .indexOf(name));
}

}  // namespace

int main(int argc, char* argv[]) {
    furrow::applyScale();
    QGuiApplication application{argc, argv};
    furrow::prepareWindow();
    const Arguments arguments = argumentsOf(application);
    if (arguments.selfTest) {
        furrow::countMessages();
    }

    furrow::Display::instance().force(
        arguments.language,
        static_cast<furrow::Display::Units>(std::max<qsizetype>(
            QStringList{QString{}, QStringLiteral("metric"), QStringLiteral("imperial")}.indexOf(
                arguments.units),
            0)));
    furrow::Session session;
    QQmlApplicationEngine engine;
    const bool forPeople = arguments.screenshot.isEmpty() && !arguments.selfTest;
    engine.setInitialProperties({{QStringLiteral("session"), QVariant::fromValue(&session)},
                                 {QStringLiteral("offersTour"), forPeople && arguments.file.isEmpty()}});
    engine.loadFromModule("Furrow.Shell", "Main");
    auto* window =
        engine.rootObjects().isEmpty() ? nullptr : qobject_cast<QQuickWindow*>(engine.rootObjects().first());
    if (window == nullptr) {
        std::fputs("furrow: the window cannot be made\n", stderr);
        return 1;
    }
    if (!arguments.size.isEmpty()) {
        window->resize(arguments.size);
    }
    if (const int mode = themeMode(arguments.theme); mode > 0) {
        if (auto* theme = engine.singletonInstance<QObject*>("Furrow.Controls", "Theme")) {
            theme->setProperty("forced", mode);
        }
    }
    if (forPeople) {
        session.keepIn(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation));
    }
    if (!arguments.file.isEmpty()) {
        session.opener()->open(arguments.file, arguments.fieldId);
    } else if (forPeople) {
        session.files()->recover();
    }
    if (!arguments.screenshot.isEmpty()) {
        furrow::saveScreenshotWhenReady(*window, session, arguments.screenshot);
    }
    if (arguments.selfTest) {
        furrow::runSelfTest(*window, session);
    }
    return QGuiApplication::exec();
}
