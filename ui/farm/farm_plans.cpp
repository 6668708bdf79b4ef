#include "ui/farm/farm_plans.h"

#include "planner/project/field_tasks.h"
#include "planner/project/plan_key.h"
#include "ui/text/display.h"
#include "ui/text/unit_text.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <algorithm>
#include <utility>

namespace furrow {

namespace {

void write(const QString& file, const std::string& text) {
    QDir{}.mkpath(QFileInfo{file}.path());
    QSaveFile kept{file};
    // Results that cannot be kept are made again: no reason to disturb anybody.
    if (kept.open(QIODevice::WriteOnly) && kept.write(text.data(), static_cast<qint64>(text.size())) > 0) {
        kept.commit();
    }
}

}  // namespace

FarmPlans::FarmPlans(Document& document, MadePlans& made, QObject* parent)
    : QObject{parent}, document_{document}, made_{made} {
    for (Worker& worker : workers_) {
        connect(&worker.runner, &JobRunner::progressChanged, this, &FarmPlans::progressChanged);
    }
    connect(&Display::instance(), &Display::changed, this, &FarmPlans::progressChanged);
    connect(&document_, &Document::begun, this, [this] {
        cancel();
        errors_.clear();
        dismiss();
    });
}

void FarmPlans::keepIn(const QString& file) {
    file_ = file;
    QFile kept{file};
    results_ =
        kept.open(QIODevice::ReadOnly) ? PlanResults::fromJson(kept.readAll().toStdString()) : PlanResults{};
    planned_ = results_.places();
    emit resultsChanged();
}

const Error* FarmPlans::errorOf(const std::string& planKey) const {
    const auto found = errors_.find(planKey);
    return found == errors_.end() ? nullptr : &found->second;
}

std::string FarmPlans::placeOf(const ProjectField& field, const FieldPlan& plan) {
    return field.source->name + '\n' + field.id + '\n' + plan.id;
}

bool FarmPlans::wasPlanned(const ProjectField& field, const FieldPlan& plan) const {
    return planned_.contains(placeOf(field, plan));
}

bool FarmPlans::isWaiting(const ProjectField& field) const {
    return std::ranges::contains(waiting_, field.id);
}

bool FarmPlans::isUnderWay(const ProjectField& field) const {
    return std::ranges::contains(workers_, field.id, &Worker::field);
}

void FarmPlans::keep(const std::shared_ptr<const Plan>& plan) {
    const Project& project = *document_.project();
    const ProjectField* const field = project.field();
    if (plan == nullptr || field == nullptr) {
        return;
    }
    const std::string place = placeOf(*field, project.plan());
    if (plan == kept_ && place == keptPlace_) {
        return;
    }
    kept_ = plan;
    keptPlace_ = place;
    store(planKey(*field->source, project.plan()), place, {.plan = plan, .advised = true});
    save();
    emit resultsChanged();
}

void FarmPlans::keep(const ProjectField& field, const FieldPlan& wanted,
                     const std::shared_ptr<const Plan>& plan) {
    store(planKey(*field.source, wanted), placeOf(field, wanted), {.plan = plan, .advised = true});
    save();
    emit resultsChanged();
}

void FarmPlans::plan(const std::vector<std::size_t>& fields) {
    const Project& project = *document_.project();
    if (!isBusy()) {
        asked_ = drivable_ = withFindings_ = failed_ = 0;
    }
    stopped_ = false;
    for (const std::size_t index : fields) {
        if (index >= project.fields.size()) {
            continue;
        }
        const ProjectField& field = *project.fields[index];
        const std::string key = planKey(*field.source, project.planOf(index));
        if (results_.find(key) == nullptr && !isWaiting(field) && !isUnderWay(field)) {
            errors_.erase(key);
            waiting_.push_back(field.id);
            ++asked_;
        }
    }
    goOn();
}

void FarmPlans::goOn() {
    const Project& project = *document_.project();
    for (Worker& worker : workers_) {
        while (worker.field.empty() && !waiting_.empty()) {
            const std::string id = std::exchange(waiting_.front(), {});
            waiting_.pop_front();
            const auto field =
                std::ranges::find_if(project.fields, [&id](const auto& other) { return other->id == id; });
            if (field != project.fields.end()) {
                start(worker, static_cast<std::size_t>(field - project.fields.begin()));
            }
        }
    }
    if (!isBusy()) {
        save();
    }
    emit resultsChanged();
    emit progressChanged();
}

void FarmPlans::start(Worker& worker, std::size_t index) {
    const Project& project = *document_.project();
    const ProjectField& field = *project.fields[index];
    const FieldPlan& plan = project.planOf(index);
    worker.field = field.id;
    worker.name = field.source->name;
    worker.runner.submit([this, &worker, source = field.source, machine = plan.machine,
                          settings = plan.settings, key = planKey(*field.source, plan),
                          place = placeOf(field, plan)](const JobContext& job) -> JobRunner::Delivery {
        auto made = planOfSource(*source, machine, settings, job);
        return [this, &worker, key, place, made = std::move(made)] { finish(worker, key, place, made); };
    });
}

void FarmPlans::finish(Worker& worker, const std::string& key, const std::string& place,
                       const Result<std::shared_ptr<const Plan>>& plan) {
    worker.field.clear();
    if (plan) {
        ++((*plan)->drivable() ? drivable_ : withFindings_);
        store(key, place, {.plan = *plan, .advised = (*plan)->drivable()});
    } else if (plan.error().code != ErrorCode::Cancelled) {
        ++failed_;
        errors_.insert_or_assign(key, plan.error());
    }
    goOn();
}

void FarmPlans::store(const std::string& key, const std::string& place, const MadePlan& made) {
    errors_.erase(key);
    planned_.insert(place);
    results_.keep(key, furrow::resultOf(*made.plan), place);
    made_.keep(key, made);
}

void FarmPlans::save() {
    if (!file_.isEmpty()) {
        saver_.submit([file = file_, text = results_.json()](const JobContext&) -> JobRunner::Delivery {
            write(file, text);
            return [] {};
        });
    }
}

void FarmPlans::cancel() {
    if (!isBusy()) {
        return;
    }
    stopped_ = true;
    waiting_.clear();
    for (Worker& worker : workers_) {
        worker.runner.cancel();
        worker.field.clear();
    }
    goOn();
}

void FarmPlans::dismiss() {
    if (!isBusy()) {
        asked_ = 0;
        stopped_ = false;
        emit progressChanged();
    }
}

std::size_t FarmPlans::underWay() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(workers_, [](const Worker& worker) { return !worker.field.empty(); }));
}

