// A plan goes to somebody for review and comes back: comments at places of the map, a verdict, the file, and
// what becomes of it in the project that it was sent from.

#include "planner/project/project_edits.h"
#include "planner/project/project_file.h"
#include "planner/swaths/methods.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/window_test.h"

#include <QAbstractItemModelTester>
#include <QTemporaryDir>

using namespace furrow;

class TestReviewWindow : public test::WindowTest {
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void commentsAtAPlaceAndOnAll();
    void sentReviewedAndTakenIn();
    void whatBecameOfItIsSeen();
    void aLongCommentIsSeen();
    void aCommentIsEdited();
    void anOpenedReviewIsOffered();
    void aForeignFileIsRefused();

private:
    ReviewModel& review() { return *session_->review(); }
    void comment(const QString& text);
    void waitForMessage();
};

void TestReviewWindow::init() {
    begin({1440, 900});
    openSample("Home Field");
}

void TestReviewWindow::cleanup() {
    end();
}

void TestReviewWindow::comment(const QString& text) {
    QTRY_VERIFY(item("review.text") != nullptr && item("review.text")->isVisible());
    QTRY_VERIFY(item("review.text")->hasActiveFocus());
    type(text);
    key(Qt::Key_Return);
}

void TestReviewWindow::waitForMessage() {
    QTRY_VERIFY(!review().message().isEmpty() && !review().isBusy());
}

void TestReviewWindow::commentsAtAPlaceAndOnAll() {
    const QAbstractItemModelTester tester{&review(), QAbstractItemModelTester::FailureReportingMode::QtTest};
    // On the map, by keys and a click.
    key(Qt::Key_M, Qt::ControlModifier);
    QTRY_VERIFY(item("commentPins")->property("placing").toBool());
    picture("review_placing");
    const QPoint at = middleOf(*map()) + QPoint{60, 40};
    clickAt(at);
    comment("Wet here in spring");
    QCOMPARE(review().rowCount(), 1);
    QTRY_VERIFY(item("pin.0") != nullptr && item("pin.0")->isVisible());
    QVERIFY((onMap(review().placeOf(0)) - at).manhattanLength() <= 2);
    // Esc ends the placing without a comment.
    key(Qt::Key_M, Qt::ControlModifier);
    QTRY_VERIFY(item("commentPins")->property("placing").toBool());
    key(Qt::Key_Escape);
    QVERIFY(!item("commentPins")->property("placing").toBool());
    QCOMPARE(review().rowCount(), 1);
    click("review.onPlan");
    comment("Start at the road");
    QCOMPARE(review().rowCount(), 2);
    QVERIFY(!review().placeOf(1).isValid());
    QCOMPARE(review().openCount(), 2);
    click("comment.0.settle");
    QTRY_COMPARE(review().openCount(), 1);
    picture("review_comments");
    // Another heading: what was said was said of another plan.
    QVERIFY(!review().data(review().index(1), ReviewModel::OldRole).toBool());
    Settings changed = session_->planning()->settings();
    changed.set(kOverlap, 0.5).value();
    const Project& project = *session_->document()->project();
    session_->document()->change([] { return QString{}; },
                                 withPlan(project, project.plan().machine, changed));
    QTRY_VERIFY(review().data(review().index(1), ReviewModel::OldRole).toBool());
    key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(!review().data(review().index(1), ReviewModel::OldRole).toBool());
    click("comment.1.remove");
    QTRY_COMPARE(review().rowCount(), 1);
    key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(review().rowCount(), 2);
}

