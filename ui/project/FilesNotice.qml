import QtQuick
import Furrow.Controls

/// What happened to the project's file, and what can be done about it.
NoticeCard {
    id: root

    required property ProjectFiles files
    signal saveAsRequested()

    objectName: "filesNotice"
    visible: files.trouble !== ProjectFiles.None
    failed: files.trouble !== ProjectFiles.Restored && files.trouble !== ProjectFiles.Notes
    text: files.message
    remedy: files.remedy

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
