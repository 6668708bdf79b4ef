import QtQuick
import QtQuick.Templates as T
import Furrow.Controls
import Furrow.Files

/// Asks where a review is written to, which one came back, and what becomes of one that is opened like a project.
Item {
    id: root

    required property ReviewModel review
    /// A file that is being opened, and how it is opened as a project.
    property url opened
    property var openIt: null
    signal takenIn()
    signal sent()

    function send(): void {
        sendDialog.selectedFile = root.review.suggestedFile();
        sendDialog.open();
    }
    function takeIn(): void {
        takeInDialog.open();
    }
    /// Opens a file with `openIt`, or takes it in where it is a review of this project and the user wants that.
    function offer(file: url, openIt: var): void {
        if (!root.review.expectsReviews() || root.review.busy) {
            openIt();
            return;
        }
        root.opened = file;
        root.openIt = openIt;
        root.review.look(file);
    }
    function goOn(): void {
        const openIt = root.openIt;
        root.openIt = null;
        if (openIt)
            openIt();
    }

    Connections {
        target: root.review

        function onLookedAt(isReviewOfThis: bool): void {
            if (isReviewOfThis)
                offerDialog.open();
            else
                root.goOn();
        }
    }
    ThemedDialog {
        id: offerDialog

        objectName: "reviewOfferDialog"
        anchors.centerIn: T.Overlay.overlay
        title: qsTr("Take in this review?")
        onOpened: takeButton.forceActiveFocus()

        BodyText {
            width: parent.width
            text: qsTr("The file is a review of a plan of the project that is open. Its comments can be taken in here.")
            wrapMode: Text.WordWrap
            lineHeight: 1.2
        }
        Flow {
            width: parent.width
            topPadding: 8
            spacing: 8
            layoutDirection: Qt.RightToLeft

            PushButton {
                id: takeButton

                objectName: "reviewOffer.take"
                text: qsTr("Take in")
                primary: true
                onClicked: {
                    root.openIt = null;
                    offerDialog.close();
                    root.review.takeIn(root.opened);
                    root.takenIn();
                }
            }
            PushButton {
                objectName: "reviewOffer.open"
                text: qsTr("Open by itself")
                onClicked: {
                    offerDialog.close();
                    root.goOn();
                }
            }
            PushButton {
                objectName: "reviewOffer.cancel"
                text: qsTr("Cancel")
                onClicked: {
                    root.openIt = null;
                    offerDialog.close();
                }
            }
        }
    }

    FileChooser {
        id: sendDialog

        objectName: "reviewSendDialog"
        title: qsTr("Send for review")
        fileMode: FileChooser.SaveFile
        defaultSuffix: "furrow"
        nameFilters: [qsTr("Review files (%1)").arg("*.furrow *.geojson")]
        onAccepted: {
            root.review.send(selectedFile);
            root.sent();
        }
    }
    FileChooser {
        id: takeInDialog

        objectName: "reviewTakeInDialog"
        title: qsTr("Take in what came back")
        fileMode: FileChooser.OpenFile
        nameFilters: [qsTr("Review files (%1)").arg("*.furrow *.geojson"), qsTr("All files (*)")]
        onAccepted: root.review.takeIn(selectedFile)
    }
}
