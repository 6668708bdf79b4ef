// Files that were made to take all memory or to keep the reader for ever, and good ones that looked like
// them.
#include "planner/gdal/system_files.h"
#include "planner/gdal/zip.h"
#include "planner/io/import/field_reader.h"
#include "tests/support/furrow_cli.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <sqlite3.h>

using namespace furrow;

namespace {

const std::string kTaskData =
    R"(<?xml version="1.0"?><ISO11783_TaskData VersionMajor="4" VersionMinor="3" DataTransferOrigin="1">)"
    R"(<PFD A="PFD1" C="North" D="0"><PLN A="1"><LSG A="1"><PNT A="2" C="52.0" D="9.0"/>)"
    R"(<PNT A="2" C="52.0" D="9.003"/><PNT A="2" C="52.002" D="9.003"/><PNT A="2" C="52.002" D="9.0"/>)"
    R"(</LSG></PLN></PFD></ISO11783_TaskData>)";

/// Other than blanks and zeros, so that it shrinks no more than text does.
std::string filler(std::size_t bytes) {
    std::string text;
    text.reserve(bytes);
    for (std::uint32_t value = 1; text.size() < bytes; value = value * 1664525 + 1013904223) {
        text += std::string(15, ' ') + static_cast<char>('a' + (value >> 24) % 26);
    }
    return text;
}

std::string written(const QTemporaryDir& folder, const QString& name, const std::string& bytes) {
    return test::writeFile(folder.filePath(name), QByteArray::fromStdString(bytes)).toStdString();
}

/// A GeoPackage of the sample field, changed by these commands.
std::string geoPackage(const QTemporaryDir& folder, const std::vector<std::string>& commands) {
    const QString file = folder.filePath("f.gpkg");
    if (test::furrowCli({"convert", test::sampleField("slanted_field"), file}).status != 0) {
        qFatal("no GeoPackage was made");
    }
    sqlite3* database = nullptr;
    sqlite3_open(file.toStdString().c_str(), &database);
    for (const std::string& command : commands) {
        char* why = nullptr;
        if (sqlite3_exec(database, command.c_str(), nullptr, nullptr, &why) != SQLITE_OK) {
            qFatal("%s: %s", command.c_str(), why);
        }
    }
    sqlite3_close(database);
    return file.toStdString();
}

const std::string kEndless = " AS WITH RECURSIVE r(n) AS (SELECT 1 UNION ALL SELECT n + 1 FROM r) ";

}  // namespace

class TestHostileFiles : public QObject {
    Q_OBJECT
private slots:
    void viewsAreRefused_data() {
        QTest::addColumn<QStringList>("commands");
        QTest::addColumn<bool>("refused");
        const auto row = [](const char* name, const QStringList& commands, bool refused) {
            QTest::newRow(name) << commands << refused;
        };
        const QString endless = QString::fromStdString(kEndless);
        row("none", {}, false);
        row("one beside the layers", {"CREATE VIEW mine" + endless + "SELECT n FROM r"}, false);
        row("as a layer",
            {"CREATE VIEW Fields2" + endless + "SELECT n AS fid, NULL AS geom FROM r WHERE n < 0",
             "INSERT INTO gpkg_contents(table_name, data_type, identifier, srs_id) VALUES ('fields2', "
             "'features', 'x', 4326)",
             "INSERT INTO gpkg_geometry_columns VALUES ('fields2', 'geom', 'POLYGON', 4326, 0, 0)"},
            true);
        row("as the list of layers",
            {"ALTER TABLE gpkg_contents RENAME TO contents",
             "CREATE VIEW gpkg_contents" + endless + "SELECT c.* FROM contents c, r WHERE n < 0"},
            true);
    }
    void viewsAreRefused() {
        QFETCH(QStringList, commands);
        QFETCH(bool, refused);
        const QTemporaryDir folder;
        std::vector<std::string> all;
        for (const QString& command : commands) {
            all.push_back(command.toStdString());
        }
        const std::string file = geoPackage(folder, all);
        const std::string bytes = test::contentsOf(QString::fromStdString(file)).toStdString();
        const std::vector<FileInMemory> inZip{{"a/f.gpkg", bytes}};
        for (const std::string& path : {file, written(folder, "f.zip", zipOf(inZip).value())}) {
            const auto read = readFields(path);
            QCOMPARE(read.has_value(), !refused);
            if (refused) {
                QVERIFY2(read.error().what.contains("is a view"), read.error().line().c_str());
            }
        }
    }

