#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>

// The layers of the planner are the order of FURROW_PLANNER_LAYERS: a folder may include those before it.
class LayersTest : public QObject {
    Q_OBJECT

    QStringList layers_;

private slots:
    void initTestCase() {
        QFile file{QStringLiteral(FURROW_SOURCE_DIR "/planner/CMakeLists.txt")};
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QRegularExpression list{QStringLiteral("set\\(FURROW_PLANNER_LAYERS\\s+([^)]*)\\)")};
        const auto match = list.match(QString::fromUtf8(file.readAll()));
        QVERIFY(match.hasMatch());
        layers_ = match.captured(1).split(QRegularExpression{QStringLiteral("\\s+")}, Qt::SkipEmptyParts);
        QVERIFY(layers_.size() >= 15);
    }

    void everyFolderIsALayer() {
        const auto folders = QDir{QStringLiteral(FURROW_SOURCE_DIR "/planner")}.entryList(QDir::Dirs | QDir::NoDotAndDotDot);
        for (const QString& folder : folders) {
            QVERIFY2(layers_.contains(folder), qPrintable(folder));
        }
        QCOMPARE(folders.size(), layers_.size());
    }

    void includesPointUpwards() {
        const QRegularExpression include{QStringLiteral("^\\s*#\\s*include\\s*[\"<]([^\">]+)[\">]"),
                                         QRegularExpression::MultilineOption};
        QStringList wrong;
        int seen = 0;
        QDirIterator files{QStringLiteral(FURROW_SOURCE_DIR "/planner"), {"*.h", "*.cpp"}, QDir::Files,
                           QDirIterator::Subdirectories};
        while (files.hasNext()) {
            QFile file{files.next()};
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QString path = file.fileName().mid(QStringLiteral(FURROW_SOURCE_DIR "/").size());
            const qsizetype own = layers_.indexOf(path.section('/', 1, 1));
            auto matches = include.globalMatch(QString::fromUtf8(file.readAll()));
            while (matches.hasNext()) {
                const QString target = matches.next().captured(1);
                ++seen;
                if (target.startsWith("planner/")) {
                    const QString layer = target.section('/', 1, 1);
                    // planner/version.h belongs to no layer.
                    const bool allowed = layer == "version.h" || (layers_.contains(layer) && layers_.indexOf(layer) <= own);
                    if (!allowed) {
                        wrong << path + " includes " + target;
                    }
                } else if (target.startsWith("ui/") || target.startsWith("app/") || target.startsWith("tests/") ||
                           target.startsWith("Qt") ||
                           QRegularExpression{QStringLiteral("^Q[A-Z]")}.match(target).hasMatch()) {
                    wrong << path + " includes " + target;
                }
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
        QVERIFY(seen > 100);
    }

    // The audit shares no code with the stages it checks.
    void auditStandsAlone() {
        const QStringList allowed{"planner/core/", "planner/units/", "planner/jobs/", "planner/geometry/", "planner/audit/",
                                  "planner/machine/machine.h", "planner/path/path.h", "planner/path/finding.h"};
        const QRegularExpression include{QStringLiteral("#include \"(planner/[^\"]+)\"")};
        QStringList wrong;
        QDirIterator files{QStringLiteral(FURROW_SOURCE_DIR "/planner/audit"), {"*.h", "*.cpp"}, QDir::Files};
        while (files.hasNext()) {
            QFile file{files.next()};
            QVERIFY(file.open(QIODevice::ReadOnly));
            auto matches = include.globalMatch(QString::fromUtf8(file.readAll()));
            while (matches.hasNext()) {
                const QString target = matches.next().captured(1);
                if (std::ranges::none_of(allowed, [&](const QString& prefix) { return target.startsWith(prefix); })) {
                    wrong << file.fileName() + " includes " + target;
                }
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }

    // The heavy libraries stay behind the one layer that wraps them.
    void librariesStayWrapped_data() {
        QTest::addColumn<QString>("header");
        QTest::addColumn<QStringList>("allowed");
        QTest::newRow("GEOS") << "geos_c.h" << QStringList{"geometry"};
        QTest::newRow("PROJ") << "proj.h" << QStringList{"geodesy"};
        QTest::newRow("PROJ's geodesics") << "geodesic.h" << QStringList{"geodesy"};
        QTest::newRow("oneTBB") << "tbb/" << QStringList{"jobs"};
        QTest::newRow("GDAL") << "gdal" << QStringList{"io", "imagery"};
    }
    void librariesStayWrapped() {
        QFETCH(QString, header);
        QFETCH(QStringList, allowed);
        QStringList wrong;
        QDirIterator files{QStringLiteral(FURROW_SOURCE_DIR "/planner"), {"*.h", "*.cpp"}, QDir::Files,
                           QDirIterator::Subdirectories};
        while (files.hasNext()) {
            QFile file{files.next()};
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QString path = file.fileName().mid(QStringLiteral(FURROW_SOURCE_DIR "/").size());
            for (const QString& line : QString::fromUtf8(file.readAll()).split('\n')) {
                if (line.startsWith("#include <") && line.contains(header) &&
                    !allowed.contains(path.section('/', 1, 1))) {
                    wrong << path + ": " + line;
                }
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }
};

QTEST_APPLESS_MAIN(LayersTest)
#include "tst_layers.moc"
