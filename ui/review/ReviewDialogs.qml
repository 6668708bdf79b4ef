import QtQuick
import QtQuick.Dialogs

/// Asks where a review is written to, and which one came back.
Item {
    id: root

    required property ReviewModel review

    function send(): void {
        sendDialog.selectedFile = root.review.suggestedFile();
        sendDialog.open();
    }
    function takeIn(): void {
        takeInDialog.open();
    }

    FileDialog {
        id: sendDialog

        objectName: "reviewSendDialog"
        title: qsTr("Send for review")
        fileMode: FileDialog.SaveFile
        defaultSuffix: "furrow"
        nameFilters: [qsTr("Review files (%1)").arg("*.furrow *.geojson")]
        onAccepted: root.review.send(selectedFile)
    }
    FileDialog {
        id: takeInDialog

        objectName: "reviewTakeInDialog"
        title: qsTr("Take in what came back")
        fileMode: FileDialog.OpenFile
        nameFilters: [qsTr("Review files (%1)").arg("*.furrow *.geojson"), qsTr("All files (*)")]
        onAccepted: root.review.takeIn(selectedFile)
    }
}
