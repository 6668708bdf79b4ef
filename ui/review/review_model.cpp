#include "ui/review/review_model.h"

#include "planner/project/plan_key.h"
#include "planner/project/project_edits.h"
#include "planner/project/project_file.h"
#include "planner/project/review_file.h"
#include "ui/text/display.h"
#include "ui/text/unit_text.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QSettings>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>
#include <utility>

namespace furrow {

namespace {

constexpr auto kAuthorKey = "review/author";

std::string newId() {
    return QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
}

std::string now() {
    return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
}

QString byText(const std::string& author, const std::string& written) {
    const QDateTime time = QDateTime::fromString(fromStd(written), Qt::ISODate).toLocalTime();
    QStringList parts;
    if (!author.empty()) {
        parts << fromStd(author);
    }
    if (time.isValid()) {
        parts << QLocale{}.toString(time.date(), QLocale::ShortFormat);
    }
    return parts.join(QStringLiteral(", "));
}

std::filesystem::path pathOf(const QUrl& file) {
    return file.toLocalFile().toStdU16String();
}

/// What no file system refuses.
QString asFileName(QString name) {
    for (QChar& letter : name) {
        if (QStringLiteral("/\\:*?\"<>|").contains(letter) || letter.unicode() < 32) {
            letter = QLatin1Char('-');
        }
    }
    return name.trimmed();
}

}  // namespace

ReviewModel::ReviewModel(Document& document, QObject* parent)
    : QAbstractListModel{parent},
      document_{document},
      author_{QSettings{}.value(QLatin1String{kAuthorKey}).toString()} {
    connect(&document_, &Document::projectChanged, this, &ReviewModel::follow);
    connect(&runner_, &JobRunner::busyChanged, this, &ReviewModel::busyChanged);
    connect(&Display::instance(), &Display::changed, this, [this] {
        if (rowCount() > 0) {
            emit dataChanged(index(0), index(rowCount() - 1));
        }
        emit reviewChanged();
        emit planChanged();
        emit messageChanged();
    });
    follow();
}

std::string ReviewModel::currentKey() const {
    const Project& project = *document_.project();
    return project.field() == nullptr ? std::string{} : planKey(*project.field()->source, project.plan());
}

void ReviewModel::follow() {
    // While something is dragged the key would be made for each step, and nobody looks at it.
    if (document_.isDragging()) {
        return;
    }
    const Review& next = review();
    const bool sameLength = next.comments.size() == shown_.comments.size();
    if (!sameLength) {
        beginResetModel();
    }
    shown_ = next;
    key_ = shown_.empty() ? std::string{} : currentKey();
    if (!sameLength) {
        endResetModel();
    } else if (rowCount() > 0) {
        emit dataChanged(index(0), index(rowCount() - 1));
    }
    emit reviewChanged();
}

void ReviewModel::setPlan(std::shared_ptr<const Plan> plan) {
    if (plan != plan_) {
        plan_ = std::move(plan);
        emit planChanged();
    }
}

QString ReviewModel::refusal() const {
    return plan_ != nullptr ? QString{} : tr("Only a finished plan of what the panels show can be sent.");
}

int ReviewModel::openCount() const {
    return static_cast<int>(std::ranges::count(shown_.comments, false, &ReviewComment::settled));
}

ReviewModel::State ReviewModel::verdict() const {
    return static_cast<State>(shown_.verdict.verdict);
}

QString ReviewModel::verdictText() const {
    const QString by = byText(shown_.verdict.author, shown_.verdict.written);
    switch (shown_.verdict.verdict) {
        case Verdict::None: break;
        case Verdict::Approved: return tr("Approved: %1").arg(by);
        case Verdict::ChangesWanted: return tr("Changes wanted: %1").arg(by);
    }
    return {};
}

QString ReviewModel::sendText() const {
    return isReceived() ? tr("Send back…") : isSent() ? tr("Send on…") : tr("Send for review…");
}

bool ReviewModel::verdictIsOld() const {
    return shown_.verdict.verdict != Verdict::None && shown_.verdict.planKey != key_;
}

void ReviewModel::setAuthor(const QString& author) {
    const QString name = author.trimmed();
    if (name != author_) {
        author_ = name;
        QSettings{}.setValue(QLatin1String{kAuthorKey}, author_);
        if (rowCount() > 0) {
            emit dataChanged(index(0), index(rowCount() - 1), {OwnRole});
        }
        emit authorChanged();
    }
}

int ReviewModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(shown_.comments.size());
}

