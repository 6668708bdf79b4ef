#pragma once

#include "ui/export/field_to_export.h"
#include "ui/export/plan_title.h"
#include "ui/jobs/job_runner.h"
#include "ui/pages/work_order_pages.h"
#include "ui/plan/plan_state.h"
#include "ui/project/document.h"
#include "ui/report/order_model.h"
#include "ui/text/message_text.h"

#include <QtQml/qqmlregistration.h>
#include <QObject>
#include <QSizeF>
#include <QStringList>
#include <QUrl>

#include <memory>
#include <vector>

namespace furrow {

/// Prints the work order of the plan that is shown, or of every field of the farm. While the dialog is open
/// the pages follow what is typed; fields that have no plan yet are planned in the background.
class Printing : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    Q_PROPERTY(furrow::OrderModel* order READ order CONSTANT FINAL)
    /// Which plan is printed; empty for none.
    Q_PROPERTY(QString heading READ heading NOTIFY planChanged FINAL)
    Q_PROPERTY(QString details READ details NOTIFY planChanged FINAL)
    /// Why nothing can be printed; empty where it can.
    Q_PROPERTY(QString refusal READ refusal NOTIFY planChanged FINAL)
    Q_PROPERTY(bool open READ isOpen WRITE setOpen NOTIFY openChanged FINAL)
    /// 0 for A4, 1 for Letter; remembered.
    Q_PROPERTY(int paper READ paper WRITE setPaper NOTIFY optionsChanged FINAL)
    Q_PROPERTY(bool wholeFarm READ isWholeFarm WRITE setWholeFarm NOTIFY optionsChanged FINAL)
    /// Ids of the fields that "the whole farm" stands for; empty for all. Set anew each time it is opened.
    Q_PROPERTY(QStringList chosen READ chosen WRITE setChosen NOTIFY planChanged FINAL)
    /// Of those.
    Q_PROPERTY(int fieldCount READ fieldCount NOTIFY planChanged FINAL)
    Q_PROPERTY(QStringList printers READ printers NOTIFY printersChanged FINAL)
    Q_PROPERTY(int defaultPrinter READ defaultPrinter NOTIFY printersChanged FINAL)
    Q_PROPERTY(int pageCount READ pageCount NOTIFY pagesChanged FINAL)
    /// Height of a page by its width.
    Q_PROPERTY(double pageRatio READ pageRatio NOTIFY pagesChanged FINAL)
    Q_PROPERTY(State state READ state NOTIFY stateChanged FINAL)
    Q_PROPERTY(double progress READ progress NOTIFY progressChanged FINAL)
    /// What came of it.
    Q_PROPERTY(QString message READ message NOTIFY stateChanged FINAL)
    Q_PROPERTY(QString remedy READ remedy NOTIFY stateChanged FINAL)

public:
    enum class State {
        Idle,     ///< no pages
        Making,   ///< sheets are made, and fields planned
        Ready,    ///< there are pages
        Writing,  ///< they go to a file or a printer
        Done,
        Stopped,  ///< by the user, before there were pages
        Failed
    };
    Q_ENUM(State)

    /// @param plans  that were made before
    Printing(Document& document, const MadePlans& plans, QObject* parent = nullptr);

    /// What is to be printed; null for nothing, and the state says why.
    void setPlan(const PlanTitle& title, PlanState state);

    OrderModel* order() { return &order_; }
    QString heading() const { return title_.heading(); }
    QString details() const { return title_.details(); }
    QString refusal() const;
    bool isOpen() const { return open_; }
    void setOpen(bool open);
    int paper() const { return static_cast<int>(paper_); }
    void setPaper(int paper);
    bool isWholeFarm() const { return wholeFarm_; }
    void setWholeFarm(bool wholeFarm);
    QStringList chosen() const { return chosen_; }
    void setChosen(const QStringList& chosen);
    int fieldCount() const;
    QStringList printers() const { return printers_; }
    int defaultPrinter() const { return defaultPrinter_; }
    int pageCount() const { return pages_ ? pages_->count() : 0; }
    double pageRatio() const;
    State state() const { return state_; }
    double progress() const { return runner_.progress(); }
    QString message() const { return text(message_); }
    QString remedy() const { return text(remedy_); }
    /// Null where there are none.
    const std::shared_ptr<const WorkOrderPages>& pages() const { return pages_; }

    /// Names field, plan, machine and width; `suffix` is "pdf".
    Q_INVOKABLE QUrl suggestedFile(const QString& suffix) const;
    /// All pages as a PDF, or the page with the map as PNG or SVG: the name says which.
    Q_INVOKABLE void save(const QUrl& file);
    Q_INVOKABLE void print(int printer);
    /// Stops planning or writing.
    Q_INVOKABLE void cancel();
    /// Makes pages again that were stopped.
    Q_INVOKABLE void again();

signals:
    void planChanged();
    void openChanged();
    void optionsChanged();
    void printersChanged();
    void pagesChanged();
    void stateChanged();
    void progressChanged();
    /// Fields were planned for the pages, or got advice.
    void planned(const std::vector<furrow::FieldsExported::Made>& plans);

private:
    struct Made {
        std::shared_ptr<const FieldSource> source;
        Machine machine;
        Settings settings;
        std::shared_ptr<const OrderSheet> sheet;
        QString hash;
    };

    /// It is among those that are printed.
    bool isPrinted(std::size_t field) const;
    const Made* madeOf(const ProjectField& field, const FieldPlan& plan) const;
    void lookForPrinters();
    /// Makes the sheets that are missing, then the pages.
    void update();
    void layPages();
    /// Those in view are not what was asked for.
    void forgetPages();
    void keep(std::vector<Made> made);
    void fail(const Error& error);
    QString baseName() const;
    void setState(State state, LazyText message = {}, LazyText remedy = {});

    Document& document_;
    const MadePlans& plans_;
    OrderModel order_{document_};
    PlanTitle title_;
    PlanState planState_ = PlanState::Empty;
    bool open_ = false;
    PaperSize paper_ = PaperSize::A4;
    bool wholeFarm_ = false;
    QStringList chosen_;
    QStringList printers_;
    int defaultPrinter_ = 0;
    /// Of plans that were printed before; those of fields that changed go with the next ones.
    std::vector<Made> made_;
    std::shared_ptr<const WorkOrderPages> pages_;
    State state_ = State::Idle;
    LazyText message_;
    LazyText remedy_;
    JobRunner printerLooker_;
    JobRunner runner_;
};

}  // namespace furrow
