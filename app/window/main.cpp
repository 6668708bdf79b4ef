#include "app/window/arguments.h"
#include "app/window/screenshot.h"
#include "app/window/self_test.h"
#include "ui/shell/session.h"
#include "ui/shell/window_tools.h"
#include "ui/text/display.h"

#include <QGuiApplication>
#include <QQmlApplicationEngine>
#include <QQuickWindow>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <span>
#include <string_view>

namespace {

/// As Theme.Mode; 0 is what the system says.
int themeMode(const QString& name) {
    return static_cast<int>(
        QStringList{QString{}, QStringLiteral("light"), QStringLiteral("dark"), QStringLiteral("sunlight")}
            .indexOf(name));
}

/// Help and version are words, which need no display.
bool asksForWords(std::span<char* const> arguments) {
    return std::ranges::any_of(arguments, [](std::string_view each) {
        return each == "-h" || each == "--help" || each == "-v" || each == "--version";
    });
}

}  // namespace

int main(int argc, char* argv[]) {
    if (asksForWords(std::span{argv, static_cast<std::size_t>(argc)})) {
        const QCoreApplication words{argc, argv};
        furrow::nameProgram();
        return furrow::argumentsOf(words).error_or(0);
    }
    furrow::applyScale();
    QGuiApplication application{argc, argv};
    furrow::prepareWindow();
    const auto given = furrow::argumentsOf(application);
    if (!given) {
        return given.error();
    }
    const furrow::Arguments& arguments = *given;
    if (arguments.selfTest) {
        furrow::countMessages();
    }

    const bool forPeople = arguments.screenshot.isEmpty() && !arguments.selfTest;
    // What nobody looks at must not change the size and the colours that the user comes back to.
    std::optional<QTemporaryDir> ownSettings;
    if (!forPeople) {
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, ownSettings.emplace().path());
    }
    furrow::Display::instance().force(
        arguments.language,
        static_cast<furrow::Display::Units>(std::max<qsizetype>(
            QStringList{QString{}, QStringLiteral("metric"), QStringLiteral("imperial")}.indexOf(
                arguments.units),
            0)));
    furrow::Session session;
    QQmlApplicationEngine engine;
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