QVariant ReviewModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const ReviewComment& comment = shown_.comments[static_cast<std::size_t>(index.row())];
    switch (role) {
        case NumberRole: return index.row() + 1;
        case ByRole: return byText(comment.author, comment.written);
        case Qt::DisplayRole:
        case TextRole: return fromStd(comment.text);
        case PlaceRole: return QVariant::fromValue(placeOf(index.row()));
        case HasPlaceRole: return comment.place.has_value();
        case OldRole: return comment.planKey != key_;
        case SettledRole: return comment.settled;
        // Nobody puts words into another's mouth.
        case OwnRole: return comment.author.empty() || comment.author == author_.toStdString();
        default: return {};
    }
}

QHash<int, QByteArray> ReviewModel::roleNames() const {
    return {{NumberRole, "number"},     {ByRole, "by"},   {TextRole, "said"},       {PlaceRole, "place"},
            {HasPlaceRole, "hasPlace"}, {OldRole, "old"}, {SettledRole, "settled"}, {OwnRole, "own"}};
}

QGeoCoordinate ReviewModel::placeOf(int row) const {
    if (row < 0 || row >= rowCount()) {
        return {};
    }
    const auto& place = shown_.comments[static_cast<std::size_t>(row)].place;
    return place ? QGeoCoordinate{place->latDeg, place->lonDeg} : QGeoCoordinate{};
}

void ReviewModel::change(const LazyText& text, Review review) {
    document_.change(text, withReview(*document_.project(), std::move(review)));
}

void ReviewModel::add(const QString& text, const QGeoCoordinate& place) {
    if (text.trimmed().isEmpty()) {
        return;
    }
    Review next = review();
    ReviewComment comment{.id = newId(),
                          .author = author_.toStdString(),
                          .written = now(),
                          .text = text.trimmed().toStdString(),
                          .planKey = currentKey()};
    if (place.isValid()) {
        comment.place = GeoPoint{.lonDeg = place.longitude(), .latDeg = place.latitude()};
    }
    next.comments.push_back(std::move(comment));
    change([] { return tr("Comment"); }, std::move(next));
}

void ReviewModel::remove(int row) {
    Review next = review();
    if (row >= 0 && row < static_cast<int>(next.comments.size())) {
        next.comments.erase(next.comments.begin() + row);
        change([] { return tr("Remove a comment"); }, std::move(next));
    }
}

void ReviewModel::setSettled(int row, bool settled) {
    Review next = review();
    if (row >= 0 && row < static_cast<int>(next.comments.size())) {
        next.comments[static_cast<std::size_t>(row)].settled = settled;
        change([settled] { return settled ? tr("Settle a comment") : tr("Open a comment again"); },
               std::move(next));
    }
}

void ReviewModel::setText(int row, const QString& text) {
    Review next = review();
    if (row < 0 || row >= static_cast<int>(next.comments.size()) || text.trimmed().isEmpty()) {
        return;
    }
    ReviewComment& comment = next.comments[static_cast<std::size_t>(row)];
    if (comment.text == text.trimmed().toStdString()) {
        return;
    }
    comment.text = text.trimmed().toStdString();
    // Of two copies of a comment the later one holds.
    comment.written = now();
    comment.planKey = currentKey();
    change([] { return tr("Edit a comment"); }, std::move(next));
}

void ReviewModel::setVerdict(State verdict) {
    Review next = review();
    next.verdict = verdict == State::None ? ReviewVerdict{}
                                          : ReviewVerdict{.verdict = static_cast<Verdict>(verdict),
                                                          .author = author_.toStdString(),
                                                          .written = now(),
                                                          .planKey = currentKey()};
    change(
        [verdict] {
            return verdict == State::Approved        ? tr("Approve the plan")
                   : verdict == State::ChangesWanted ? tr("Ask for changes")
                                                     : tr("Take the verdict back");
        },
        std::move(next));
}

