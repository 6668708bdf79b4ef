#include "ui/shell/window_tools.h"

#include "ui/text/display.h"
#include "ui/text/fonts.h"

#include <QFont>
#include <QGuiApplication>
#include <QIcon>
#include <QQuickStyle>
#include <QQuickWindow>
#include <QSettings>

namespace furrow {

void applyScale() {
    const int percent = QSettings{QStringLiteral("Furrow"), QStringLiteral("Furrow")}
                            .value(QStringLiteral("window/scale"), 100)
                            .toInt();
    if (qEnvironmentVariableIsEmpty("QT_SCALE_FACTOR") && percent > 100 && percent <= 300) {
        qputenv("QT_SCALE_FACTOR", QByteArray::number(percent / 100.0));
    }
}

void nameProgram() {
    QCoreApplication::setOrganizationName(QStringLiteral("Furrow"));
    QCoreApplication::setApplicationName(QStringLiteral("Furrow"));
    QCoreApplication::setApplicationVersion(QStringLiteral(FURROW_VERSION));
}

void prepareWindow() {
    nameProgram();
    QGuiApplication::setApplicationDisplayName(QStringLiteral("Furrow"));
    // By it a desktop finds name and icon of the window.
    QGuiApplication::setDesktopFileName(QStringLiteral("org.furrow.furrow"));
    QGuiApplication::setWindowIcon(QIcon{QStringLiteral(":/furrow/desktop/furrow-128.png")});
    // Glyphs from a picture: as sharp as in other programs, and cheaper than outlines where there is no
    // graphics card.
    QQuickWindow::setTextRenderType(QQuickWindow::NativeTextRendering);
    QQuickStyle::setStyle(QStringLiteral("Fusion"));
    loadFonts();
    Display::instance();
    QFont font{QStringLiteral("Inter")};
    font.setPixelSize(13);
    QGuiApplication::setFont(font);
}

}  // namespace furrow