QString FarmPlans::status() const {
    const std::size_t done = drivable_ + withFindings_ + failed_;
    if (isBusy()) {
        const auto worker =
            std::ranges::find_if(workers_, [](const Worker& each) { return !each.field.empty(); });
        return tr("%1 of %2: %3")
            .arg(std::min(done + 1, asked_))
            .arg(asked_)
            .arg(worker == workers_.end() ? QString{} : fromStd(worker->name));
    }
    if (asked_ == 0) {
        return {};
    }
    QStringList parts;
    if (stopped_) {
        parts << tr("Stopped");
    }
    parts << tr("%n field(s) planned", nullptr, static_cast<int>(drivable_ + withFindings_));
    if (withFindings_ > 0) {
        parts << tr("%n with problems", nullptr, static_cast<int>(withFindings_));
    }
    if (failed_ > 0) {
        parts << tr("%n without a plan", nullptr, static_cast<int>(failed_));
    }
    return inOneLine(parts);
}

double FarmPlans::progress() const {
    if (asked_ == 0) {
        return 0.0;
    }
    double done = static_cast<double>(drivable_ + withFindings_ + failed_);
    for (const Worker& worker : workers_) {
        done += worker.field.empty() ? 0.0 : worker.runner.progress();
    }
    return std::clamp(done / static_cast<double>(asked_), 0.0, 1.0);
}

}  // namespace furrow
