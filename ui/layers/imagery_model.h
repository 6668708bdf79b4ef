#pragma once

#include "ui/jobs/job_runner.h"
#include "ui/layers/tile_store.h"
#include "ui/project/document.h"
#include "ui/text/message_text.h"

#include <QtQml/qqmlregistration.h>
#include <QAbstractListModel>
#include <QGeoRectangle>
#include <QTimer>
#include <QUrl>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace furrow {

/// A raster that is drawn, and how.
struct ImagerySheet {
    int number = 0;  ///< of the tile store
    double opacity = 1.0;
};

/// The imagery of the project, topmost first: what is there, whether its file can be read, and what can be
/// done to it. Everything is a change of the document.
class ImageryModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)
    /// Why something could not be added; empty for nothing.
    Q_PROPERTY(QString message READ message NOTIFY messageChanged FINAL)
    Q_PROPERTY(QString remedy READ remedy NOTIFY messageChanged FINAL)

public:
    enum class State { Opening, Ready, Failed };
    Q_ENUM(State)
    enum Role {
        NameRole = Qt::UserRole + 1,
        PathRole,
        ShownRole,
        OpacityRole,
        StateRole,
        ProblemRole,
        RemedyRole,
        HeightsRole,
        TilesRole,
        RowsFromSouthRole
    };

    explicit ImageryModel(Document& document, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

    int count() const { return rowCount(); }
    QString message() const { return text(message_); }
    QString remedy() const { return text(remedy_); }
    TileStore& store() { return store_; }
    /// What is drawn, lowest first.
    std::vector<ImagerySheet> sheets() const;

    /// Adds files or folders above the others, those that can be shown; says why others cannot.
    void add(const QStringList& paths);
    Q_INVOKABLE void addUrls(const QList<QUrl>& urls);
    Q_INVOKABLE void remove(int row);
    /// One step up or down.
    Q_INVOKABLE void move(int row, int steps);
    Q_INVOKABLE void rename(int row, const QString& name);
    Q_INVOKABLE void show(int row, bool shown);
    /// While `live`, as a slider is dragged, changes are one.
    Q_INVOKABLE void setOpacity(int row, double opacity, bool live);
    Q_INVOKABLE void setRowsFromSouth(int row, bool fromSouth);
    /// Tries again to open what could not be opened.
    Q_INVOKABLE void tryAgain(int row);
    /// Where it lies; invalid while it is not open.
    Q_INVOKABLE QGeoRectangle areaOf(int row) const;
    /// Metres between contour lines as they are drawn at this zoom; 0 for a picture.
    Q_INVOKABLE double contourStep(int row, double zoom) const;
    Q_INVOKABLE void dismiss() { tell({}, {}); }

signals:
    void countChanged();
    void messageChanged();
    void sheetsChanged();
    /// Imagery was added and can be shown.
    void added(const QGeoRectangle& area);

private:
    /// A layer as it is shown; in the order of the project, lowest first.
    struct Row {
        ImageryLayer layer;
        int sheet = 0;
        State state = State::Opening;
        Error error;
        /// Of the file as it was seen last; not looked at yet since it was opened.
        std::optional<qint64> stamp;
        /// Why a tile could not be read, until it is known whether there is another file by now.
        std::optional<Error> doubt;
        /// Was added just now: the camera goes there when it is open.
        bool announce = false;
    };
    void follow();
    void open(Row& row);
    /// `text` is marked for translation.
    void change(int row, const char* text, const std::function<void(ImageryLayer&)>& edit,
                const QString& key = {}, bool live = false);
    void take(int sheet, const Result<void>& result);
    void takeFailure(int sheet, const Error& error);
    void changed(std::size_t index);
    /// Looks away from the GUI thread which files are there: a drive on the network may take its time.
    void watch();
    void takeStamps(const std::map<std::string, qint64>& stamps);
    void tell(LazyText message, LazyText remedy);
    /// Of a row of the model, in rows_ and in the project; out of range for none.
    std::size_t indexOf(int row) const { return rows_.size() - 1 - static_cast<std::size_t>(row); }
    int rowOf(std::size_t index) const { return static_cast<int>(rows_.size() - 1 - index); }
    bool has(int row) const { return row >= 0 && row < rowCount(); }

    Document& document_;
    TileStore store_;
    std::vector<Row> rows_;
    QTimer watch_;
    LazyText message_;
    LazyText remedy_;
    /// What is being looked at to be added.
    QStringList adding_;
    JobRunner reader_;
    JobRunner watcher_;
};

}  // namespace furrow
