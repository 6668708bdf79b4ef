#include "translations/collect/source_texts.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>

namespace furrow {

const QString kLiteral = QString::fromUtf8("\"(?:[^\"\\\\\\n]|\\\\.)*\"(?:\\s*\"(?:[^\"\\\\\\n]|\\\\.)*\")*");

QString joined(const QString& literal) {
    static const QRegularExpression piece{QString::fromUtf8("\"((?:[^\"\\\\\\n]|\\\\.)*)\"")};
    QString text;
    for (auto each = piece.globalMatch(literal); each.hasNext();) {
        text += each.next().captured(1);
    }
    return text.replace(QStringLiteral("\\\""), QStringLiteral("\""))
        .replace(QStringLiteral("\\\\"), QStringLiteral("\\"));
}

QString textOf(const QString& path) {
    QFile file{path};
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString{};
}

QString codeOf(const QString& path) {
    QString text = textOf(path);
    text.remove(QRegularExpression{QString::fromUtf8("^\\s*#.*$"), QRegularExpression::MultilineOption});
    text.replace(QRegularExpression{QString::fromUtf8("R\"(\\w*)\\(.*?\\)\\1\""),
                                    QRegularExpression::DotMatchesEverythingOption},
                 QStringLiteral("\"\""));
    text.remove(QRegularExpression{QString::fromUtf8("(?<![:\"])//[^\\n]*")});
    return text;
}

QStringList filesIn(const QString& folder, const QStringList& names) {
    QStringList files;
    QDirIterator each{folder, names, QDir::Files, QDirIterator::Subdirectories};
    while (each.hasNext()) {
        files << each.next();
    }
    files.sort();
    return files;
}

}  // namespace furrow
