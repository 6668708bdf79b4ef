import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// The head of a column: sorts by it.
T.Button {
    id: root

    required property FarmList fields
    required property int column
    readonly property bool chosen: fields.sorted && fields.sortedBy === column

    implicitHeight: Theme.controlHeight
    focusPolicy: Qt.TabFocus
    Accessible.name: chosen ? (fields.descending ? qsTr("%1, sorted downwards").arg(text) : qsTr("%1, sorted").arg(text)) : text
    onClicked: fields.sortBy(column)

    background: Rectangle {
        radius: 6
        color: root.hovered ? Theme.hover : "transparent"

        Focusable { control: root; gap: 0 }
    }
    contentItem: Item {
        Caption {
            anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter }
            text: root.chosen ? root.text + (root.fields.descending ? " ↓" : " ↑") : root.text
            color: root.chosen ? Theme.ink : Theme.muted
            font.weight: Font.Medium
            elide: Text.ElideRight
        }
    }
}