QUrl ReviewModel::suggestedFile() const {
    const Project& project = *document_.project();
    QStringList parts;
    if (project.field() != nullptr) {
        parts << fromStd(project.field()->source->name);
    }
    if (!project.plan().name.empty()) {
        parts << fromStd(project.plan().name);
    }
    parts << tr("review");
    const QDir documents{QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)};
    return QUrl::fromLocalFile(
        documents.filePath(asFileName(parts.join(QStringLiteral(" "))) + QStringLiteral(".furrow")));
}

void ReviewModel::tell(LazyText message, bool failed) {
    message_ = std::move(message);
    failed_ = failed;
    emit messageChanged();
}

void ReviewModel::tell(const Error& error) {
    tell([error] { return tr("%1: %2").arg(sentence(error.what), shown(error.remedy)); }, true);
}

void ReviewModel::dismiss() {
    tell({}, false);
}

void ReviewModel::send(const QUrl& file) {
    if (plan_ == nullptr) {
        return;
    }
    if (!isSent()) {
        Review next = review();
        next.id = newId();
        change([] { return tr("Send for review"); }, std::move(next));
    }
    QString path = file.toLocalFile();
    if (QFileInfo{path}.suffix().isEmpty()) {
        path += QStringLiteral(".furrow");
    }
    runner_.submit([this, path, project = document_.project(),
                    plan = plan_](const JobContext&) -> JobRunner::Delivery {
        const auto written = writeReview(*project, *plan, std::filesystem::path{path.toStdU16String()});
        return [this, path, written] {
            if (written) {
                const QString name = QFileInfo{path}.fileName();
                tell(
                    [name] {
                        return tr("Written: %1. Whoever has Furrow can open it, comment on it and send it back.")
                            .arg(name);
                    },
                    false);
            } else {
                tell(written.error());
            }
        };
    });
}

bool ReviewModel::expectsReviews() const {
    return std::ranges::any_of(document_.project()->fields, [](const auto& field) {
        return std::ranges::any_of(field->plans,
                                   [](const FieldPlan& plan) { return !plan.review.id.empty(); });
    });
}

void ReviewModel::look(const QUrl& file) {
    runner_.submit([this, path = pathOf(file)](const JobContext&) -> JobRunner::Delivery {
        const auto read = readProject(path);
        const bool isReview =
            read && read->project.fields.size() == 1 && read->project.fields.front()->plans.size() == 1;
        const auto sent = isReview ? std::make_shared<const Project>(read->project) : nullptr;
        return [this, sent] {
            emit lookedAt(sent != nullptr && takenReview(*document_.project(), *sent).has_value());
        };
    });
}

void ReviewModel::takeIn(const QUrl& file) {
    runner_.submit([this, path = pathOf(file)](const JobContext&) -> JobRunner::Delivery {
        auto read = readProject(path);
        return [this, read = std::move(read)] {
            if (read) {
                take(read->project);
            } else {
                tell(read.error());
            }
        };
    });
}

void ReviewModel::take(const Project& sent) {
    auto taken = takenReview(*document_.project(), sent);
    if (!taken) {
        tell(taken.error());
        return;
    }
    const bool isNew = taken->added > 0 || taken->changed > 0 || taken->verdictChanged;
    if (isNew) {
        document_.change([] { return tr("Take in a review"); }, std::move(taken->project));
    } else {
        document_.look(std::move(taken->project));
    }
    tell(
        [added = taken->added, isNew, differs = taken->planDiffers] {
            const QString what = added > 0 ? tr("%n new comment(s)", nullptr, added)
                                 : isNew   ? tr("The review was brought up to date")
                                           : tr("Nothing new in this review");
            return differs ? tr("%1. The plan has changed since it was sent.").arg(what)
                           : tr("%1.").arg(what);
        },
        false);
    emit takenIn();
}

}  // namespace furrow
