pragma ComponentBehavior: Bound
import QtQuick
import Furrow.Controls

/// Searches the best plan: which choices may change, how the search goes, what each choice is worth.
ThemedDialog {
    id: root

    required property BestSearch search
    readonly property bool idle: search.state === BestSearch.Idle
    readonly property bool searching: search.state === BestSearch.Searching
    readonly property bool done: search.state === BestSearch.Done

    objectName: "bestPlanDialog"
    width: 600
    title: done ? (search.isBetter ? qsTr("The best plan found") : qsTr("Your plan is the best one found")) : qsTr("Find the best plan")
    onAboutToShow: search.begin()
    onOpened: start.forceActiveFocus(Qt.TabFocusReason)
    onClosed: search.cancel()
    // What there is to do next has the keys.
    onSearchingChanged: {
        if (searching)
            closing.forceActiveFocus(Qt.TabFocusReason);
        else if (done)
            (search.isBetter ? take : closing).forceActiveFocus(Qt.TabFocusReason);
    }

    BodyText {
        width: parent.width
        visible: root.idle
        text: qsTr("Other choices are planned, and the quickest plan that can be driven is taken. Margins, overlap and what the operation needs stay as they are.")
        wrapMode: Text.WordWrap
        lineHeight: 1.15
    }
    Column {
        width: parent.width
        visible: root.idle
        spacing: 4

        Caption { text: qsTr("May change") }
        Grid {
            width: parent.width
            columns: 2
            columnSpacing: 12

            Repeater {
                model: root.search.choices

                CheckRow {
                    id: choice

                    required property int index
                    required property string name
                    required property bool free
                    required property bool given

                    objectName: "best.choice." + index
                    width: (parent.width - 12) / 2
                    text: given ? qsTr("%1 (set by you)").arg(name) : name
                    checked: free
                    onToggled: root.search.choices.setFree(index, checked)
                }
            }
        }
    }
    ProgressLine {
        objectName: "best.progress"
        width: parent.width
        visible: root.searching
        value: root.search.progress
    }
    Row {
        width: parent.width
        visible: !root.idle && root.search.bestTime.length > 0
        spacing: 24

        Column {
            spacing: 2

            Caption { text: root.done ? qsTr("Best plan") : qsTr("Best so far") }
            BodyText {
                objectName: "best.time"
                text: root.search.bestTime
                font.pixelSize: 18
                font.weight: Font.DemiBold
            }
        }
        Column {
            spacing: 2

            Caption { text: qsTr("As it was") }
            BodyText {
                text: root.search.askedTime
                font.pixelSize: 18
            }
        }
        Column {
            spacing: 2
            visible: root.search.savedTime.length > 0

            Caption { text: qsTr("Saved") }
            BodyText {
                objectName: "best.saved"
                text: root.search.savedTime
                font.pixelSize: 18
                color: Theme.accent
            }
        }
    }
    Column {
        width: parent.width
        spacing: 4
        visible: !root.idle && root.search.bestTime.length > 0 && (root.searching || root.search.isBetter)

        SearchCourse {
            width: parent.width
            course: root.search.course
            Accessible.role: Accessible.Chart
            Accessible.name: courseTitle.text
        }
        Caption {
            id: courseTitle

            text: qsTr("Time of the best plan during the search")
        }
    }
    Caption {
        width: parent.width
        visible: root.done
        text: qsTr("%n alternative(s) were planned.", "", root.search.alternatives)
    }
    Caption {
        width: parent.width
        visible: !root.idle
        text: qsTr("Times include working separately what a plan leaves.")
        wrapMode: Text.WordWrap
    }
    // Rows that a small window has no room for scroll; the buttons stay.
    ScrollArea {
        width: parent.width + 16
        height: Math.min(contentHeight, Math.max(96, (root.parent ? root.parent.height : 800) - 340))
        visible: root.done
        contentHeight: choices.implicitHeight

        ChoiceTable {
            id: choices

            x: 6
            width: parent.width - 22
            table: root.search.table
        }
    }
    NoticeBar {
        objectName: "best.failure"
        width: parent.width
        visible: root.search.state === BestSearch.Failed
        failed: true
        text: root.search.message
    }
    Row {
        anchors.right: parent.right
        spacing: 8

        PushButton {
            id: closing

            objectName: "best.close"
            // Whoever presses Return twice does not stop what has just begun.
            Keys.onReturnPressed: {
                if (!root.searching)
                    clicked();
            }
            text: root.done && !root.search.isBetter || root.search.state === BestSearch.Failed ? qsTr("Close") : qsTr("Cancel")
            onClicked: root.close()
        }
        PushButton {
            id: start

            objectName: "best.start"
            Keys.onReturnPressed: clicked()
            visible: root.idle
            primary: true
            text: qsTr("Search")
            onClicked: root.search.start()
        }
        PushButton {
            objectName: "best.keep"
            visible: root.searching
            primary: true
            enabled: root.search.isBetter
            text: qsTr("Stop and keep")
            onClicked: root.takeIt()
        }
        PushButton {
            id: take

            objectName: "best.take"
            Keys.onReturnPressed: clicked()
            visible: root.done && root.search.isBetter
            primary: true
            text: qsTr("Use this plan")
            onClicked: root.takeIt()
        }
    }

    function takeIt(): void {
        root.search.take();
        root.close();
    }
}
