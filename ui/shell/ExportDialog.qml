pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Dialogs
import QtQuick.Templates as T
import Furrow.Controls
import Furrow.Plan

/// Which files a plan is written to, and where.
T.Popup {
    id: root

    required property PlanSession session
    readonly property ExportModel exporter: session.exporter

    objectName: "exportDialog"
    modal: true
    focus: true
    width: 460
    implicitHeight: contentItem.implicitHeight + 2 * padding
    padding: 24
    closePolicy: T.Popup.CloseOnEscape | T.Popup.CloseOnPressOutside
    onAboutToShow: {
        exporter.clear();
        if (folder.text.length === 0)
            folder.text = exporter.suggestedFolder();
    }

    T.Overlay.modal: Rectangle { color: "#66000000" }
    enter: Transition {
        NumberAnimation { property: "opacity"; from: 0; to: 1; duration: Theme.motion }
    }
    background: Rectangle {
        radius: 14
        color: Theme.panel
        border.width: Theme.hairline
        border.color: Theme.line
    }
    contentItem: Column {
        spacing: 14

        BodyText {
            text: qsTr("Export the plan")
            font.pixelSize: 18
            font.weight: Font.DemiBold
        }
        NoticeBar {
            width: parent.width
            visible: root.session.findings.blockingCount > 0
            text: qsTr("%n place(s) in this plan cannot be driven as drawn. The files say so too.", "", root.session.findings.blockingCount)
        }
        Column {
            width: parent.width
            spacing: 4

            Repeater {
                model: root.exporter

                Column {
                    id: format

                    required property int index
                    required property string name
                    required property string hint
                    required property bool checked

                    width: parent.width

                    CheckRow {
                        objectName: "export.format." + format.index
                        width: parent.width
                        text: format.name
                        checked: format.checked
                        onToggled: root.exporter.setChecked(format.index, checked)
                    }
                    Caption {
                        x: 26
                        width: parent.width - 26
                        text: format.hint
                        wrapMode: Text.WordWrap
                        bottomPadding: 4
                    }
                }
            }
        }
        Column {
            width: parent.width
            spacing: 5

            Caption { text: qsTr("Folder") }
            Row {
                width: parent.width
                spacing: 8

                T.TextField {
                    id: folder

                    objectName: "export.folder"
                    width: parent.width - choose.width - 8
                    height: Theme.controlHeight
                    leftPadding: 12
                    rightPadding: 12
                    verticalAlignment: TextInput.AlignVCenter
                    color: Theme.ink
                    selectionColor: Theme.accent
                    selectedTextColor: Theme.accentInk
                    selectByMouse: true
                    font.family: Theme.family
                    font.pixelSize: Theme.bodySize
                    Accessible.name: qsTr("Folder")
                    onAccepted: write.clicked()
                    background: Rectangle {
                        radius: Theme.radius
                        color: Theme.panel
                        border.width: folder.activeFocus ? 2 : Theme.hairline
                        border.color: folder.activeFocus ? Theme.accent : Theme.line
                    }
                }
                PushButton {
                    id: choose

                    objectName: "export.choose"
                    text: qsTr("Choose…")
                    onClicked: folderDialog.open()
                }
            }
        }
        NoticeBar {
            objectName: "export.problem"
            width: parent.width
            visible: root.exporter.state === ExportModel.Failed
            failed: true
            text: root.exporter.message
            remedy: root.exporter.remedy
        }
        Row {
            width: parent.width
            visible: root.exporter.state === ExportModel.Done
            spacing: 8

            Icon {
                name: "check"
                color: Theme.accent
            }
            BodyText {
                objectName: "export.message"
                width: parent.width - 28
                text: root.exporter.message
                wrapMode: Text.Wrap
            }
        }
        Row {
            anchors.right: parent.right
            spacing: 8

            PushButton {
                objectName: "export.close"
                text: root.exporter.state === ExportModel.Done ? qsTr("Close") : qsTr("Cancel")
                onClicked: root.close()
            }
            PushButton {
                id: write

                objectName: "export.write"
                primary: true
                enabled: root.exporter.state !== ExportModel.Writing && folder.text.length > 0
                text: root.exporter.state === ExportModel.Writing ? qsTr("Writing …") : qsTr("Write files")
                onClicked: root.exporter.writeTo(folder.text)
            }
        }
    }

    FolderDialog {
        id: folderDialog

        title: qsTr("Folder for the plan")
        onAccepted: folder.text = root.exporter.pathOf(selectedFolder)
    }
}
