// `furrow-cli bench paper` as a whole: one run, its summary and its files.

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

class TestBenchCli : public QObject {
    Q_OBJECT

    static int furrow(const QStringList& arguments, QByteArray& out) {
        QProcess process;
        process.start(QStringLiteral(FURROW_BINARY_DIR "/furrow-cli"), arguments);
        process.waitForFinished(300'000);
        out = process.readAllStandardOutput();
        return process.exitCode();
    }

private slots:
    void everyStatementOfThePaper() {
        const QTemporaryDir folder;
        QByteArray out;
        QCOMPARE(furrow({"bench", "paper", "--json", "--out", folder.path()}, out), 0);
        const QJsonArray experiments = QJsonDocument::fromJson(out).object()["experiments"].toArray();
        QCOMPARE(experiments.size(), 4);
        int files = 1;  // summary.txt
        for (int i = 0; i < 4; ++i) {
            const QJsonObject experiment = experiments[i].toObject();
            QCOMPARE(experiment["number"].toInt(), i + 1);
            QVERIFY(!experiment["statements"].toArray().isEmpty() ||
                    !experiment["notes"].toArray().isEmpty());
            for (const QJsonValue& file : experiment["files"].toArray()) {
                QVERIFY(QFile::exists(folder.filePath(file.toString())));
                ++files;
            }
        }
        QCOMPARE(QDir{folder.path()}.entryList(QDir::Files).size(), files);
    }

    void whatDoesNotExistIsRefused() {
        QByteArray out;
        QCOMPARE(furrow({"bench"}, out), 2);
        QCOMPARE(furrow({"bench", "moon"}, out), 2);
        QCOMPARE(furrow({"bench", "paper", "--fields", "/nowhere.geojson"}, out), 4);
        QVERIFY(out.isEmpty());
    }
};

QTEST_GUILESS_MAIN(TestBenchCli)
#include "tst_bench_cli.moc"
