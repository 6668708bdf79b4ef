import QtQuick
import Furrow.Controls

/// What happened to the project's file, and what can be done about it.
Rectangle {
    id: root

    required property ProjectFiles files
    signal saveAsRequested()

    objectName: "filesNotice"
    visible: files.trouble !== ProjectFiles.None
    width: 400
    height: column.height + 28
    radius: Theme.cardRadius
    color: Theme.panel
    border.width: Theme.hairline
    border.color: files.trouble === ProjectFiles.Restored || files.trouble === ProjectFiles.Notes ? Theme.line : Theme.failure
    Accessible.role: Accessible.AlertMessage
    Accessible.name: root.files.message

    SoftShadow { radius: root.radius }
    Column {
        id: column

        x: 16
        y: 14
        width: parent.width - 32
        spacing: 8

        BodyText {
            objectName: "filesNotice.text"
            width: parent.width
            text: root.files.message
            font.weight: Font.DemiBold
            wrapMode: Text.Wrap
            lineHeight: 1.15
        }
        BodyText {
            width: parent.width
            visible: text.length > 0
            text: root.files.remedy
            wrapMode: Text.WordWrap
            lineHeight: 1.15
        }
        Row {
            spacing: 8
            topPadding: 2

            PushButton {
                objectName: "filesNotice.keep"
                text: root.files.trouble === ProjectFiles.Restored ? qsTr("Keep") : qsTr("OK")
                primary: root.files.trouble === ProjectFiles.Restored
                visible: root.files.trouble !== ProjectFiles.ChangedOnDisk
                onClicked: root.files.dismiss()
            }
            PushButton {
                objectName: "filesNotice.discard"
                text: qsTr("Throw away")
                visible: root.files.trouble === ProjectFiles.Restored
                onClicked: root.files.discardChanges()
            }
            PushButton {
                objectName: "filesNotice.overwrite"
                text: qsTr("Save over it")
                visible: root.files.trouble === ProjectFiles.ChangedOnDisk
                onClicked: root.files.overwrite()
            }
            PushButton {
                objectName: "filesNotice.saveAs"
                text: qsTr("Save as…")
                visible: root.files.trouble === ProjectFiles.ChangedOnDisk || root.files.trouble === ProjectFiles.NotSaved
                onClicked: root.saveAsRequested()
            }
            PushButton {
                text: qsTr("Later")
                visible: root.files.trouble === ProjectFiles.ChangedOnDisk
                onClicked: root.files.dismiss()
            }
        }
    }
}
