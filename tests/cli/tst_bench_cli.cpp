// `furrow-cli bench paper` as a whole: one run, its summary and its files.

#include "tests/support/furrow_cli.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

using furrow::test::Answer;
using furrow::test::furrowCli;

class TestBenchCli : public QObject {
    Q_OBJECT

private slots:
    void everyStatementOfThePaper() {
        const QTemporaryDir folder;
        const Answer answer = furrowCli({"bench", "paper", "--json", "--out", folder.path()}, 300'000);
        QVERIFY2(answer.status == 0, answer.error);
        const QJsonArray experiments = answer.json()["experiments"].toArray();
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
        const auto refused = [](const QStringList& arguments, int status) {
            const Answer answer = furrowCli(arguments);
            return answer.status == status && answer.out.isEmpty();
        };
        QVERIFY(refused({"bench"}, 2));
        QVERIFY(refused({"bench", "moon"}, 2));
        QVERIFY(refused({"bench", "paper", "--fields", "/nowhere.geojson"}, 4));
    }
};

FURROW_TEST(TestBenchCli);
#include "tst_bench_cli.moc"
