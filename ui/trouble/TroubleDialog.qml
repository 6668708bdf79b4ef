import QtQuick
import Furrow.Controls
import Furrow.Files

/// Says what a report of a problem holds, and writes it where the user wants it.
ThemedDialog {
    id: root

    required property TroubleReport report

    objectName: "troubleDialog"
    title: qsTr("Report a problem")
    width: 520
    closePolicy: ThemedDialog.CloseOnEscape | ThemedDialog.CloseOnPressOutside
    onOpened: save.forceActiveFocus(Qt.TabFocusReason)

    BodyText {
        width: parent.width
        text: qsTr("One file with all that is needed to find the cause: the version, the machine, the settings, the shape of the field, the findings, and the record of the last crash. No names and no other fields are in it.")
        wrapMode: Text.WordWrap
        lineHeight: 1.15
    }
    BodyText {
        width: parent.width
        text: qsTr("Nothing is sent. You decide who gets the file; write to them what you did and what you expected.")
        wrapMode: Text.WordWrap
        lineHeight: 1.15
    }
    NoticeBar {
        objectName: "trouble.outcome"
        width: parent.width
        visible: root.report.outcome.length > 0
        failed: root.report.failed
        text: root.report.outcome
    }
    Row {
        spacing: 8

        PushButton {
            id: save

            objectName: "trouble.save"
            text: qsTr("Save the report…")
            primary: true
            onClicked: {
                fileDialog.selectedFile = root.report.suggestedFile();
                fileDialog.open();
            }
        }
        PushButton {
            objectName: "trouble.close"
            text: qsTr("Close")
            onClicked: root.close()
        }
    }
    FileChooser {
        id: fileDialog

        objectName: "troubleFileDialog"
        title: qsTr("Save the report")
        fileMode: FileChooser.SaveFile
        defaultSuffix: "json"
        nameFilters: [qsTr("Reports (%1)").arg("*.json")]
        onAccepted: root.report.save(selectedFile)
    }
}
