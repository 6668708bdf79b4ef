pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls
import Furrow.Files

/// For which terminal a plan is written, to which stick, and what became of it.
Column {
    id: root

    required property StickExport stick
    readonly property bool writing: stick.state === StickExport.Writing
    readonly property bool canWrite: !writing && stick.current >= 0 && (stick.replaces.length === 0 || replace.checked)

    signal finished()

    function write(): void {
        if (canWrite)
            stick.write(replace.checked);
    }

    spacing: 14

    Connections {
        target: root.stick
        function onStateChanged(): void {
            if (root.stick.state === StickExport.Done || root.stick.state === StickExport.Failed)
                Qt.callLater(root.finished);
        }
    }
    Column {
        width: parent.width
        spacing: 5

        Caption { text: qsTr("Terminal") }
        ChoiceField {
            objectName: "stick.terminal"
            width: parent.width
            name: qsTr("Terminal")
            model: root.stick.terminalNames
            chosen: root.stick.terminal
            enabled: !root.writing
            onActivated: (index) => root.stick.terminal = index
        }
        Caption {
            objectName: "stick.shows"
            width: parent.width
            text: root.stick.shows
            wrapMode: Text.WordWrap
        }
        CheckRow {
            objectName: "stick.task"
            width: parent.width
            leftPadding: 0
            visible: root.stick.hasTasks
            enabled: !root.writing
            text: qsTr("Also in a task, for terminals that show lines in tasks only")
            checked: root.stick.task
            onToggled: root.stick.task = checked
        }
    }
    Column {
        width: parent.width
        spacing: 5

        Caption { text: qsTr("Stick") }
        Caption {
            objectName: "stick.none"
            width: parent.width
            visible: root.stick.count === 0
            text: qsTr("No USB stick is plugged in. It appears here when it is; or choose a folder to carry the files yourself.")
            wrapMode: Text.WordWrap
            topPadding: 6
            bottomPadding: 6
        }
        Repeater {
            model: root.stick

            T.RadioButton {
                id: row

                required property int index
                required property string name
                required property string detail

                objectName: "stick.row." + row.index
                width: root.width
                implicitHeight: 48
                focusPolicy: Qt.StrongFocus
                enabled: !root.writing
                checked: root.stick.current === row.index
                text: row.name
                Accessible.name: row.name + ", " + row.detail
                onToggled: root.stick.current = row.index

                background: Rectangle {
                    radius: Theme.radius
                    color: row.checked ? Theme.softAccent : row.hovered ? Theme.hover : Theme.panel
                    border.width: Theme.hairline
                    border.color: row.checked ? Theme.accent : Theme.line

                    Focusable { control: row }
                }
                indicator: Rectangle {
                    x: 12
                    y: (row.height - height) / 2
                    width: 16
                    height: 16
                    radius: 8
                    color: Theme.panel
                    border.width: row.checked ? 5 : 1.4
                    border.color: row.checked ? Theme.accent : Theme.muted
                }
                contentItem: Item {
                    Column {
                        anchors { left: parent.left; right: parent.right; leftMargin: 40; rightMargin: 12; verticalCenter: parent.verticalCenter }
                        spacing: 2

                        BodyText {
                            width: parent.width
                            text: row.name
                            font.weight: Font.Medium
                            elide: Text.ElideRight
                        }
                        Caption {
                            width: parent.width
                            text: row.detail
                            elide: Text.ElideMiddle
                        }
                    }
                }
            }
        }
        SmallButton {
            objectName: "stick.folder"
            text: qsTr("Another folder…")
            enabled: !root.writing
            onClicked: folderDialog.open()
        }
    }
    Repeater {
        model: root.stick.warnings

        NoticeBar {
            required property string modelData

            objectName: "stick.warning"
            width: root.width
            text: modelData
        }
    }
    Column {
        width: parent.width
        spacing: 4
        visible: root.stick.replaces.length > 0 && root.stick.state !== StickExport.Done

        NoticeBar {
            objectName: "stick.conflict"
            width: parent.width
            text: qsTr("%1 is on it already.").arg(root.stick.replaces)
            remedy: qsTr("It will not be deleted: it is kept under another name.")
        }
        CheckRow {
            id: replace

            objectName: "stick.replace"
            width: parent.width
            text: qsTr("Keep it as a backup and write the plan")
            enabled: !root.writing
        }
    }
    ProgressLine {
        width: parent.width
        visible: root.writing
        value: root.stick.progress
    }
    NoticeBar {
        objectName: "stick.problem"
        width: parent.width
        visible: root.stick.state === StickExport.Failed
        failed: true
        text: root.stick.message
        remedy: root.stick.remedy
    }
    NoticeBar {
        objectName: "stick.failures"
        width: parent.width
        visible: text.length > 0
        failed: true
        text: root.stick.failures.join("\n")
    }
    Column {
        width: parent.width
        visible: root.stick.state === StickExport.Done
        spacing: 8

        Row {
            width: parent.width
            spacing: 8

            Icon {
                name: "check"
                color: Theme.accent
            }
            BodyText {
                objectName: "stick.message"
                width: parent.width - 28
                text: root.stick.message
                font.weight: Font.DemiBold
                wrapMode: Text.Wrap
            }
        }
        BodyText {
            objectName: "stick.writtenPlan"
            x: 28
            width: parent.width - 28
            text: root.stick.writtenPlan
            wrapMode: Text.WordWrap
            lineHeight: 1.15
        }
        Caption {
            objectName: "stick.written"
            x: 28
            width: parent.width - 28
            text: root.stick.written.slice(0, 4).join("\n") + (root.stick.written.length > 4 ? "\n" + qsTr("and %n more", "", root.stick.written.length - 4) : "")
            wrapMode: Text.WrapAnywhere
        }
        ExportChecks {
            width: parent.width
            checks: root.stick.checks
            problems: root.stick.problems
        }
        NoticeBar {
            objectName: "stick.notes"
            width: parent.width
            visible: root.stick.notes.length > 0
            text: root.stick.notes.join("\n")
        }
    }

    FileChooser {
        id: folderDialog

        objectName: "stickFolderDialog"
        fileMode: FileChooser.Folder
        title: qsTr("Folder in the place of a stick")
        onAccepted: root.stick.addFolder(selectedFolder)
    }
}