    void taskDataHasALimit() {
        const QTemporaryDir folder;
        std::string comment = kTaskData;
        comment.insert(comment.size() - 20, "<!--" + filler(kLargestFieldXml) + "-->");
        const std::vector<FileInMemory> files{{"TASKDATA/TASKDATA.XML", comment}};
        const auto read = readFields(written(folder, "t.zip", zipOf(files).value()));
        QVERIFY(!read);
        QVERIFY(read.error().code == ErrorCode::InputRefused);
        QVERIFY2(read.error().what.contains("may take 128 MiB"), read.error().line().c_str());
    }
    void mapsHaveALimit() {
        const QTemporaryDir folder;
        const std::vector<FileInMemory> files{
            {"doc.kml", R"(<?xml version="1.0"?><kml xmlns="http://www.opengis.net/kml/2.2"><!--)" +
                            filler(kLargestFieldXml) + "--></kml>"}};
        const auto read = readFields(written(folder, "t.kmz", zipOf(files).value()));
        QVERIFY(!read);
        QVERIFY2(read.error().what.contains("may take 128 MiB"), read.error().line().c_str());
    }
    // What a zip states of its files is what is unpacked at most.
    void aWholeZipHasALimit() {
        const QTemporaryDir folder;
        std::string noise;
        for (std::uint32_t value = 1; noise.size() < std::size_t{8} << 20;
             value = value * 1664525 + 1013904223) {
            noise += static_cast<char>(value >> 24);
        }
        const std::vector<FileInMemory> files{{"TASKDATA/TASKDATA.XML", kTaskData},
                                              {"TASKDATA/GRD1.bin", noise}};
        std::string zip = zipOf(files).value();
        VERIFY_RESULT(readFields(written(folder, "good.zip", zip)));
        // The length before packing, in the last entry of the directory.
        zip.replace(zip.rfind("PK\x01\x02") + 24, 4, std::string{"\0\0\0\x84", 4});
        const auto read = readFields(written(folder, "t.zip", zip));
        QVERIFY(!read);
        QVERIFY2(read.error().what.contains("more than 2 GiB"), read.error().line().c_str());
    }

    // Sticks are packed with all the folders that they lie in.
    void taskDataMayLieDeep() {
        const QTemporaryDir folder;
        const std::vector<FileInMemory> files{{"1/2/3/4/5/6/7/8/TASKDATA/TASKDATA.XML", kTaskData}};
        const auto read = readFields(written(folder, "t.zip", zipOf(files).value()));
        VERIFY_RESULT(read);
        QCOMPARE(read->fields.front().field.name, std::string{"North"});
    }
    void namesMayHoldBraces_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"a{b", "a}b", "}{", "{a}", "a.zip"}) {
            QTest::newRow(name) << name;
        }
    }
    void namesMayHoldBraces() {
        QFETCH(QString, name);
        const QTemporaryDir folder;
        QDir{folder.path()}.mkdir(name);
        const std::vector<FileInMemory> files{{"TASKDATA/TASKDATA.XML", kTaskData}};
        const std::string zip = zipOf(files).value();
        for (const QString& file : {name + "/t.zip", name + "/" + name + ".zip"}) {
            const auto read = readFields(written(folder, file, zip));
            VERIFY_RESULT(read);
            QCOMPARE(read->fields.size(), std::size_t{1});
        }
    }
};

FURROW_TEST(TestHostileFiles);
#include "tst_hostile_files.moc"