void TestReviewWindow::sentReviewedAndTakenIn() {
    const QTemporaryDir folder;
    const QUrl sent = QUrl::fromLocalFile(folder.filePath("sent.furrow"));
    const QUrl back = QUrl::fromLocalFile(folder.filePath("back.furrow"));
    click("review.onPlan");
    comment("Please look at the turns");
    review().setAuthor("Farmer");
    review().send(sent);
    waitForMessage();
    QVERIFY2(!review().hasFailed(), qPrintable(review().message()));
    QVERIFY(review().isSent());
    QCOMPARE(item("review.send")->property("text").toString(), QString{"Send on…"});
    const History farmers = session_->document()->history();

    // The contractor opens the file as any project.
    auto opened = readProject(folder.filePath("sent.furrow").toStdU16String());
    QVERIFY(opened.has_value());
    session_->document()->begin(History{.base = std::make_shared<const Project>(std::move(opened->project))});
    QTRY_VERIFY(isFinished(session_->planning()->state()));
    QCOMPARE(review().rowCount(), 1);
    QCOMPARE(item("review.send")->property("text").toString(), QString{"Send back…"});
    review().setAuthor("Contractor");
    click("review.atPlace");
    QTRY_VERIFY(item("commentPins")->property("placing").toBool());
    clickAt(middleOf(*map()) + QPoint{-80, 30});
    comment("Turn at this end only");
    click("review.approve");
    QTRY_VERIFY(review().verdictText().startsWith("Approved: Contractor"));
    picture("review_by_contractor");
    review().send(back);
    waitForMessage();
    QVERIFY(!review().hasFailed());

    // Back at the farm.
    session_->document()->begin(farmers);
    QTRY_VERIFY(isFinished(session_->planning()->state()));
    QCOMPARE(review().rowCount(), 1);
    review().dismiss();
    review().takeIn(back);
    waitForMessage();
    QVERIFY2(!review().hasFailed(), qPrintable(review().message()));
    QCOMPARE(review().rowCount(), 2);
    QCOMPARE(review().verdict(), ReviewModel::State::Approved);
    QVERIFY(!review().verdictIsOld());
    QCOMPARE(item("review.send")->property("text").toString(), QString{"Send on…"});
    picture("review_taken_in");
    // Once more gives nothing more.
    const QString undo = session_->document()->undoText();
    review().dismiss();
    review().takeIn(back);
    waitForMessage();
    QCOMPARE(review().rowCount(), 2);
    QCOMPARE(session_->document()->undoText(), undo);
    // One step back, and it never came.
    key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(review().rowCount(), 1);
}

void TestReviewWindow::whatBecameOfItIsSeen() {
    const QTemporaryDir folder;
    window_->resize(1440, 700);
    for (const char* text : {"Wet here in spring", "Start at the road", "Mind the pole"}) {
        click("review.onPlan");
        comment(text);
    }
    bringIntoView("review.send");
    review().send(QUrl::fromLocalFile(folder.filePath("sent.furrow")));
    waitForMessage();
    const auto isInView = [this] {
        const QRectF panel = item("resultsPanel")->mapRectToScene({{}, item("resultsPanel")->size()});
        return panel.contains(item("review.told")->mapRectToScene({{}, item("review.told")->size()}));
    };
    QTRY_VERIFY(isInView());
    picture("review_sent");
}

/// As much as somebody has to say is seen while it is written.
void TestReviewWindow::aLongCommentIsSeen() {
    click("review.onPlan");
    QTRY_VERIFY(item("review.text") != nullptr && item("review.text")->hasActiveFocus());
    const double lineHeight = item("review.text")->height();
    type("The corner by the old barn is wet until May, so the headland there has to be worked last, or left");
    QTRY_VERIFY(item("review.text")->height() > lineHeight + 20.0);
    const double longHeight = item("review.text")->height();
    key(Qt::Key_Return, Qt::ShiftModifier);
    type("Ask Ann");
    QTRY_VERIFY(item("review.text")->height() > longHeight + 10.0);
    // With the buttons below it.
    const auto isInView = [this](const char* name) {
        const QQuickItem& of = *item(QLatin1String{name});
        const QQuickItem& panel = *item("resultsPanel");
        return QRectF{panel.mapToScene({}), panel.size()}.contains(QRectF{of.mapToScene({}), of.size()});
    };
    QTRY_VERIFY(isInView("review.text") && isInView("review.add"));
    picture("review_long");
    // The tabulator leads on and back, it is no part of the text.
    key(Qt::Key_Tab);
    QTRY_VERIFY(item("review.author")->hasActiveFocus());
    key(Qt::Key_Backtab, Qt::ShiftModifier);
    QTRY_VERIFY(item("review.text")->hasActiveFocus());
    key(Qt::Key_Return);
    QTRY_COMPARE(review().rowCount(), 1);
    const QString said = review().data(review().index(0), ReviewModel::TextRole).toString();
    QVERIFY2(said.startsWith("The corner") && said.endsWith("or left\nAsk Ann"), qPrintable(said));
    QVERIFY(!item("review.text")->isVisible());
    picture("review_long_said");
}

