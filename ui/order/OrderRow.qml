import QtQuick
import Furrow.Controls

/// One swath in driving order: a handle to drag it by, its number, its direction and its length.
Item {
    id: root

    required property int index
    required property int number
    required property string lengthText
    required property real bearing
    property bool current: false
    property bool dragged: false
    signal chosen()
    signal turned()
    signal dragBegan()
    /// In the coordinates of this row.
    signal dragMoved(y: real)
    signal dragEnded()

    height: 30
    opacity: dragged ? 0.45 : 1
    Accessible.role: Accessible.ListItem
    Accessible.name: qsTr("%1. Swath %2, %3").arg(index + 1).arg(number).arg(lengthText)

    Rectangle {
        anchors { fill: parent; topMargin: 1; bottomMargin: 1 }
        radius: 6
        color: root.current ? Theme.softAccent : hover.hovered ? Theme.hover : "transparent"
        border.width: root.current && Theme.sunlight ? 2 : 0
        border.color: Theme.accent
    }
    HoverHandler { id: hover }
    TapHandler {
        onTapped: root.chosen()
    }
    Item {
        id: handle

        width: 26
        height: parent.height

        Column {
            anchors.centerIn: parent
            spacing: 3

            Repeater {
                model: 3

                Rectangle {
                    width: 11
                    height: 1.5
                    color: Theme.muted
                }
            }
        }
        MouseArea {
            objectName: "order.handle." + root.index
            anchors.fill: parent
            preventStealing: true
            cursorShape: pressed ? Qt.ClosedHandCursor : Qt.OpenHandCursor
            onPressed: root.dragBegan()
            onPositionChanged: mouse => root.dragMoved(mouse.y)
            onReleased: root.dragEnded()
            onCanceled: root.dragEnded()
        }
    }
    Caption {
        id: place

        anchors { left: handle.right; verticalCenter: parent.verticalCenter }
        width: 32
        horizontalAlignment: Text.AlignRight
        text: root.index + 1
    }
    BodyText {
        anchors { left: place.right; leftMargin: 12; right: arrow.left; rightMargin: 6; verticalCenter: parent.verticalCenter }
        text: qsTr("Swath %1").arg(root.number)
        font.weight: root.current ? Font.DemiBold : Font.Normal
        elide: Text.ElideRight
    }
    BodyText {
        id: arrow

        anchors { right: length.left; rightMargin: 6; verticalCenter: parent.verticalCenter }
        text: "↑"
        rotation: root.bearing
        color: Theme.muted
    }
    BodyText {
        id: length

        anchors { right: turn.left; rightMargin: 4; verticalCenter: parent.verticalCenter }
        width: 58
        horizontalAlignment: Text.AlignRight
        text: root.lengthText
        color: Theme.muted
    }
    SmallButton {
        id: turn

        objectName: "order.turn." + root.index
        anchors { right: parent.right; rightMargin: 2; verticalCenter: parent.verticalCenter }
        text: "⇅"
        focusPolicy: Qt.NoFocus
        Accessible.name: qsTr("Drive swath %1 the other way").arg(root.number)
        onClicked: root.turned()
    }
}
