import QtQuick
import Furrow.Controls

/// What was looked at in written files before they were written, and what a receiver would stumble over.
Column {
    id: root

    required property int checks
    required property list<string> problems

    spacing: 8

    Row {
        width: parent.width
        visible: root.problems.length === 0 && root.checks > 0
        spacing: 8

        Icon {
            name: "check"
            color: Theme.accent
        }
        BodyText {
            objectName: "export.checked"
            width: parent.width - 28
            text: qsTr("%n check(s) passed: nothing in the files that receivers stumble over.", "", root.checks)
            wrapMode: Text.Wrap
        }
    }
    NoticeBar {
        objectName: "export.mistakes"
        width: parent.width
        visible: root.problems.length > 0
        failed: true
        text: root.problems.join("\n")
        remedy: qsTr("Choose another format or terminal, and report this.")
    }
}
