#include "planner/project/project_edits.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/window_test.h"
#include "ui/pages/page_files.h"

#include <QPrinter>
#include <QProcess>
#include <QTemporaryDir>

using namespace furrow;

/// The printed work order in the whole window, with real mouse and keys; poppler reads what was written.
class TestPrintWindow : public test::WindowTest {
    Q_OBJECT

private:
    bool shown(const char* name) const { return item(name) != nullptr && item(name)->isVisible(); }
    Printing& printing() const { return *session_->printing(); }
    const WorkOrder& order() const { return session_->document()->project()->plan().order; }

    static QString textOf(const QString& pdf) {
        QProcess reader;
        reader.start(QStringLiteral("pdftotext"), {"-layout", pdf, "-"});
        return reader.waitForFinished(60'000) ? QString::fromUtf8(reader.readAllStandardOutput()) : QString{};
    }
    void openField() {
        click("empty.sample.0");
        QTRY_VERIFY_WITH_TIMEOUT(isFinished(session_->planning()->state()), kPatienceMs);
    }
    void openDialog() {
        key(Qt::Key_P, Qt::ControlModifier);
        QTRY_VERIFY(shown("print.pdf"));
        QTRY_VERIFY_WITH_TIMEOUT(printing().state() == Printing::State::Ready, kPatienceMs);
        waitForRest(*item("print.pdf"));
    }
    void save(const QString& file) {
        printing().save(QUrl::fromLocalFile(file));
        QTRY_COMPARE_WITH_TIMEOUT(printing().state(), Printing::State::Done, kPatienceMs);
    }

private slots:
    void theOrderIsTypedAndPrinted() {
        QTemporaryDir folder;
        openField();
        openDialog();
        QVERIFY(printing().pageCount() >= 2);
        QVERIFY(printing().heading().contains(session_->farm()->fieldName()));
        QTRY_VERIFY(shown("print.page.0"));
        click("order.number");
        type("2026-014");
        key(Qt::Key_Tab);
        QCOMPARE(order().number, std::string{"2026-014"});
        QTRY_VERIFY(item("order.customer")->hasActiveFocus());
        type("Hof Jansen");
        key(Qt::Key_Return);
        QCOMPARE(order().customer, std::string{"Hof Jansen"});
        click("order.rate");
        type("many");
        key(Qt::Key_Return);
        QVERIFY(!order().ratePerHectare);
        // What was not taken is gone from the line again.
        QTRY_VERIFY(item("order.rate")->property("text").toString().isEmpty());
        picture(QStringLiteral("print"));

        QTRY_VERIFY(item("print.pdf")->isEnabled());
        save(folder.filePath("order.pdf"));
        const QString text = textOf(folder.filePath("order.pdf"));
        QVERIFY(text.contains("2026-014") && text.contains("Hof Jansen"));
        QVERIFY(text.contains(planHash(orderSheet(*session_->shown()->plan())->pathFile)));
        save(folder.filePath("map.png"));
        QVERIFY(!QImage{folder.filePath("map.png")}.isNull());
        save(folder.filePath("map.svg"));
        QVERIFY(QFile::exists(folder.filePath("map.svg")));
        QTRY_VERIFY(shown("print.outcome"));
        QVERIFY(item("print.outcome")->property("good").toBool());

        // Nothing of it has planned again; and it can be taken back.
        QCOMPARE(session_->planning()->state(), PlanState::Ready);
        // Esc leaves the line, then the dialog.
        key(Qt::Key_Escape);
        QTRY_VERIFY(!item("order.rate")->hasActiveFocus());
        key(Qt::Key_Escape);
        QTRY_VERIFY(!shown("print.pdf"));
        QCOMPARE(printing().pageCount(), 0);
        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(order().customer.empty());
        QCOMPARE(order().number, std::string{"2026-014"});
    }

    void aPrinterGetsThePages() {
        // Instead of a printer, which a test has none of, a file that QPrinter writes.
        QTemporaryDir folder;
        openField();
        openDialog();
        QPrinter printer{QPrinter::HighResolution};
        printer.setOutputFormat(QPrinter::PdfFormat);
        printer.setOutputFileName(folder.filePath("printed.pdf"));
        printer.setFullPage(true);
        printer.setPageSize(QPageSize{QPageSize::A4});
        QVERIFY(paintOn(printer, *printing().pages(), printer.resolution() / 25.4));
        QVERIFY(textOf(folder.filePath("printed.pdf")).contains(session_->farm()->fieldName()));
    }

    void otherPaperByKeys() {
        openField();
        openDialog();
        const double before = printing().pageRatio();
        item("print.paper")->forceActiveFocus(Qt::TabFocusReason);
        key(printing().paper() == 0 ? Qt::Key_Down : Qt::Key_Up);
        QTRY_VERIFY(std::abs(printing().pageRatio() - before) > 0.05);
        QTRY_VERIFY(printing().state() == Printing::State::Ready);
    }

    void theWholeFarm() {
        QTemporaryDir folder;
        openField();
        // The same field once more, a little to the east.
        FieldSource second = *session_->document()->project()->field()->source;
        for (GeoPoint& point : second.parts.front().outer) {
            point.lonDeg += 0.02;
        }
        second.name = "Far field";
        session_->document()->change([] { return QString{}; },
                                     withFields(*session_->document()->project(), {second}));
        QTRY_VERIFY_WITH_TIMEOUT(isFinished(session_->planning()->state()), kPatienceMs);
        openDialog();
        const int alone = printing().pageCount();
        item("print.scope")->forceActiveFocus(Qt::TabFocusReason);
        key(Qt::Key_Down);
        QTRY_VERIFY(printing().isWholeFarm());
        QTRY_VERIFY_WITH_TIMEOUT(
            printing().state() == Printing::State::Ready && printing().pageCount() > 2 * alone, kPatienceMs);
        QTRY_VERIFY(shown("print.page.0"));
        picture(QStringLiteral("print-farm"));
        QVERIFY(!item("print.picture")->isEnabled());
        save(folder.filePath("farm.pdf"));
        const QString table = textOf(folder.filePath("farm.pdf")).section(QChar{'\f'}, 0, 0);
        QVERIFY(table.contains("Far field") && table.contains("Total"));
    }

    void aFarmThatIsStoppedIsNotWritten() {
        openField();
        FieldSource second = *session_->document()->project()->field()->source;
        for (GeoPoint& point : second.parts.front().outer) {
            point.lonDeg += 0.02;
        }
        session_->document()->change([] { return QString{}; },
                                     withFields(*session_->document()->project(), {second}));
        QTRY_VERIFY_WITH_TIMEOUT(isFinished(session_->planning()->state()), kPatienceMs);
        openDialog();
        // The first field was not printed before: its sheet has to be made.
        printing().setWholeFarm(true);
        QCOMPARE(printing().state(), Printing::State::Making);
        printing().cancel();
        QCOMPARE(printing().state(), Printing::State::Stopped);
        // Not the pages that were there before.
        QCOMPARE(printing().pageCount(), 0);
        QTRY_VERIFY(!item("print.pdf")->isEnabled());
        click("print.again");
        QTRY_VERIFY_WITH_TIMEOUT(printing().state() == Printing::State::Ready, kPatienceMs);
        QVERIFY(printing().pageCount() > 2);
    }

    void whatIsNotFinishedIsNotPrinted() {
        openField();
        openDialog();
        MachineModel& machine = *session_->planning()->machine();
        machine.setLibraryIndex(machine.libraryIndex() == 0 ? 1 : 0);
        // As the button does that is there while planning takes long.
        session_->planning()->cancel();
        QTRY_COMPARE(session_->planning()->state(), PlanState::OutOfDate);
        QTRY_VERIFY(shown("print.refusal"));
        QVERIFY(!item("print.pdf")->isEnabled());
        QCOMPARE(printing().pageCount(), 0);
        click("print.planAgain");
        QTRY_VERIFY_WITH_TIMEOUT(printing().state() == Printing::State::Ready, kPatienceMs);
        QVERIFY(!shown("print.refusal"));
    }

    // Pictures to look at.
    void fitsASmallWindow_data() {
        QTest::addColumn<int>("theme");
        QTest::addColumn<QString>("name");
        QTest::newRow("dark") << 2 << "dark";
        QTest::newRow("sunlight") << 3 << "sunlight";
    }
    void fitsASmallWindow() {
        QFETCH(int, theme);
        QFETCH(QString, name);
        constexpr QSize kSmall{1000, 640};
        window_->resize(kSmall);
        QTRY_COMPARE(window_->width(), kSmall.width());
        QObject* const colours = engine_->singletonInstance<QObject*>("Furrow.Controls", "Theme");
        colours->setProperty("forced", theme);
        openField();
        openDialog();
        for (const char* button : {"print.close", "print.picture", "print.print", "print.pdf"}) {
            QVERIFY2(QRect(QPoint{}, kSmall).contains(middleOf(*item(button))), button);
        }
        picture(QStringLiteral("print-") + name);
        colours->setProperty("forced", 0);
    }
};

FURROW_TEST_WITH(TestPrintWindow, QGuiApplication);
#include "tst_print_window.moc"
