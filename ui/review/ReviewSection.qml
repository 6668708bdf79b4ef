pragma ComponentBehavior: Bound
import QtQuick
import QtPositioning
import Furrow.Controls

/// What people say of the plan, and what may be said here.
Column {
    id: root

    required property ReviewModel review
    property int current: -1
    /// Where the comment that is being written belongs; not valid for the whole plan.
    property var place: QtPositioning.coordinate()
    property bool writing: false
    /// The comment whose text is being changed; none where a new one is written.
    property int editedRow: -1
    Connections {
        target: root.review

        function onMessageChanged(): void {
            if (root.review.message.length > 0)
                Qt.callLater(root.tellOf, message);
        }
        // Its rows are those of another plan.
        function onReviewChanged(): void {
            if (root.editedRow >= root.review.count)
                root.writing = false;
        }
    }

    signal commentRequested(row: int)
    signal placeRequested()
    signal sendRequested()
    signal takeInRequested()
    /// Something is said here that is to be seen.
    signal told(where: Item)

    spacing: 8

    BodyText {
        text: root.review.openCount > 0 ? qsTr("Review · %n open comment(s)", "", root.review.openCount) : qsTr("Review")
        font.pixelSize: Theme.titleSize
        font.weight: Font.DemiBold
    }
    Rectangle {
        width: parent.width
        height: verdict.height + 20
        visible: root.review.verdictText.length > 0
        radius: Theme.radius
        color: root.review.verdict === ReviewModel.Approved && !root.review.verdictIsOld ? Theme.softAccent : Theme.warningGround
        border.width: Theme.sunlight ? 1 : 0
        border.color: Theme.line

        Column {
            id: verdict

            anchors { left: parent.left; right: parent.right; margins: 12 }
            y: 10
            spacing: 2

            BodyText {
                objectName: "review.verdict"
                width: parent.width
                text: root.review.verdictText
                wrapMode: Text.WordWrap
                font.weight: Font.Medium
            }
            Caption {
                width: parent.width
                visible: root.review.verdictIsOld
                text: qsTr("The plan has changed since.")
                color: Theme.warning
                wrapMode: Text.WordWrap
            }
            SmallButton {
                x: -6
                objectName: "review.takeBack"
                text: qsTr("Take back")
                onClicked: root.review.setVerdict(ReviewModel.None)
            }
        }
    }
    Repeater {
        id: rows

        model: root.review

        CommentRow {
            required property int index

            objectName: "comment." + index
            width: root.width
            current: index === root.current
            onClicked: root.commentRequested(index)
            onSettledChosen: on => root.review.setSettled(index, on)
            onEditChosen: root.edit(index, said)
            onRemoveChosen: {
                root.writing = false;
                root.review.remove(index);
            }
        }
    }
    Column {
        id: writer

        width: parent.width
        spacing: 8
        visible: root.writing
        // With its buttons, however long the text gets.
        onHeightChanged: {
            if (root.writing)
                Qt.callLater(root.tellOf, writer);
        }

        Caption {
            width: parent.width
            text: root.editedRow >= 0 ? qsTr("Comment %1:").arg(root.editedRow + 1) : root.place.isValid ? qsTr("At the place that you clicked:") : qsTr("On the whole plan:")
        }
        TextBox {
            id: entry

            objectName: "review.text"
            width: parent.width
            name: qsTr("Comment")
            placeholderText: qsTr("What should be changed here?")
            onAccepted: root.finish()
        }
        TextEntry {
            objectName: "review.author"
            width: parent.width
            visible: root.editedRow < 0
            name: qsTr("Your name")
            placeholderText: qsTr("Your name")
            value: root.review.author
            onCommitted: entered => root.review.author = entered
        }
        Row {
            spacing: 8

            PushButton {
                objectName: "review.add"
                text: root.editedRow >= 0 ? qsTr("Change") : qsTr("Add")
                primary: true
                enabled: entry.text.trim().length > 0
                onClicked: root.finish()
            }
            PushButton {
                objectName: "review.cancel"
                text: qsTr("Cancel")
                onClicked: root.writing = false
            }
        }
    }
    Caption {
        visible: !root.writing
        text: qsTr("Comment")
    }
    Flow {
        width: parent.width
        spacing: 8
        visible: !root.writing

        PushButton {
            objectName: "review.atPlace"
            text: qsTr("On a place…")
            onClicked: root.placeRequested()
        }
        PushButton {
            objectName: "review.onPlan"
            text: qsTr("On the whole plan…")
            onClicked: root.write(QtPositioning.coordinate())
        }
        PushButton {
            objectName: "review.approve"
            text: qsTr("Approve")
            onClicked: root.review.setVerdict(ReviewModel.Approved)
        }
        PushButton {
            objectName: "review.askForChanges"
            text: qsTr("Ask for changes")
            onClicked: root.review.setVerdict(ReviewModel.ChangesWanted)
        }
        PushButton {
            objectName: "review.send"
            text: root.review.sendText
            enabled: root.review.refusal.length === 0 && !root.review.busy
            onClicked: root.sendRequested()
        }
        PushButton {
            objectName: "review.takeIn"
            visible: root.review.sent
            text: qsTr("Take in what came back…")
            enabled: !root.review.busy
            onClicked: root.takeInRequested()
        }
    }
    Rectangle {
        id: message

        objectName: "review.told"
        width: parent.width
        height: words.height + 20
        visible: root.review.message.length > 0
        radius: Theme.radius
        color: root.review.failed ? Theme.failureGround : Theme.softAccent
        border.width: Theme.sunlight ? 1 : 0
        border.color: Theme.line
        Accessible.role: Accessible.AlertMessage
        Accessible.name: root.review.message

        BodyText {
            id: words

            objectName: "review.message"
            anchors { left: parent.left; right: close.left; leftMargin: 12; rightMargin: 4 }
            y: 10
            text: root.review.message
            wrapMode: Text.Wrap
            lineHeight: 1.15
        }
        SmallButton {
            id: close

            anchors { right: parent.right; top: parent.top; margins: 6 }
            text: qsTr("Close")
            onClicked: root.review.dismiss()
        }
    }

    function tellOf(where: Item): void {
        root.forceLayout();
        root.told(where);
    }
    function write(place: var): void {
        root.begin(place, -1, "");
    }
    function edit(row: int, said: string): void {
        root.begin(QtPositioning.coordinate(), row, said);
    }
    function begin(place: var, row: int, text: string): void {
        root.place = place;
        root.editedRow = row;
        root.writing = true;
        entry.text = text;
        Qt.callLater(() => entry.forceActiveFocus(Qt.TabFocusReason));
    }
    function finish(): void {
        if (entry.text.trim().length === 0)
            return;
        if (root.editedRow >= 0)
            root.review.setText(root.editedRow, entry.text);
        else
            root.review.add(entry.text, root.place);
        entry.text = "";
        root.writing = false;
    }
}
