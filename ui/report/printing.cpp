#include "ui/report/printing.h"

#include "planner/io/files/atomic_files.h"
#include "planner/sheet/order_sheet.h"
#include "ui/pages/page_files.h"
#include "ui/text/display.h"
#include "ui/text/unit_text.h"

#include <QDir>
#include <QLocale>
#include <QPageSize>
#include <QPrinter>
#include <QPrinterInfo>
#include <QRegularExpression>
#include <QSettings>
#include <QStandardPaths>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace furrow {

namespace {

constexpr auto kPaperKey = "report/paper";
constexpr double kMmPerInch = 25.4;

/// Letter in the countries that use it, until the user says otherwise.
PaperSize usualPaper() {
    const QPageSize::PageSizeId own = QLocale::system().measurementSystem() == QLocale::ImperialUSSystem
                                          ? QPageSize::Letter
                                          : QPageSize::A4;
    return own == QPageSize::Letter ? PaperSize::Letter : PaperSize::A4;
}

QString withoutUnsafe(QString name) {
    static const QRegularExpression unsafe{QStringLiteral(R"([\\/:*?"<>|])")};
    return name.replace(unsafe, QStringLiteral("_")).simplified();
}

Result<void> writtenTo(const std::filesystem::path& file, const QByteArray& bytes, const JobContext& job) {
    const FileToWrite files[] = {{file.filename(), [&bytes] { return bytes.toStdString(); }}};
    return writeTogether(file.parent_path(), files, job).transform([](const auto&) {});
}

}  // namespace

Printing::Printing(Document& document, const MadePlans& plans, QObject* parent)
    : QObject{parent}, document_{document}, plans_{plans} {
    const QSettings settings;
    paper_ = settings.contains(kPaperKey)
                 ? (settings.value(kPaperKey).toString() == QLatin1String{"letter"} ? PaperSize::Letter
                                                                                    : PaperSize::A4)
                 : usualPaper();
    connect(&runner_, &JobRunner::progressChanged, this, &Printing::progressChanged);
    connect(&document_, &Document::projectChanged, this, [this] {
        emit planChanged();
        update();
    });
    connect(&Display::instance(), &Display::changed, this, [this] {
        emit planChanged();
        emit stateChanged();
        update();
    });
}

void Printing::setPlan(const PlanTitle& title, PlanState state) {
    title_ = title;
    planState_ = state;
    emit planChanged();
    update();
}

QString Printing::refusal() const {
    switch (planState_) {
        case PlanState::Ready:
        case PlanState::Problems: return {};
        case PlanState::Empty: return tr("There is no field yet, and no plan to print.");
        case PlanState::Reading:
        case PlanState::Choosing:
        case PlanState::Planning:
            return tr("The plan is still being made. It can be printed when it is finished.");
        case PlanState::OutOfDate: return tr("The plan is out of date. Plan again to print it.");
        case PlanState::Failed: break;
    }
    return tr("There is no plan to print. The message on the map says why.");
}

void Printing::setOpen(bool open) {
    if (open == open_) {
        return;
    }
    open_ = open;
    emit openChanged();
    if (open_) {
        lookForPrinters();
        update();
    } else {
        runner_.cancel();
        forgetPages();
        setState(State::Idle);
    }
}

void Printing::lookForPrinters() {
    // A print server that is away takes its time.
    printerLooker_.submit([this](const JobContext&) -> JobRunner::Delivery {
        const QStringList names = QPrinterInfo::availablePrinterNames();
        const auto usual = static_cast<int>(names.indexOf(QPrinterInfo::defaultPrinterName()));
        return [this, names, usual] {
            printers_ = names;
            defaultPrinter_ = std::max(0, usual);
            emit printersChanged();
        };
    });
}

void Printing::setPaper(int paper) {
    if (paper == this->paper() || paper < 0 || paper > 1) {
        return;
    }
    paper_ = static_cast<PaperSize>(paper);
    QSettings{}.setValue(kPaperKey,
                         paper_ == PaperSize::Letter ? QStringLiteral("letter") : QStringLiteral("a4"));
    emit optionsChanged();
    update();
}

void Printing::setWholeFarm(bool wholeFarm) {
    if (wholeFarm == wholeFarm_) {
        return;
    }
    wholeFarm_ = wholeFarm;
    emit optionsChanged();
    update();
}

void Printing::setChosen(const QStringList& chosen) {
    if (chosen == chosen_) {
        return;
    }
    chosen_ = chosen;
    setWholeFarm(!chosen.isEmpty());
    emit planChanged();
    update();
}

