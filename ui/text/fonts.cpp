#include "ui/text/fonts.h"

#include <QDir>
#include <QFontDatabase>

namespace furrow {

void loadFonts() {
    const QDir fonts{QStringLiteral(":/furrow/fonts")};
    for (const QString& file : fonts.entryList()) {
        QFontDatabase::addApplicationFont(fonts.filePath(file));
    }
}

}  // namespace furrow
