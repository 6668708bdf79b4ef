pragma ComponentBehavior: Bound
import QtQuick

/// The shadow of a card that floats on the map; fills the card's own place, below it.
Item {
    id: root

    property real radius: Theme.cardRadius

    anchors.fill: parent
    z: -1

    Repeater {
        model: 5

        Rectangle {
            required property int index

            anchors { fill: parent; topMargin: 2 - index; bottomMargin: -3 - index * 1.6; leftMargin: -index - 0.5; rightMargin: -index - 0.5 }
            radius: root.radius + index + 1
            color: Theme.shadow
        }
    }
}
