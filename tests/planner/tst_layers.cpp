#include "tests/support/test_program.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include <algorithm>

// The layers of the planner are the order of FURROW_PLANNER_LAYERS: a folder may include those before it.
class LayersTest : public QObject {
    Q_OBJECT

    static inline const QString kOtherFormats = QStringLiteral("formats/*");

    QStringList layers_;
    QStringList uiRooms_;
    QStringList ioRooms_;

    static QString textOf(const QString& path) {
        QFile file{path};
        return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString{};
    }
    /// The names behind a word up to the end of its bracket or line.
    static QStringList namesIn(const QString& text, const QString& pattern) {
        const auto match = QRegularExpression{pattern}.match(text);
        return match.captured(1).split(QRegularExpression{QStringLiteral("\\s+")}, Qt::SkipEmptyParts);
    }
    /// Other rooms that a room's C++ includes and its QML imports.
    static QStringList usedBy(const QString& room) {
        const QRegularExpression use{QStringLiteral("^(?:#include \"ui/(\\w+)/|import Furrow\\.(\\w+))"),
                                     QRegularExpression::MultilineOption};
        QSet<QString> used;
        QDirIterator files{
            QStringLiteral(FURROW_SOURCE_DIR "/ui/") + room, {"*.h", "*.cpp", "*.qml"}, QDir::Files};
        while (files.hasNext()) {
            for (auto each = use.globalMatch(textOf(files.next())); each.hasNext();) {
                const auto match = each.next();
                used << (match.captured(1) + match.captured(2)).toLower();
            }
        }
        used.remove(room);
        QStringList sorted = used.values();
        sorted.sort();
        return sorted;
    }

    /// The words of a list in a CMakeLists.txt, without its comments.
    static QStringList listIn(const char* path, const char* name) {
        QFile file{QStringLiteral(FURROW_SOURCE_DIR "/") + QLatin1StringView{path}};
        QString text = file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString{};
        text.remove(QRegularExpression{QStringLiteral("#[^\n]*")});
        const QRegularExpression list{QStringLiteral("set\\(%1\\s+([^)]*)\\)").arg(QLatin1StringView{name})};
        return list.match(text).captured(1).split(QRegularExpression{QStringLiteral("\\s+")},
                                                  Qt::SkipEmptyParts);
    }

    /// "formats/csv" of "planner/io/formats/csv/csv.h"; empty for what is in no room.
    static QString roomOf(const QString& path) {
        const QString below = path.section('/', 2, -2);
        return path.startsWith(QStringLiteral("planner/io/"))
                   ? below.section('/', 0, below.startsWith(QStringLiteral("formats/")) ? 1 : 0)
                   : QString{};
    }

    /// The place of a room of io in the list of rooms; -1 for none.
    qsizetype rankOf(const QString& room) const {
        const qsizetype own = ioRooms_.indexOf(room);
        return own < 0 && room.startsWith(QStringLiteral("formats/")) ? ioRooms_.indexOf(kOtherFormats) : own;
    }

private slots:
    void initTestCase() {
        layers_ = listIn("planner/CMakeLists.txt", "FURROW_PLANNER_LAYERS");
        QVERIFY(layers_.size() >= 15);
        uiRooms_ = listIn("ui/CMakeLists.txt", "FURROW_UI_ROOMS");
        QVERIFY(uiRooms_.size() >= 10);
        ioRooms_ = listIn("planner/CMakeLists.txt", "FURROW_IO_ROOMS");
        QVERIFY(ioRooms_.size() >= 10);
    }

    void everyFolderIsALayer() {
        const auto folders =
            QDir{QStringLiteral(FURROW_SOURCE_DIR "/planner")}.entryList(QDir::Dirs | QDir::NoDotAndDotDot);
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
        QDirIterator files{QStringLiteral(FURROW_SOURCE_DIR "/planner"),
                           {"*.h", "*.cpp"},
                           QDir::Files,
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
                    const bool allowed =
                        layer == "version.h" || (layers_.contains(layer) && layers_.indexOf(layer) <= own);
                    if (!allowed) {
                        wrong << path + " includes " + target;
                    }
                } else if (target.startsWith("ui/") || target.startsWith("app/") ||
                           target.startsWith("tests/") || target.startsWith("Qt") ||
                           QRegularExpression{QStringLiteral("^Q[A-Z]")}.match(target).hasMatch()) {
                    wrong << path + " includes " + target;
                }
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
        QVERIFY(seen > 100);
    }

    void everyFolderOfIoIsARoom() {
        QSet<QString> found;
        QDirIterator files{QStringLiteral(FURROW_SOURCE_DIR "/planner/io"),
                           {"*.h", "*.cpp"},
                           QDir::Files,
                           QDirIterator::Subdirectories};
        while (files.hasNext()) {
            const QString room = roomOf(files.next().mid(QStringLiteral(FURROW_SOURCE_DIR "/").size()));
            QVERIFY2(rankOf(room) >= 0, qPrintable(files.filePath()));
            found << room;
        }
        for (const QString& room : ioRooms_) {
            QVERIFY2(room == kOtherFormats || found.contains(room), qPrintable(room));
        }
    }

