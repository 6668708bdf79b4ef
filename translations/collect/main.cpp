// Writes every text of the planner into a file for lupdate: collect-texts PROJECT FILE.

#include "translations/collect/planner_texts.h"

#include <QFile>

#include <cstdio>

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fputs("usage: collect-texts PROJECT FILE\n", stderr);
        return 2;
    }
    const QMap<QString, bool> texts = furrow::plannerTexts(QString::fromLocal8Bit(argv[1]));
    QString list = QStringLiteral("#include <QtGlobal>\n\nstatic const char* const kPlannerTexts[] = {\n");
    for (auto each = texts.begin(); each != texts.end(); ++each) {
        QString escaped = each.key();
        escaped.replace(QLatin1String{"\\"}, QLatin1String{"\\\\"})
            .replace(QLatin1String{"\""}, QLatin1String{"\\\""});
        list += QStringLiteral("    %1(\"Planner\", \"%2\"),\n")
                    .arg(QLatin1String{each.value() ? "QT_TRANSLATE_N_NOOP" : "QT_TRANSLATE_NOOP"}, escaped);
    }
    list += QStringLiteral("};\n");
    QFile file{QString::fromLocal8Bit(argv[2])};
    if (!file.open(QIODevice::WriteOnly) || file.write(list.toUtf8()) < 0) {
        std::fprintf(stderr, "%s cannot be written\n", argv[2]);
        return 1;
    }
    return 0;
}
