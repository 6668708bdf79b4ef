#include "ui/driven/field_from_track.h"

#include "planner/io/import/track_reader.h"
#include "ui/map/map_frame.h"
#include "ui/text/display.h"
#include "ui/text/unit_text.h"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace furrow {

namespace {

QVariantMap plainFigure(const QString& label, const QString& value) {
    return {{QStringLiteral("label"), label}, {QStringLiteral("value"), value}};
}

QGeoRectangle boundsOf(const TrackOutline& outline) {
    QList<QGeoCoordinate> places;
    for (const GeoPolygon& piece : outline.pieces) {
        std::ranges::transform(piece.outer, std::back_inserter(places),
                               [](GeoPoint place) { return coordinate(place); });
    }
    return QGeoRectangle{places};
}

}  // namespace

FieldFromTrack::FieldFromTrack(Document& document, FieldOpener& opener, ShownPlan& shown, QObject* parent)
    : QObject{parent}, document_{document}, opener_{opener}, shown_{shown} {
    connect(&opener_, &FieldOpener::driveFound, this, &FieldFromTrack::find);
    connect(&runner_, &JobRunner::busyChanged, this, &FieldFromTrack::changed);
    connect(&runner_, &JobRunner::progressChanged, this, &FieldFromTrack::progressChanged);
    connect(&Display::instance(), &Display::changed, this, &FieldFromTrack::changed);
}

void FieldFromTrack::find(const QString& name, const std::shared_ptr<const TrackFile>& file) {
    close();
    name_ = name;
    file_ = file;
    if (shown_.hasPlan()) {
        asking_ = true;
        emit changed();
    } else {
        begin();
    }
}

void FieldFromTrack::open(const QUrl& file) {
    if (!file.isLocalFile()) {
        return;
    }
    close();
    path_ = file.toLocalFile();
    name_ = QFileInfo{path_}.fileName();
    begin();
}

void FieldFromTrack::takeOver(DrivenTrack* track) {
    const auto file = track->file();
    const QString name = track->name();
    track->close();
    close();
    name_ = name;
    file_ = file;
    if (file_ != nullptr) {
        begin();
    }
}

void FieldFromTrack::make() {
    if (std::exchange(asking_, false)) {
        begin();
    }
}

void FieldFromTrack::layOver() {
    if (asking_) {
        const auto file = file_;
        const QString name = name_;
        close();
        emit layRequested(name, file);
    }
}

void FieldFromTrack::close() {
    runner_.cancel();
    asking_ = active_ = announced_ = false;
    name_.clear();
    path_.clear();
    file_.reset();
    outline_.reset();
    trouble_ = remedy_ = {};
    emit changed();
}

void FieldFromTrack::begin() {
    active_ = true;
    options_ = {.width = document_.project()->plan().machine.operatingWidth()};
    if (const auto& plan = shown_.plan()) {
        options_.frame = plan->field().frame();
    }
    work();
}

void FieldFromTrack::work() {
    runner_.submit([this, file = file_, path = path_,
                    options = options_](const JobContext& job) -> JobRunner::Delivery {
        auto tracks = file;
        std::optional<Error> error;
        std::shared_ptr<const TrackOutline> outline;
        if (tracks == nullptr) {
            auto read = readTracks(path.toStdU16String(), job.part(0.0, 0.5));
            if (read) {
                tracks = std::make_shared<const TrackFile>(*std::move(read));
            } else {
                error = read.error();
            }
        }
        if (tracks != nullptr) {
            auto made = outlineOfTracks(tracks->tracks, options, job.part(0.5, 1.0));
            if (made) {
                outline = std::make_shared<const TrackOutline>(*std::move(made));
            } else {
                error = made.error();
            }
        }
        return [this, tracks, outline, error] {
            file_ = tracks;
            outline_ = outline;
            trouble_ = error ? LazyText{[what = error->what] { return sentence(what); }} : LazyText{};
            remedy_ = error ? LazyText{[remedy = error->remedy] { return sentence(remedy); }} : LazyText{};
            emit changed();
            if (outline_ != nullptr && !std::exchange(announced_, true)) {
                emit outlined(boundsOf(*outline_));
            }
        };
    });
    emit changed();
}