bool Printing::isPrinted(std::size_t index) const {
    const Project& project = *document_.project();
    if (!wholeFarm_) {
        return index == project.currentField;
    }
    return chosen_.isEmpty() || chosen_.contains(fromStd(project.fields[index]->id));
}

int Printing::fieldCount() const {
    const auto& fields = document_.project()->fields;
    return static_cast<int>(chosen_.isEmpty() ? fields.size()
                                              : std::ranges::count_if(fields, [this](const auto& field) {
                                                    return chosen_.contains(fromStd(field->id));
                                                }));
}

double Printing::pageRatio() const {
    const QSizeF size = paperMm(paper_);
    return size.height() / size.width();
}

const Printing::Made* Printing::madeOf(const ProjectField& field, const FieldPlan& plan) const {
    const auto found = std::ranges::find_if(made_, [&](const Made& made) {
        return (made.source == field.source || *made.source == *field.source) &&
               made.machine == plan.machine && made.settings == plan.settings;
    });
    return found == made_.end() ? nullptr : &*found;
}

void Printing::update() {
    if (!open_) {
        return;
    }
    if (!title_) {
        runner_.cancel();
        forgetPages();
        setState(State::Idle);
        return;
    }
    const Project& project = *document_.project();
    const PlanRequest& request = title_.plan->request;
    if (request.machine != project.plan().machine || request.settings != project.plan().settings) {
        return;  // the plan of what was changed just now is on its way
    }
    std::vector<FieldToExport> missing;
    for (std::size_t i = 0; i < project.fields.size(); ++i) {
        const FieldPlan& plan = project.planOf(i);
        if (isPrinted(i) && madeOf(*project.fields[i], plan) == nullptr) {
            missing.push_back({.field = project.fields[i],
                               .wanted = plan,
                               .made = i == project.currentField
                                           ? MadePlan{.plan = title_.plan, .advised = true}
                                           : plans_.find(*project.fields[i], plan)});
        }
    }
    if (missing.empty()) {
        runner_.cancel();
        layPages();
        return;
    }
    setState(State::Making);
    runner_.submit([this, missing = std::move(missing)](const JobContext& job) -> JobRunner::Delivery {
        auto made = std::make_shared<std::vector<Made>>();
        auto plans = std::make_shared<std::vector<FieldsExported::Made>>();
        for (std::size_t i = 0; i < missing.size(); ++i) {
            const FieldToExport& task = missing[i];
            const auto count = static_cast<double>(missing.size());
            const auto plan =
                advisedPlan(task.made, *task.field->source, task.wanted.machine, task.wanted.settings,
                            job.part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count));
            if (plan && *plan != task.made.plan) {
                plans->push_back({.of = task, .plan = *plan});
            }
            auto sheet = plan.and_then([](const auto& there) { return orderSheet(*there); });
            if (!sheet) {
                Error error = sheet.error();
                error.what = furrow::message("{}: {}", task.name(), error.what);
                return [this, made, plans, error] {
                    emit planned(*plans);
                    keep(std::move(*made));
                    forgetPages();
                    fail(error);
                };
            }
            const QString hash = planHash(sheet->pathFile);
            sheet->pathFile = {};
            made->push_back({.source = task.field->source,
                             .machine = task.wanted.machine,
                             .settings = task.wanted.settings,
                             .sheet = std::make_shared<const OrderSheet>(*std::move(sheet)),
                             .hash = hash});
        }
        return [this, made, plans] {
            emit planned(*plans);
            keep(std::move(*made));
            layPages();
        };
    });
}

void Printing::keep(std::vector<Made> made) {
    const Project& project = *document_.project();
    std::erase_if(made_, [&project](const Made& old) {
        return std::ranges::none_of(project.fields,
                                    [&old](const auto& field) { return field->source == old.source; });
    });
    std::ranges::move(made, std::back_inserter(made_));
}

void Printing::layPages() {
    const Project& project = *document_.project();
    PrintJob job{.farm = fromStd(project.name),
                 .plans = {},
                 .paper = paper_,
                 .printed = QDateTime::currentDateTime(),
                 .wholeFarm = wholeFarm_};
    for (std::size_t i = 0; i < project.fields.size(); ++i) {
        if (!isPrinted(i)) {
            continue;
        }
        const FieldPlan& plan = project.planOf(i);
        const Made* const made = madeOf(*project.fields[i], plan);
        if (made == nullptr) {
            return;  // the project is another one by now: what is made for it follows
        }
        job.plans.push_back({.sheet = made->sheet,
                             .order = plan.order,
                             .planName = fromStd(plan.name),
                             .season = fromStd(plan.season),
                             .hash = made->hash,
                             .comments = plan.review.openComments()});
    }
    pages_ = std::make_shared<const WorkOrderPages>(job);
    setState(State::Ready);
    emit pagesChanged();
}

