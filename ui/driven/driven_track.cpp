#include "ui/driven/driven_track.h"

#include "planner/io/import/track_reader.h"
#include "ui/map/map_frame.h"
#include "ui/text/display.h"
#include "ui/text/unit_text.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <utility>

namespace furrow {

namespace {

constexpr std::size_t kPointsOfCourse = 400;

std::size_t stepOf(const std::optional<TrackMatch>& match) {
    if (!match) {
        return DrivenTrack::kClasses - 1;
    }
    const auto within = std::ranges::find_if(
        DrivenTrack::kStepsM, [&match](double step) { return std::abs(match->crossTrackM) <= step; });
    return static_cast<std::size_t>(within - DrivenTrack::kStepsM.begin());
}

QVariantMap figure(const QString& label, const QString& value, const QString& hint = {}) {
    return {
        {QStringLiteral("label"), label}, {QStringLiteral("value"), value}, {QStringLiteral("hint"), hint}};
}

/// From the first to the last sample with a time; nothing without.
std::optional<Duration> timeOf(const std::vector<RecordedTrack>& tracks) {
    double sum = 0.0;
    bool any = false;
    for (const RecordedTrack& track : tracks) {
        std::optional<double> first;
        std::optional<double> last;
        for (const TrackSample& sample : track.samples) {
            if (sample.timeS) {
                first = first ? first : sample.timeS;
                last = sample.timeS;
            }
        }
        if (first && *last > *first) {
            sum += *last - *first;
            any = true;
        }
    }
    return any ? std::optional{seconds(sum)} : std::nullopt;
}

}  // namespace

DrivenTrack::DrivenTrack(ShownPlan& shown, QObject* parent) : QObject{parent}, shown_{shown} {
    connect(&shown_, &ShownPlan::planChanged, this, &DrivenTrack::lay);
    connect(&runner_, &JobRunner::busyChanged, this, &DrivenTrack::changed);
    connect(&runner_, &JobRunner::progressChanged, this, &DrivenTrack::progressChanged);
    connect(&Display::instance(), &Display::changed, this, &DrivenTrack::changed);
}

Result<DrivenTrack::Laid> DrivenTrack::laidOverPlan(const std::shared_ptr<const Plan>& plan,
                                                    const TrackFile& file, const JobContext& job) {
    const Length width = plan->request.machine.operatingWidth();
    const LocalFrame& frame = plan->field().frame();
    auto recorded = laidOver(plan->path, frame, file, width, job.part(0.5, 0.7));
    if (!recorded) {
        return std::unexpected(recorded.error());
    }
    std::vector<Ring> places;
    for (const RecordedTrack& track : recorded->tracks) {
        places.push_back(placesIn(frame, track));
    }
    auto area = drivenArea(plan->field().workable(), recorded->tracks, places, recorded->comparison, width,
                           job.part(0.7, 1.0));
    if (!area) {
        return std::unexpected(area.error());
    }
    return Laid{.plan = plan,
                .recorded = *std::move(recorded),
                .places = std::move(places),
                .area = *std::move(area)};
}

void DrivenTrack::open(const QUrl& file) {
    if (!file.isLocalFile()) {
        return;
    }
    file_ = file.toLocalFile();
    read_.reset();
    laid_.reset();
    trouble_ = {};
    remedy_ = {};
    lay();
    emit changed();
}

void DrivenTrack::layRecording(const QString& name, const std::shared_ptr<const TrackFile>& file) {
    close();
    file_ = name;
    read_ = file;
    lay();
    emit changed();
}

void DrivenTrack::close() {
    runner_.cancel();
    file_.clear();
    read_.reset();
    laid_.reset();
    trouble_ = {};
    remedy_ = {};
    emit changed();
}

void DrivenTrack::lay() {
    if (!isActive() || shown_.plan() == nullptr || shown_.isDraft()) {
        return;
    }
    runner_.submit([this, file = file_, read = read_,
                    plan = shown_.plan()](const JobContext& job) -> JobRunner::Delivery {
        auto tracks = read;
        std::optional<Error> error;
        std::shared_ptr<const Laid> laid;
        if (tracks == nullptr) {
            auto made = readTracks(file.toStdU16String(), job.part(0.0, 0.5));
            if (made) {
                tracks = std::make_shared<const TrackFile>(*std::move(made));
            } else {
                error = made.error();
            }
        }
        if (tracks != nullptr) {
            auto made = laidOverPlan(plan, *tracks, job);
            if (made) {
                laid = std::make_shared<const Laid>(*std::move(made));
            } else {
                error = made.error();
            }
        }
        return [this, file, tracks, laid, error] {
            if (file != file_) {
                return;
            }
            read_ = tracks;
            laid_ = laid;
            trouble_ = error ? LazyText{[what = error->what] { return sentence(what); }} : LazyText{};
            remedy_ = error ? LazyText{[remedy = error->remedy] { return sentence(remedy); }} : LazyText{};
            emit changed();
        };
    });
}

QString DrivenTrack::name() const {
    return QFileInfo{file_}.fileName();
}

QStringList DrivenTrack::notes() const {
    QStringList all;
    if (laid_ != nullptr) {
        for (const Note& note : laid_->recorded.notes) {
            all << sentence(note.text);
        }
    }
    return all;
}

const Plan* DrivenTrack::plan() const {
    return laid_ == nullptr ? nullptr : laid_->plan.get();
}

const MultiPolygon& DrivenTrack::missed() const {
    static const MultiPolygon none;
    return laid_ == nullptr ? none : laid_->area.places;
}

QVariantList DrivenTrack::figures() const {
    QVariantList rows;
    if (laid_ == nullptr) {
        return rows;
    }
    const TrackComparison& compared = laid_->recorded.comparison;
    const auto distance = [](Length length) { return metresText(length, 2); };
    rows << figure(tr("On the plan"), percentText(compared.matchedShare(), 1),
                   tr("Positions within one and a half widths of it; the figures are of these"))
         << figure(tr("Half are within"), distance(compared.overall.median))
         << figure(tr("95 % are within"), distance(compared.overall.p95))
         << figure(tr("Farthest"), distance(compared.overall.largest));
    const double mean = compared.overall.mean.si();
    rows << figure(mean < 0.0 ? tr("On average to the right") : tr("On average to the left"),
                   distance(metres(std::abs(mean))), tr("The same everywhere: antenna or offset"));
    if (const CrossTrackFigures* swaths = compared.of(SegmentKind::Swath)) {
        rows << figure(tr("On swaths, 95 % within"), distance(swaths->p95));
    }
    const Area workable = laid_->area.covered + laid_->area.missed;
    const auto share = [workable](Area part) { return workable.si() > 0.0 ? part / workable : 0.0; };
    rows << figure(tr("Covered"),
                   inOneLine({areaText(laid_->area.covered), percentText(share(laid_->area.covered), 1)}),
                   tr("As if the implement ran in the middle of the recorded line"))
         << figure(tr("Missed"), areaText(laid_->area.missed));
    double way = 0.0;
    for (const Ring& places : laid_->places) {
        way += lengthM(places);
    }
    rows << figure(tr("Driven"), lengthText(metres(way)),
                   tr("The plan: %1").arg(lengthText(laid_->plan->path.length())));
    if (const auto time = timeOf(laid_->recorded.tracks)) {
        rows << figure(tr("Time"), durationText(*time),
                       tr("The plan: %1").arg(durationText(laid_->plan->path.duration())));
    }
    return rows;
}

QStringList DrivenTrack::steps() const {
    QStringList names;
    for (const double step : kStepsM) {
        names << tr("up to %1").arg(shortLengthText(metres(step)));
    }
    return names << tr("farther") << tr("off the plan");
}

QList<QPointF> DrivenTrack::course() const {
    QList<QPointF> points;
    if (laid_ == nullptr || laid_->recorded.comparison.overall.largest.si() <= 0.0) {
        return points;
    }
    std::vector<double> errors;
    for (const auto& track : laid_->recorded.comparison.matches) {
        for (const auto& match : track) {
            errors.push_back(match ? match->crossTrackM : 0.0);
        }
    }
    // Of what falls on one place the farthest is shown.
    const std::size_t bins = std::min(kPointsOfCourse, errors.size());
    const double largest = laid_->recorded.comparison.overall.largest.si();
    for (std::size_t bin = 0; bin < bins; ++bin) {
        const auto from = errors.begin() + static_cast<std::ptrdiff_t>(bin * errors.size() / bins);
        const auto to = errors.begin() + static_cast<std::ptrdiff_t>((bin + 1) * errors.size() / bins);
        const double error =
            *std::ranges::max_element(from, to, {}, [](double each) { return std::abs(each); });
        points.emplace_back(
            static_cast<double>(bin) / static_cast<double>(std::max<std::size_t>(1, bins - 1)),
            0.5 - 0.5 * error / largest);
    }
    return points;
}

QString DrivenTrack::courseTop() const {
    return laid_ == nullptr ? QString{} : metresText(laid_->recorded.comparison.overall.largest, 2);
}

QGeoCoordinate DrivenTrack::placeAt(double share) const {
    if (laid_ == nullptr) {
        return {};
    }
    const MapFrame frame{laid_->plan->field().frame()};
    auto wanted = static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) *
                                           static_cast<double>(laid_->recorded.comparison.samples - 1));
    for (const Ring& places : laid_->places) {
        if (wanted < places.size()) {
            return coordinate(frame.geo(places[wanted]));
        }
        wanted -= places.size();
    }
    return {};
}

