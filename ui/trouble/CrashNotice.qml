import QtQuick
import Furrow.Controls

/// The program ended unexpectedly the last time: says so, and offers the report.
Rectangle {
    id: root

    required property TroubleReport report
    signal reportRequested()

    objectName: "crashNotice"
    visible: report.crashed
    width: 400
    height: column.height + 28
    radius: Theme.cardRadius
    color: Theme.panel
    border.width: Theme.hairline
    border.color: Theme.line
    Accessible.role: Accessible.AlertMessage
    Accessible.name: message.text

    SoftShadow { radius: root.radius }
    Column {
        id: column

        x: 16
        y: 14
        width: parent.width - 32
        spacing: 8

        BodyText {
            id: message

            width: parent.width
            text: qsTr("Furrow ended unexpectedly the last time.")
            font.weight: Font.DemiBold
            wrapMode: Text.Wrap
        }
        BodyText {
            width: parent.width
            text: qsTr("Your work was kept up to the last half second. What happened is recorded on this computer; a report helps to mend it.")
            wrapMode: Text.WordWrap
            lineHeight: 1.15
        }
        Row {
            spacing: 8
            topPadding: 2

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
    }
}
