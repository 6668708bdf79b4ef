#include "ui/shell/window_tools.h"

#include "ui/text/display.h"

#include <QDir>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QQuickStyle>

namespace furrow {

void prepareWindow() {
    QCoreApplication::setOrganizationName(QStringLiteral("Furrow"));
    QCoreApplication::setApplicationName(QStringLiteral("Furrow"));
    QGuiApplication::setApplicationDisplayName(QStringLiteral("Furrow"));
    QCoreApplication::setApplicationVersion(QStringLiteral(FURROW_VERSION));
    QQuickStyle::setStyle(QStringLiteral("Fusion"));
    const QDir fonts{QStringLiteral(":/furrow/fonts")};
    for (const QString& file : fonts.entryList()) {
        QFontDatabase::addApplicationFont(fonts.filePath(file));
    }
    Display::instance();
    QFont font{QStringLiteral("Inter")};
    font.setPixelSize(13);
    QGuiApplication::setFont(font);
}

}  // namespace furrow
