// `furrow-cli compare` as other programs use it: a plan, a track made from its own path.csv, and the figures.

#include "tests/support/furrow_cli.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include <cmath>

using furrow::test::Answer;
using furrow::test::contentsOf;
using furrow::test::furrowCli;
using furrow::test::writeFile;

namespace {

/// The plan's own path, every sample shifted to the left of the way of driving.
QByteArray shiftedPath(const QByteArray& pathCsv, double leftM) {
    QByteArray text = "t_s;x_m;y_m;speed_kmh;implement_down\n";
    for (const QByteArray& row : pathCsv.trimmed().split('\n').mid(1)) {
        const QList<QByteArray> cells = row.split(',');
        const double heading = cells[6].toDouble();
        const double gear = cells[9].toDouble();
        text += cells[1] + ';' +
                QByteArray::number(cells[2].toDouble() - gear * leftM * std::sin(heading), 'f', 6) + ';' +
                QByteArray::number(cells[3].toDouble() + gear * leftM * std::cos(heading), 'f', 6) + ';' +
                QByteArray::number(3.6 * cells[8].toDouble()) + ';' + cells[10] + '\n';
    }
    return text.replace('.', ',');
}

}  // namespace

class TestCompareCli : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    QString at(const QString& name) const { return folder_.filePath(name); }

private slots:
    void initTestCase() {
        QCOMPARE(furrowCli({"plan", furrow::test::sampleField("home_field"), "--out", at("plan"), "--quiet"})
                     .status,
                 0);
        writeFile(at("shifted.csv"), shiftedPath(contentsOf(at("plan/path.csv")), 0.10));
    }

    void aShiftOfTenCentimetres() {
        const Answer answer =
            furrowCli({"compare", at("plan"), at("shifted.csv"), "--json", "--out", at("out")});
        QVERIFY2(answer.status == 0, answer.error);
        QVERIFY(answer.error.isEmpty());
        const QJsonObject all = answer.json();
        const auto near = [](double value, double expected) {
            return std::abs(value - expected) < 1e-3;
        };  // chords stand for arcs
        QCOMPARE(all["matched_share"].toDouble(), 1.0);
        QCOMPARE(all["tracks"].toArray().first().toObject()["places"].toString(), QString{"local"});
        for (const char* kind : {"swath", "turn"}) {
            const QJsonObject figures = all["kinds"].toObject()[QLatin1String(kind)].toObject();
            QVERIFY(near(figures["median_m"].toDouble(), 0.10));
            QVERIFY(near(figures["p95_m"].toDouble(), 0.10));
            QVERIFY(near(figures["mean_signed_m"].toDouble(), 0.10) ||
                    QLatin1String(kind) == QLatin1String("turn"));
        }
        const int rows = static_cast<int>(contentsOf(at("shifted.csv")).trimmed().split('\n').size());
        const QList<QByteArray> table = contentsOf(at("out/compare.csv")).trimmed().split('\n');
        QCOMPARE(table.size(), rows);
        QCOMPARE(table[0],
                 QByteArray("track,time_s,lon_deg,lat_deg,x_m,y_m,s_m,segment,order,cross_track_m"));
        QVERIFY(near(table[1].split(',').back().toDouble(), 0.10));
        QXmlStreamReader picture{contentsOf(at("out/compare.svg"))};
        while (!picture.atEnd()) {
            picture.readNext();
        }
        QVERIFY(!picture.hasError());
        QCOMPARE(QDir{at("out")}.entryList(QDir::Files), (QStringList{"compare.csv", "compare.svg"}));
    }

    void forPeople() {
        const Answer answer = furrowCli({"compare", at("plan"), at("shifted.csv")});
        QCOMPARE(answer.status, 0);
        QVERIFY(answer.out.contains("Swaths") && answer.out.contains("0.100"));
    }

    void aPlanIsItsOwnTrack() {
        const Answer answer = furrowCli({"compare", at("plan"), at("plan/path.csv"), "--json"});
        QCOMPARE(answer.status, 0);
        const QJsonObject all = answer.json();
        QVERIFY(all["overall"]["largest_m"].toDouble() < 1e-6);
    }

    void refusals_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("part");
        const QString corners = QStringLiteral(FURROW_TEST_DATA_DIR "/tracks/corners.gpx");
        QTest::newRow("no arguments") << QStringList{"compare"} << 2 << "required";
        QTest::newRow("no such option")
            << QStringList{"compare", at("plan"), corners, "--machine", "x"} << 2 << "";
        QTest::newRow("no plan") << QStringList{"compare", at("nowhere"), corners} << 4
                                 << "name the folder of a plan";
        QTest::newRow("no track") << QStringList{"compare", at("plan"), at("nothing.gpx")} << 4
                                  << "no such file";
        QTest::newRow("a track of another place")
            << QStringList{"compare", at("plan"), corners} << 3 << "does not come to the plan";
        QTest::newRow("a track that is none")
            << QStringList{"compare", at("plan"), at("plan/plan.geojson")} << 3 << "no header names";
        QTest::newRow("a folder that cannot be made")
            << QStringList{"compare", at("plan"), at("shifted.csv"), "--out", "/dev/null/x"} << 4
            << "/dev/null";
    }
    void refusals() {
        QFETCH(QStringList, arguments);
        QFETCH(int, status);
        QFETCH(QString, part);
        const Answer answer = furrowCli(arguments);
        QCOMPARE(answer.status, status);
        QVERIFY(answer.out.isEmpty());
        QVERIFY2(answer.error.contains(part.toUtf8()), answer.error);
        QCOMPARE(answer.error.trimmed().count('\n'), 0);
    }
};

FURROW_TEST(TestCompareCli);
#include "tst_compare_cli.moc"