QGeoCoordinate DrivenTrack::farthest() const {
    if (laid_ == nullptr) {
        return {};
    }
    double most = -1.0;
    Point place;
    for (std::size_t i = 0; i < laid_->places.size(); ++i) {
        for (std::size_t k = 0; k < laid_->places[i].size(); ++k) {
            const auto& match = laid_->recorded.comparison.matches[i][k];
            if (match && std::abs(match->crossTrackM) > most) {
                most = std::abs(match->crossTrackM);
                place = laid_->places[i][k];
            }
        }
    }
    return coordinate(MapFrame{laid_->plan->field().frame()}.geo(place));
}

std::vector<DrivenTrack::Line> DrivenTrack::lines() const {
    std::vector<Line> lines;
    for (std::size_t i = 0; laid_ != nullptr && i < laid_->places.size(); ++i) {
        const Ring& places = laid_->places[i];
        for (std::size_t k = 0; k < places.size(); ++k) {
            const std::size_t step = stepOf(laid_->recorded.comparison.matches[i][k]);
            if (k == 0) {
                lines.push_back({.step = step, .points = {places[k]}});
                continue;
            }
            lines.back().points.push_back(places[k]);
            if (step != lines.back().step) {
                lines.push_back({.step = step, .points = {places[k]}});
            }
        }
    }
    return lines;
}

}  // namespace furrow