void FieldFromTrack::change(TrackOutlineOptions options) {
    options_ = std::move(options);
    if (active_) {
        work();
    }
}

QString FieldFromTrack::recording() const {
    if (file_ == nullptr) {
        return {};
    }
    return inOneLine({QString::fromStdString(file_->format),
                      tr("%n position(s)", nullptr, static_cast<int>(file_->sampleCount())),
                      tr("%n track(s)", nullptr, static_cast<int>(file_->tracks.size()))});
}

QStringList FieldFromTrack::notes() const {
    QStringList all;
    if (file_ != nullptr) {
        for (const Note& note : file_->notes) {
            all << sentence(note.text);
        }
    }
    if (outline_ != nullptr) {
        for (const Note& note : outline_->notes) {
            all << sentence(note.text);
        }
        if (outline_->pieces.size() > 1) {
            all << tr("The pieces do not touch: each becomes a field of its own.");
        }
    }
    return all;
}

QVariantList FieldFromTrack::figures() const {
    QVariantList rows;
    if (outline_ == nullptr) {
        return rows;
    }
    rows << plainFigure(tr("Area"), areaText(outline_->area));
    if (outline_->pieces.size() > 1) {
        rows << plainFigure(tr("Pieces"), QString::number(outline_->pieces.size()));
    }
    std::size_t points = 0;
    std::size_t holes = 0;
    for (const GeoPolygon& piece : outline_->pieces) {
        points += piece.outer.size();
        holes += piece.holes.size();
        for (const GeoRing& hole : piece.holes) {
            points += hole.size();
        }
    }
    if (holes > 0) {
        rows << plainFigure(tr("Holes"), QString::number(holes));
    }
    rows << plainFigure(tr("Points of the boundary"), QString::number(points));
    return rows;
}

QStringList FieldFromTrack::kinds() const {
    const QString round = tr("Around the field");
    const QString worked = tr("Over the whole field, at work");
    const QString found = outline_ == nullptr || options_.kind ? QString{}
                          : outline_->kind == TrackKind::Round ? tr("As it looks: around the field")
                                                               : tr("As it looks: over the field");
    return {found.isEmpty() ? tr("As it looks") : found, round, worked};
}

int FieldFromTrack::kind() const {
    return !options_.kind ? 0 : *options_.kind == TrackKind::Round ? 1 : 2;
}

void FieldFromTrack::setKind(int kind) {
    if (kind == this->kind()) {
        return;
    }
    TrackOutlineOptions options = options_;
    options.kind = kind == 1   ? std::optional{TrackKind::Round}
                   : kind == 2 ? std::optional{TrackKind::Worked}
                               : std::nullopt;
    change(std::move(options));
}

bool FieldFromTrack::isRound() const {
    return options_.kind ? *options_.kind == TrackKind::Round
                         : outline_ == nullptr || outline_->kind == TrackKind::Round;
}

void FieldFromTrack::setWidth(double metres) {
    TrackOutlineOptions options = options_;
    options.width = furrow::metres(metres);
    change(std::move(options));
}

void FieldFromTrack::setBeyond(double metres) {
    TrackOutlineOptions options = options_;
    options.beyond = furrow::metres(metres);
    change(std::move(options));
}

double FieldFromTrack::gap() const {
    return options_.gap.value_or(options_.width).si();
}

void FieldFromTrack::setGap(double metres) {
    TrackOutlineOptions options = options_;
    options.gap = furrow::metres(metres);
    change(std::move(options));
}

void FieldFromTrack::take() {
    if (!isReady()) {
        return;
    }
    std::vector<FieldSource> fields =
        fieldsOf(*outline_, QFileInfo{name_}.completeBaseName().toStdString(), name_.toStdString());
    close();
    opener_.addFields(std::move(fields));
}

}  // namespace furrow
