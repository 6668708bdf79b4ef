import QtQuick
import Furrow.Controls

/// The program ended unexpectedly the last time: says so, and offers the report.
NoticeCard {
    id: root

    required property TroubleReport report
    signal reportRequested()

    objectName: "crashNotice"
    visible: report.crashed
    text: qsTr("Furrow ended unexpectedly the last time.")
    remedy: qsTr("Your work was kept up to the last half second. What happened is recorded on this computer; a report helps to mend it.")

    PushButton {
        objectName: "crashNotice.report"
        text: qsTr("Report a problem…")
        onClicked: {
            root.report.dismiss();
            root.reportRequested();
        }
    }
    PushButton {
        objectName: "crashNotice.close"
        text: qsTr("Close")
        onClicked: root.report.dismiss()
    }
}
