#include "ui/best/best_search.h"

#include "planner/plan/best_plan.h"
#include "planner/project/field_tasks.h"
#include "planner/project/project_edits.h"
#include "ui/text/unit_text.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace furrow {

BestSearch::BestSearch(Document& document, QObject* parent) : QObject{parent}, document_{document} {
    connect(&runner_, &JobRunner::progressChanged, this, &BestSearch::progressChanged);
    connect(&runner_, &JobRunner::progressChanged, this, &BestSearch::courseChanged);
}

QString BestSearch::askedTime() const {
    return found_.empty() ? QString{} : exactDurationText(found_.front().time);
}

QString BestSearch::bestTime() const {
    return found_.empty() ? QString{} : exactDurationText(found_.back().time);
}

QString BestSearch::savedTime() const {
    return isBetter() && found_.back().time < found_.front().time
               ? exactDurationText(found_.front().time - found_.back().time)
               : QString{};
}

bool BestSearch::isBetter() const {
    return found_.size() > 1;
}

QList<QPointF> BestSearch::course() const {
    QList<QPointF> line;
    if (found_.empty()) {
        return line;
    }
    const auto whole =
        static_cast<double>(std::max<qint64>(1, state_ == State::Searching ? since_.elapsed() : tookMs_));
    const Duration slowest = std::ranges::max_element(found_, {}, &Found::time)->time;
    const Duration quickest = std::ranges::min_element(found_, {}, &Found::time)->time;
    const auto height = [&](const Found& found) {
        return slowest > quickest ? (slowest - found.time) / (slowest - quickest) : 0.0;
    };
    for (const Found& found : found_) {
        const double x = std::min(1.0, static_cast<double>(found.afterMs) / whole);
        if (!line.empty()) {
            line.append({x, line.back().y()});
        }
        line.append({line.empty() ? 0.0 : x, height(found)});
    }
    line.append({1.0, line.back().y()});
    return line;
}

void BestSearch::begin() {
    cancel();
    choices_.begin(document_.project()->plan().settings);
}

void BestSearch::start() {
    const ProjectField* const field = document_.project()->field();
    if (field == nullptr || state_ == State::Searching) {
        return;
    }
    found_.clear();
    last_.reset();
    since_.start();
    const int search = ++search_;
    const FieldPlan& plan = document_.project()->plan();
    setState(State::Searching);
    emit betterFound();
    runner_.submit([this, search, source = field->source, machine = plan.machine, settings = plan.settings,
                    kept = choices_.kept()](const JobContext& job) -> JobRunner::Delivery {
        auto checked = Field::create(*source, job.part(0.0, 0.05));
        auto best = std::move(checked)
                        .and_then([&](Field&& made) {
                            return planRequest(std::make_shared<const Field>(std::move(made)), machine,
                                               settings, job.part(0.05, 0.05));
                        })
                        .and_then([&](const PlanRequest& request) {
                            const auto onBetter = [this, search](const Settings& better, Duration time) {
                                QMetaObject::invokeMethod(
                                    this, [this, search, better, time] { addFound(search, better, time); },
                                    Qt::QueuedConnection);
                            };
                            return bestPlan({.request = request, .kept = kept, .onBetter = onBetter},
                                            job.part(0.05, 1.0));
                        });
        return [this, search, best = std::move(best)] {
            if (search == search_) {
                finish(best);
            }
        };
    });
}

void BestSearch::addFound(int search, const Settings& settings, Duration time) {
    if (search != search_ || state_ != State::Searching) {
        return;
    }
    found_.push_back({.settings = settings, .time = time, .afterMs = since_.elapsed()});
    emit betterFound();
    emit courseChanged();
}

void BestSearch::finish(const Result<std::shared_ptr<const Plan>>& best) {
    tookMs_ = since_.elapsed();
    if (!best) {
        setState(State::Failed, [what = best.error().what] { return sentence(what); });
        return;
    }
    const ChoiceTable& choices = *(*best)->choices;
    alternatives_ = static_cast<int>(choices.alternatives);
    last_ = (*best)->request.settings;
    table_.show(choices);
    setState(State::Done);
    emit courseChanged();
}

void BestSearch::cancel() {
    ++search_;
    runner_.cancel();
    found_.clear();
    last_.reset();
    setState(State::Idle);
    emit betterFound();
}

void BestSearch::take() {
    const std::optional<Settings> settings = last_        ? last_
                                             : isBetter() ? std::optional{found_.back().settings}
                                                          : std::nullopt;
    cancel();
    if (settings) {
        const Project& project = *document_.project();
        document_.change([] { return tr("Take the best plan"); },
                         withPlan(project, project.plan().machine, *settings));
    }
}

void BestSearch::setState(State state, LazyText message) {
    state_ = state;
    message_ = std::move(message);
    emit stateChanged();
}

}  // namespace furrow
