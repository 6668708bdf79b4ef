pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls
import Furrow.Files

/// Which files a plan is written to, and in which folder.
Column {
    id: root

    required property ExportModel exporter
    /// What the list of formats may take of the window's height.
    required property real roomForFormats
    readonly property bool canWrite: exporter.state !== ExportModel.Writing && folder.text.length > 0

    signal finished()

    /// As suggested last: what the user chose is kept, but not for another field.
    property string suggested: ""

    function begin(): void {
        exporter.clear();
        suggest();
    }
    function suggest(): void {
        const folderOfPlan = exporter.suggestedFolder();
        if (exporter.heading.length > 0 && folderOfPlan !== suggested) {
            suggested = folderOfPlan;
            folder.text = folderOfPlan;
        }
    }
    function write(): void {
        if (canWrite)
            exporter.writeTo(folder.text);
    }

    spacing: 14

    Connections {
        target: root.exporter
        function onPlanChanged(): void {
            root.suggest();
        }
        function onStateChanged(): void {
            if (root.exporter.several && (root.exporter.state === ExportModel.Done || root.exporter.state === ExportModel.Failed))
                Qt.callLater(root.finished);
        }
    }
    BodyText {
        width: parent.width
        visible: root.exporter.several
        text: qsTr("Fields without a plan are planned on the way. Each field gets a folder of its own; ISOXML and AgGPS hold all fields in one.")
        color: Theme.muted
        wrapMode: Text.WordWrap
    }
    ListView {
        id: list

        objectName: "export.formats"
        width: parent.width
        height: Math.min(contentHeight, root.roomForFormats)
        clip: true
        boundsBehavior: Flickable.StopAtBounds
        model: root.exporter
        spacing: 4
        // All of them at once: there are few, and their heights differ.
        cacheBuffer: 4000
        delegate: Column {
            id: format

            required property int index
            required property string name
            required property string hint
            required property bool checked

            width: ListView.view.width - 12

            CheckRow {
                objectName: "export.format." + format.index
                width: parent.width
                leftPadding: 0
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
        T.ScrollBar.vertical: T.ScrollBar {
            id: bar

            policy: list.contentHeight > list.height ? T.ScrollBar.AlwaysOn : T.ScrollBar.AlwaysOff
            visible: list.contentHeight > list.height
            implicitWidth: 8
            contentItem: Rectangle {
                radius: 4
                color: bar.pressed ? Theme.muted : Theme.line
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
                onAccepted: root.write()
                background: EntryFrame {
                    focused: folder.activeFocus
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
    ProgressLine {
        objectName: "export.progress"
        width: parent.width
        visible: root.exporter.several && root.exporter.state === ExportModel.Writing
        value: root.exporter.progress
    }
    NoticeBar {
        objectName: "export.problem"
        width: parent.width
        visible: root.exporter.state === ExportModel.Failed
        failed: true
        text: root.exporter.message
        remedy: root.exporter.remedy
    }
    NoticeBar {
        objectName: "export.failures"
        width: parent.width
        visible: text.length > 0
        failed: true
        text: root.exporter.failures.join("\n")
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
    Caption {
        objectName: "export.written"
        x: 28
        width: parent.width - 28
        visible: root.exporter.state === ExportModel.Done && text.length > 0
        text: root.exporter.written
        wrapMode: Text.WordWrap
        lineHeight: 1.15
    }
    ExportChecks {
        width: parent.width
        visible: root.exporter.state === ExportModel.Done
        checks: root.exporter.checks
        problems: root.exporter.problems
    }
    NoticeBar {
        objectName: "export.notes"
        width: parent.width
        visible: root.exporter.state === ExportModel.Done && root.exporter.notes.length > 0
        text: root.exporter.notes.join("\n")
    }

    FileChooser {
        id: folderDialog

        objectName: "exportFolderDialog"
        fileMode: FileChooser.Folder
        title: qsTr("Folder for the plan")
        onAccepted: folder.text = root.exporter.pathOf(selectedFolder)
    }
}
