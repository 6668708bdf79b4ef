pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// The order of the swaths as a list that is dragged into another order, or by clicks on the map.
Column {
    id: root

    required property SwathOrder order
    property int dragFrom: -1
    property int dragTo: -1
    readonly property int rowHeight: 30
    /// A row was chosen: its swath is to be shown on the map.
    signal swathChosen(segment: int)
    /// There is more of it than before: it should be in view.
    signal grown()

    spacing: 8
    Component.onDestruction: root.order.pointing = false

    PushButton {
        id: begin

        objectName: "order.begin"
        width: parent.width
        visible: !root.order.pointing
        enabled: root.order.count > 1
        text: qsTr("Change the order by hand…")
        onClicked: {
            root.order.pointing = true;
            list.forceActiveFocus(begin.visualFocus ? Qt.TabFocusReason : Qt.MouseFocusReason);
            root.grown();
        }
    }
    Caption {
        width: parent.width
        visible: root.order.pointing
        text: qsTr("Drag a swath to its new place. Or click swaths on the map: each is driven after the one clicked before.")
        wrapMode: Text.WordWrap
        lineHeight: 1.15
    }
    EntryFrame {
        width: parent.width
        height: list.height + 8
        visible: root.order.pointing
        focused: list.activeFocus

        ListView {
            id: list

            objectName: "order.list"
            anchors { left: parent.left; right: parent.right; top: parent.top; margins: 4 }
            height: Math.min(9.5, root.order.count) * root.rowHeight
            clip: true
            boundsBehavior: Flickable.StopAtBounds
            model: root.order
            currentIndex: root.order.current
            highlightFollowsCurrentItem: true
            highlightMoveDuration: 0
            activeFocusOnTab: true
            Accessible.role: Accessible.List
            Accessible.name: qsTr("Order of swaths")

            Keys.onPressed: event => {
                const step = event.key === Qt.Key_Up ? -1 : event.key === Qt.Key_Down ? 1 : 0;
                const row = root.order.current;
                if (step !== 0 && event.modifiers & Qt.AltModifier) {
                    if (row >= 0 && row + step >= 0 && row + step < root.order.count)
                        root.order.move(row, row + step);
                    event.accepted = true;
                } else if (step !== 0) {
                    root.choose(Math.max(0, Math.min(root.order.count - 1, row + step)));
                    event.accepted = true;
                } else if (event.key === Qt.Key_Space && row >= 0) {
                    root.order.turn(row);
                    event.accepted = true;
                }
            }

            T.ScrollBar.vertical: T.ScrollBar {
                id: bar

                width: 6
                policy: list.contentHeight > list.height ? T.ScrollBar.AlwaysOn : T.ScrollBar.AlwaysOff
                contentItem: Rectangle {
                    radius: 3
                    color: bar.pressed ? Theme.muted : Theme.line
                }
            }
            delegate: OrderRow {
                id: row

                objectName: "order.row." + index
                width: ListView.view.width - 8
                current: index === root.order.current
                dragged: index === root.dragFrom
                onChosen: {
                    list.forceActiveFocus(Qt.MouseFocusReason);
                    root.choose(index);
                }
                onTurned: root.order.turn(index)
                onDragBegan: {
                    root.dragFrom = index;
                    root.dragTo = index;
                }
                onDragMoved: y => root.dragOver(row.mapToItem(list, 0, y).y)
                onDragEnded: root.drop()
            }

            // Where the dragged row would go.
            Rectangle {
                parent: list.contentItem
                visible: root.dragFrom >= 0 && root.dragTo !== root.dragFrom
                y: (root.dragTo > root.dragFrom ? root.dragTo + 1 : root.dragTo) * root.rowHeight - 1
                width: list.width - 8
                height: 2
                radius: 1
                color: Theme.accent
                z: 2
            }
        }
    }
    Flow {
        width: parent.width
        visible: root.order.pointing
        spacing: 4

        SmallButton {
            objectName: "order.done"
            text: qsTr("Done")
            onClicked: root.order.pointing = false
        }
        SmallButton {
            objectName: "order.searchOthers"
            visible: root.order.pointedCount > 1
            text: qsTr("Search the order of the others")
            onClicked: root.order.searchOthers()
        }
        SmallButton {
            objectName: "order.searchAll"
            visible: root.order.byHand
            text: qsTr("Search the order again")
            onClicked: root.order.searchAll()
        }
    }

    function choose(row: int): void {
        root.order.current = row;
        list.positionViewAtIndex(row, ListView.Contain);
        root.swathChosen(root.order.segmentOf(row));
    }
    function dragOver(y: real): void {
        if (y < 12)
            list.contentY = Math.max(0, list.contentY - 8);
        else if (y > list.height - 12)
            list.contentY = Math.min(Math.max(0, list.contentHeight - list.height), list.contentY + 8);
        root.dragTo = Math.max(0, Math.min(root.order.count - 1, Math.floor((y + list.contentY) / root.rowHeight)));
    }
    function drop(): void {
        const from = root.dragFrom;
        const to = root.dragTo;
        root.dragFrom = -1;
        root.dragTo = -1;
        if (from >= 0 && from !== to)
            root.order.move(from, to);
    }
}
