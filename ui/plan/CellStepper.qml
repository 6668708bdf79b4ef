import QtQuick
import Furrow.Controls

/// What cutting the mainland and joining cells came to, and a way through the joins, one after the other on the map.
Column {
    id: root

    required property CellSteps cells
    readonly property bool stepping: cells.current >= 0

    spacing: 8
    Component.onDestruction: root.cells.current = -1

    Shortcut {
        sequence: "Escape"
        enabled: root.stepping
        onActivated: root.leave()
    }
    BodyText {
        objectName: "cells.summary"
        width: parent.width
        text: root.cells.summary
        wrapMode: Text.WordWrap
    }
    Caption {
        width: parent.width
        text: [qsTr("Turns and ways from block to block, estimated."), root.cells.remark].filter(part => part.length > 0).join(" ")
        wrapMode: Text.WordWrap
        lineHeight: 1.15
    }
    PushButton {
        id: show

        objectName: "cells.show"
        width: parent.width
        visible: !root.stepping
        text: root.cells.count > 1 ? qsTr("Go through the steps") : qsTr("Show the blocks")
        onClicked: {
            const reason = show.visualFocus ? Qt.TabFocusReason : Qt.MouseFocusReason;
            root.cells.current = 0;
            (root.cells.count > 1 ? next : done).forceActiveFocus(reason);
        }
    }
    Row {
        width: parent.width
        visible: root.stepping && root.cells.count > 1
        spacing: 8

        ToolIconButton {
            id: previous

            objectName: "cells.previous"
            iconName: "chevron-left"
            hint: qsTr("Previous step")
            hintBelow: true
            enabled: root.cells.current > 0
            onClicked: root.cells.current -= 1
        }
        ValueSlider {
            objectName: "cells.slider"
            anchors.verticalCenter: parent.verticalCenter
            width: parent.width - previous.width - next.width - 16
            name: qsTr("Step of the blocks")
            to: Math.max(1, root.cells.count - 1)
            stepSize: 1
            snapMode: ValueSlider.SnapAlways
            value: Math.max(0, root.cells.current)
            onMoved: root.cells.current = Math.round(value)
        }
        ToolIconButton {
            id: next

            objectName: "cells.next"
            iconName: "chevron-right"
            hint: qsTr("Next step")
            hintBelow: true
            enabled: root.cells.current + 1 < root.cells.count
            onClicked: root.cells.current += 1
        }
    }
    Item {
        width: parent.width
        height: Math.max(told.height, done.height)
        visible: root.stepping

        Column {
            id: told

            width: parent.width - done.width - 8
            spacing: 2

            BodyText {
                objectName: "cells.current"
                width: parent.width
                text: root.cells.currentText
                wrapMode: Text.WordWrap
            }
            Caption {
                objectName: "cells.join"
                width: parent.width
                text: root.cells.joinText
                wrapMode: Text.WordWrap
                lineHeight: 1.15
            }
        }
        SmallButton {
            id: done

            objectName: "cells.done"
            anchors { right: parent.right; rightMargin: -6 }
            text: qsTr("Done")
            onClicked: root.leave()
        }
    }

    function leave(): void {
        root.cells.current = -1;
        show.forceActiveFocus();
    }
}