void Printing::forgetPages() {
    pages_.reset();
    emit pagesChanged();
}

void Printing::fail(const Error& error) {
    if (error.code == ErrorCode::Cancelled) {
        setState(State::Stopped);
        return;
    }
    const Message what =
        error.where.empty() ? error.what : furrow::message("{} ({})", error.what, error.where);
    setState(
        State::Failed, [what] { return sentence(what); },
        [remedy = error.remedy] { return sentence(remedy); });
}

QString Printing::baseName() const {
    if (!title_) {
        return tr("Work order");
    }
    if (wholeFarm_) {
        const QString farm = fromStd(document_.project()->name);
        return withoutUnsafe(farm.isEmpty() ? tr("Work orders") : farm);
    }
    const Machine& machine = title_.plan->request.machine;
    QStringList parts{fromStd(title_.plan->field().name())};
    if (!title_.name.isEmpty()) {
        parts << title_.name;
    }
    parts << shown(machine.name()) << shortLengthText(machine.operatingWidth());
    return withoutUnsafe(parts.join(QStringLiteral(" - ")));
}

QUrl Printing::suggestedFile(const QString& suffix) const {
    const QDir folder{QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)};
    return QUrl::fromLocalFile(folder.filePath(baseName() + QLatin1Char('.') + suffix));
}

void Printing::save(const QUrl& file) {
    if (!pages_ || state_ == State::Writing || !file.isLocalFile()) {
        return;
    }
    const QString name = file.toLocalFile();
    setState(State::Writing);
    runner_.submit([this, name, pages = pages_,
                    title = baseName()](const JobContext& job) -> JobRunner::Delivery {
        const auto goOn = [&job, count = static_cast<double>(pages->count())](int page) {
            job.report(page / count);
            return !job.stopRequested();
        };
        const QByteArray bytes = name.endsWith(QLatin1String{".png"}, Qt::CaseInsensitive) ? pngOf(*pages)
                                 : name.endsWith(QLatin1String{".svg"}, Qt::CaseInsensitive)
                                     ? svgOf(*pages, title)
                                     : pdfOf(*pages, title, goOn);
        const auto written = job.stopRequested() ? Result<void>{std::unexpected(cancelled())}
                                                 : writtenTo(name.toStdU16String(), bytes, job);
        return [this, name, written] {
            if (!written) {
                fail(written.error());
                return;
            }
            setState(State::Done, [name] { return tr("Written: %1").arg(QDir::toNativeSeparators(name)); });
        };
    });
}

void Printing::print(int printer) {
    if (!pages_ || state_ == State::Writing || printer < 0 || printer >= printers_.size()) {
        return;
    }
    const QString name = printers_[printer];
    setState(State::Writing);
    runner_.submit([this, name, pages = pages_,
                    title = baseName()](const JobContext& job) -> JobRunner::Delivery {
        QPrinter device{QPrinterInfo::printerInfo(name), QPrinter::HighResolution};
        device.setFullPage(true);
        device.setPageSize(QPageSize{pages->sizeMm(), QPageSize::Millimeter, {}, QPageSize::FuzzyMatch});
        device.setPageMargins({});
        device.setDocName(title);
        const auto goOn = [&job, count = static_cast<double>(pages->count())](int page) {
            job.report(page / count);
            return !job.stopRequested();
        };
        const bool printed = paintOn(device, *pages, device.resolution() / kMmPerInch, goOn);
        const bool stopped = job.stopRequested();
        return [this, name, printed, stopped] {
            if (stopped) {
                fail(cancelled());
                return;
            }
            if (!printed) {
                setState(
                    State::Failed, [name] { return tr("The printer %1 did not take the pages.").arg(name); },
                    [] { return tr("Look whether it is on, or save a PDF and print that."); });
                return;
            }
            setState(State::Done, [name] { return tr("Sent to %1").arg(name); });
        };
    });
}

void Printing::cancel() {
    const bool writing = state_ == State::Writing;
    if (!writing && state_ != State::Making) {
        return;
    }
    runner_.cancel();
    if (!writing) {
        forgetPages();
    }
    setState(writing && pages_ ? State::Ready : State::Stopped);
}

void Printing::again() {
    if (state_ == State::Stopped || state_ == State::Failed) {
        update();
    }
}

void Printing::setState(State state, LazyText message, LazyText remedy) {
    state_ = state;
    message_ = std::move(message);
    remedy_ = std::move(remedy);
    emit stateChanged();
}

}  // namespace furrow
