#include "ui/files/native_dialog.h"

#include <QCoreApplication>
#include <QDir>
#include <QGuiApplication>
#include <QStringList>

#include <algorithm>

namespace furrow {

namespace {

/// Qt's plugin of a desktop, by the beginning of its file's name.
bool hasTheme(const QString& name) {
    const QStringList folders = QCoreApplication::libraryPaths();
    return std::ranges::any_of(folders, [&name](const QString& folder) {
        return !QDir{folder + QStringLiteral("/platformthemes")}
                    .entryList({name + QStringLiteral("*")}, QDir::Files)
                    .isEmpty();
    });
}

}  // namespace

bool desktopHasFileDialog() {
#ifdef Q_OS_LINUX
    const QString platform = QGuiApplication::platformName();
    if (platform != QLatin1String("xcb") && !platform.startsWith(QLatin1String("wayland"))) {
        return false;
    }
    const QString theme = qEnvironmentVariable("QT_QPA_PLATFORMTHEME").section(u':', 0, 0);
    const QString desktop = theme.isEmpty() ? qEnvironmentVariable("XDG_CURRENT_DESKTOP").toLower() : theme;
    const auto isOne = [&desktop](const QStringList& names) {
        const QStringList given = desktop.split(u':');
        return std::ranges::any_of(names, [&given](const QString& name) { return given.contains(name); });
    };
    if (qEnvironmentVariableIsSet("FLATPAK_ID") || qEnvironmentVariableIsSet("SNAP") ||
        isOne({QStringLiteral("xdgdesktopportal")})) {
        return hasTheme(QStringLiteral("libqxdgdesktopportal"));
    }
    if (isOne({QStringLiteral("kde")})) {
        return hasTheme(QStringLiteral("KDEPlasmaPlatformTheme"));
    }
    return isOne({QStringLiteral("gtk3"), QStringLiteral("gnome"), QStringLiteral("ubuntu"),
                  QStringLiteral("unity"), QStringLiteral("xfce"), QStringLiteral("mate"),
                  QStringLiteral("x-cinnamon"), QStringLiteral("cinnamon"), QStringLiteral("lxde"),
                  QStringLiteral("pantheon")}) &&
           hasTheme(QStringLiteral("libqgtk3"));
#else
    return true;
#endif
}

}  // namespace furrow