void TestReviewWindow::aCommentIsEdited() {
    review().setAuthor("Ann");
    click("review.onPlan");
    comment("Start at the rode");
    click("comment.0.edit");
    QTRY_VERIFY(item("review.text")->isVisible() && item("review.text")->hasActiveFocus());
    QCOMPARE(item("review.text")->property("text").toString(), "Start at the rode");
    QVERIFY(!item("review.author")->isVisible());
    picture("review_edit");
    key(Qt::Key_A, Qt::ControlModifier);
    comment("Start at the road");
    const auto said = [this] { return review().data(review().index(0), ReviewModel::TextRole).toString(); };
    QCOMPARE(said(), "Start at the road");
    QCOMPARE(review().rowCount(), 1);
    QVERIFY(!item("review.text")->isVisible());
    key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(said(), "Start at the rode");
    // By keys only, and given up.
    item("comment.0.edit")->forceActiveFocus(Qt::TabFocusReason);
    key(Qt::Key_Space);
    QTRY_VERIFY(item("review.text")->hasActiveFocus());
    type("x");
    click("review.cancel");
    QCOMPARE(said(), "Start at the rode");
    // What somebody else said stays what was said.
    review().setAuthor("Bob");
    QTRY_VERIFY(!item("comment.0.edit")->isVisible());
    review().setAuthor("");
}

void TestReviewWindow::anOpenedReviewIsOffered() {
    const QTemporaryDir folder;
    const QString back = folder.filePath("back.furrow");
    click("review.onPlan");
    comment("Please look at the turns");
    review().send(QUrl::fromLocalFile(folder.filePath("sent.furrow")));
    waitForMessage();
    const History farmers = session_->document()->history();
    auto opened = readProject(folder.filePath("sent.furrow").toStdU16String());
    session_->document()->begin(History{.base = std::make_shared<const Project>(std::move(opened->project))});
    QTRY_VERIFY(isFinished(session_->planning()->state()));
    click("review.onPlan");
    comment("They are good");
    review().dismiss();
    review().send(QUrl::fromLocalFile(back));
    waitForMessage();
    session_->document()->begin(farmers);
    QTRY_VERIFY(isFinished(session_->planning()->state()));
    review().dismiss();
    // Opened like any project.
    const auto open = [this, &back] {
        QMetaObject::invokeMethod(window_, "openPath", Q_ARG(QString, back));
        QTRY_VERIFY(item("reviewOffer.take") != nullptr && item("reviewOffer.take")->isVisible());
        QTRY_VERIFY(item("reviewOffer.take")->hasActiveFocus());
    };
    open();
    picture("review_offer");
    key(Qt::Key_Escape);
    QTRY_VERIFY(item("reviewOffer.take") == nullptr || !item("reviewOffer.take")->isVisible());
    QCOMPARE(review().rowCount(), 1);
    open();
    key(Qt::Key_Return);
    waitForMessage();
    QVERIFY2(!review().hasFailed(), qPrintable(review().message()));
    QCOMPARE(review().rowCount(), 2);
    QCOMPARE(session_->document()->history().steps.size(), farmers.steps.size() + 1);
}

void TestReviewWindow::aForeignFileIsRefused() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("other.furrow");
    QVERIFY(writeProject(Project::empty(), path.toStdU16String()).has_value());
    review().takeIn(QUrl::fromLocalFile(path));
    waitForMessage();
    QVERIFY(review().hasFailed());
    QCOMPARE(review().rowCount(), 0);
    review().takeIn(QUrl::fromLocalFile(folder.filePath("nowhere.furrow")));
    review().dismiss();
    waitForMessage();
    QVERIFY(review().hasFailed());
    picture("review_refused");
}

FURROW_TEST_WITH(TestReviewWindow, QGuiApplication);
#include "tst_review_window.moc"