    void roomsOfIoIncludeUpwards() {
        const QRegularExpression include{QStringLiteral("#include \"(planner/io/[^\"]+)\"")};
        QStringList wrong;
        QDirIterator files{QStringLiteral(FURROW_SOURCE_DIR "/planner/io"),
                           {"*.h", "*.cpp"},
                           QDir::Files,
                           QDirIterator::Subdirectories};
        while (files.hasNext()) {
            QFile file{files.next()};
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QString path = file.fileName().mid(QStringLiteral(FURROW_SOURCE_DIR "/").size());
            auto matches = include.globalMatch(QString::fromUtf8(file.readAll()));
            while (matches.hasNext()) {
                const QString target = matches.next().captured(1);
                const qsizetype rank = rankOf(roomOf(target));
                if (rank > rankOf(roomOf(path)) ||
                    (rank == rankOf(roomOf(path)) && roomOf(target) != roomOf(path))) {
                    wrong << path + " includes " + target;
                }
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }

    // The rooms of the window are the order of FURROW_UI_ROOMS: a room may use those before it, so there is
    // no circle.
    void everyFolderOfTheWindowIsARoom() {
        QStringList folders =
            QDir{QStringLiteral(FURROW_SOURCE_DIR "/ui")}.entryList(QDir::Dirs | QDir::NoDotAndDotDot);
        QStringList rooms = uiRooms_;
        folders.sort();
        rooms.sort();
        QCOMPARE(folders, rooms);
    }
    void roomsUseThoseBeforeThem() {
        QStringList wrong;
        for (const QString& room : uiRooms_) {
            for (const QString& used : usedBy(room)) {
                if (uiRooms_.indexOf(used) < 0 || uiRooms_.indexOf(used) > uiRooms_.indexOf(room)) {
                    wrong << room + " uses " + used;
                }
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }
    void roomsNameWhatTheyUse_data() {
        QTest::addColumn<QString>("room");
        for (const QString& room : uiRooms_) {
            QTest::newRow(qPrintable(room)) << room;
        }
    }
    void roomsNameWhatTheyUse() {
        QFETCH(QString, room);
        QStringList named =
            namesIn(textOf(QStringLiteral(FURROW_SOURCE_DIR "/ui/%1/CMakeLists.txt").arg(room)),
                    QStringLiteral("\\bUSES ([^\\n]*)"));
        named.sort();
        QCOMPARE(named, usedBy(room));
    }

    // The audit shares no code with the stages it checks.
    void auditStandsAlone() {
        const QStringList allowed{"planner/core/",       "planner/units/",        "planner/jobs/",
                                  "planner/geometry/",   "planner/audit/",        "planner/machine/machine.h",
                                  "planner/path/path.h", "planner/path/finding.h"};
        const QRegularExpression include{QStringLiteral("#include \"(planner/[^\"]+)\"")};
        QStringList wrong;
        QDirIterator files{QStringLiteral(FURROW_SOURCE_DIR "/planner/audit"), {"*.h", "*.cpp"}, QDir::Files};
        while (files.hasNext()) {
            QFile file{files.next()};
            QVERIFY(file.open(QIODevice::ReadOnly));
            auto matches = include.globalMatch(QString::fromUtf8(file.readAll()));
            while (matches.hasNext()) {
                const QString target = matches.next().captured(1);
                if (std::ranges::none_of(allowed,
                                         [&](const QString& prefix) { return target.startsWith(prefix); })) {
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
        // Timings have plain GEOS as their yardstick.
        QTest::newRow("GEOS") << "geos_c.h" << QStringList{"geometry", "benchmarks"};
        QTest::newRow("PROJ") << "proj.h" << QStringList{"geodesy"};
        QTest::newRow("PROJ's geodesics") << "geodesic.h" << QStringList{"geodesy"};
        QTest::newRow("oneTBB") << "tbb/" << QStringList{"jobs"};
        QTest::newRow("GDAL") << "<gdal" << QStringList{"gdal", "imagery"};
        QTest::newRow("GDAL's shapes") << "<ogr" << QStringList{"gdal", "imagery"};
        QTest::newRow("GDAL's files") << "<cpl_" << QStringList{"gdal", "imagery"};
    }
    void librariesStayWrapped() {
        QFETCH(QString, header);
        QFETCH(QStringList, allowed);
        QStringList wrong;
        QDirIterator files{QStringLiteral(FURROW_SOURCE_DIR "/planner"),
                           {"*.h", "*.cpp"},
                           QDir::Files,
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

    // A program holds all tests of a folder. The linker keeps one of two inline functions with the same name
    // and parameters, and the other tests call it too.
    void functionsOfTestHeadersAreUnlike() {
        static const QRegularExpression inlineFunction{
            QStringLiteral("^inline [^=(]*?\\b(\\w+)\\(([^{;]*)\\)[^){;]*\\{"),
            QRegularExpression::MultilineOption};
        static const QRegularExpression nameOrDefault{QStringLiteral("\\s*(\\b\\w+)?(\\s*=[^,]*)?\\s*(,|$)")};
        QMap<QString, QStringList> definedIn;
        QDirIterator files{
            QStringLiteral(FURROW_SOURCE_DIR "/tests"), {"*.h"}, QDir::Files, QDirIterator::Subdirectories};
        while (files.hasNext()) {
            const QString path = files.next();
            const QString text = textOf(path);
            for (auto each = inlineFunction.globalMatch(text); each.hasNext();) {
                const auto match = each.next();
                QString parameters = match.captured(2);
                parameters.replace(nameOrDefault, QStringLiteral(","));
                definedIn[match.captured(1) + '(' + parameters.simplified()].append(path.section('/', -2));
            }
        }
        QVERIFY(definedIn.size() > 50);
        QStringList wrong;
        for (const auto& [function, headers] : definedIn.asKeyValueRange()) {
            if (headers.size() > 1) {
                wrong << function + ") in " + headers.join(", ");
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }
};

FURROW_TEST(LayersTest);
#include "tst_layers.moc"
