#pragma once

#include "ui/map/shown_plan.h"
#include "ui/project/document.h"

#include <QtQml/qqmlregistration.h>
#include <QObject>
#include <QTimer>
#include <QUrl>

namespace furrow {

/// What whoever mends the program needs to know: its version, the machine, the settings and the shape of the
/// field, what was found, and the record of the last crash. No names, no comments, no other fields. It is
/// written to a file that the user chooses; nothing is sent.
class TroubleReport : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    /// The program ended unexpectedly the last time, and nobody was told yet.
    Q_PROPERTY(bool crashed READ hasCrashed NOTIFY changed FINAL)
    /// Where the report was written, or why it was not; empty for neither.
    Q_PROPERTY(QString outcome READ outcome NOTIFY changed FINAL)
    Q_PROPERTY(bool failed READ hasFailed NOTIFY changed FINAL)

public:
    TroubleReport(Document& document, ShownPlan& shown, QObject* parent = nullptr);

    bool hasCrashed() const { return crashed_; }
    QString outcome() const { return outcome_; }
    bool hasFailed() const { return failed_; }
    /// Records of crashes are in this folder; from now on one of this program is, too.
    void keepIn(const QString& folder);

    /// The message about the last crash is read.
    Q_INVOKABLE void dismiss();
    /// Writes the report.
    Q_INVOKABLE void save(const QUrl& file);
    Q_INVOKABLE QUrl suggestedFile() const;
    /// One file's text, in JSON.
    QByteArray text() const;

signals:
    void changed();

private:
    void prepare();

    Document& document_;
    ShownPlan& shown_;
    QTimer later_;
    QString folder_;
    bool crashed_ = false;
    bool failed_ = false;
    QString outcome_;
};

}  // namespace furrow
