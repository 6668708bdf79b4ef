pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls
import Furrow.Plan

/// A plan, or those of several fields, on their way out: to a stick for a terminal, or as files in a folder.
T.Popup {
    id: root

    required property ExportModel exporter
    required property Planning planning
    readonly property StickExport stick: exporter.stick
    /// There is no finished plan of what the panels show.
    readonly property bool refused: exporter.refusal.length > 0
    readonly property real windowHeight: parent ? parent.height : 800
    readonly property bool writing: exporter.state === ExportModel.Writing || stick.state === StickExport.Writing
    readonly property bool done: onStick.checked ? stick.state === StickExport.Done : exporter.state === ExportModel.Done

    objectName: "exportDialog"
    modal: true
    focus: true
    width: 520
    height: Math.min(head.implicitHeight + page.implicitHeight + buttons.implicitHeight + 28 + 2 * padding, windowHeight - 32)
    padding: 24
    closePolicy: writing ? T.Popup.NoAutoClose : T.Popup.CloseOnEscape | T.Popup.CloseOnPressOutside
    onAboutToShow: {
        scroller.toEnd = false;
        stick.clear();
        stick.searching = true;
        folderPage.begin();
        onStick.checked = stick.count > 0;
        inFolder.checked = stick.count === 0;
    }
    onAboutToHide: stick.searching = false

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
    contentItem: Item {
        Column {
            id: head

            width: parent.width
            spacing: 14

            BodyText {
                text: root.exporter.several ? qsTr("Export fields") : qsTr("Export the plan")
                font.pixelSize: 18
                font.weight: Font.DemiBold
            }
            Column {
                width: parent.width
                visible: root.exporter.heading.length > 0
                spacing: 2

                BodyText {
                    objectName: "export.heading"
                    width: parent.width
                    text: root.exporter.heading
                    font.weight: Font.DemiBold
                    wrapMode: Text.Wrap
                }
                Caption {
                    objectName: "export.details"
                    width: parent.width
                    text: root.exporter.details
                    wrapMode: Text.WordWrap
                    lineHeight: 1.15
                }
            }
            Row {
                spacing: 4

                ExportTab {
                    id: onStick

                    objectName: "export.onStick"
                    text: qsTr("USB stick")
                    enabled: !root.writing
                }
                ExportTab {
                    id: inFolder

                    objectName: "export.inFolder"
                    text: qsTr("Files in a folder")
                    enabled: !root.writing
                    checked: true
                }
            }
            NoticeBar {
                objectName: "export.refusal"
                width: parent.width
                visible: root.refused
                text: root.exporter.refusal
            }
            PushButton {
                objectName: "export.planAgain"
                visible: !root.exporter.several && root.planning.state === PlanState.OutOfDate
                text: qsTr("Plan again")
                onClicked: root.planning.planAgain()
            }
            NoticeBar {
                objectName: "export.blocking"
                width: parent.width
                visible: !root.exporter.several && root.planning.state === PlanState.Problems
                text: qsTr("%n problem(s) in this plan: it cannot be driven as drawn. The files say so too.", "", root.planning.problemCount)
            }
        }
        // What does not fit a small window scrolls; the buttons stay.
        Flickable {
            id: scroller

            // The bar has its place in the padding, so that the page keeps its width.
            anchors { left: parent.left; right: parent.right; rightMargin: -16; top: head.bottom; bottom: buttons.top; topMargin: 14; bottomMargin: 14 }
            clip: true
            contentHeight: page.implicitHeight
            boundsBehavior: Flickable.StopAtBounds
            // Fractions of a pixel are nothing to scroll for.
            interactive: contentHeight > height + 1
            onContentHeightChanged: {
                if (toEnd)
                    showEnd();
            }
            onMovementStarted: toEnd = false

            /// What came of it stands at the end, which grows with it.
            property bool toEnd: false

            function showEnd(): void {
                toEnd = true;
                contentY = Math.max(0, contentHeight - height);
            }

            T.ScrollBar.vertical: T.ScrollBar {
                id: bar

                policy: scroller.interactive ? T.ScrollBar.AlwaysOn : T.ScrollBar.AlwaysOff
                visible: scroller.interactive
                implicitWidth: 8
                contentItem: Rectangle {
                    radius: 4
                    color: bar.pressed ? Theme.muted : Theme.line
                }
            }

            Column {
                id: page

                width: head.width

                ExportStickPage {
                    id: stickPage

                    width: parent.width
                    visible: onStick.checked
                    stick: root.stick
                    onFinished: scroller.showEnd()
                }
                ExportFolderPage {
                    id: folderPage

                    width: parent.width
                    visible: inFolder.checked
                    exporter: root.exporter
                    onFinished: scroller.showEnd()
                    // Not two things that scroll, one in the other, where there is little room.
                    roomForFormats: windowHeight < 480 ? 1e6 : Math.max(160, windowHeight - 430)
                }
            }
        }
        Row {
            id: buttons

            anchors { right: parent.right; bottom: parent.bottom }
            spacing: 8

            PushButton {
                objectName: "export.close"
                text: root.writing ? qsTr("Stop") : root.done ? qsTr("Close") : qsTr("Cancel")
                onClicked: {
                    if (root.stick.state === StickExport.Writing)
                        root.stick.cancel();
                    else if (root.exporter.state === ExportModel.Writing)
                        root.exporter.cancel();
                    else
                        root.close();
                }
            }
            PushButton {
                objectName: "export.write"
                primary: true
                enabled: !root.refused && (onStick.checked ? stickPage.canWrite : folderPage.canWrite)
                text: root.writing ? qsTr("Writing …") : onStick.checked ? qsTr("Write to the stick") : qsTr("Write files")
                onClicked: onStick.checked ? stickPage.write() : folderPage.write()
            }
        }
    }
}
