import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// Looks like a field to search in, and opens the command palette.
T.Button {
    id: root

    implicitWidth: 236
    implicitHeight: 34
    focusPolicy: Qt.StrongFocus
    Accessible.name: qsTr("Search commands")

    background: Rectangle {
        radius: Theme.radius
        color: root.hovered ? Theme.hover : Theme.panel
        border.width: Theme.hairline
        border.color: Theme.line

        Focusable { control: root }
    }
    contentItem: Item {
        BodyText {
            anchors { left: parent.left; leftMargin: 12; verticalCenter: parent.verticalCenter }
            text: qsTr("Search commands")
            color: Theme.muted
        }
        Rectangle {
            anchors { right: parent.right; rightMargin: 8; verticalCenter: parent.verticalCenter }
            width: keys.implicitWidth + 12
            height: 20
            radius: 5
            color: Theme.sunken

            Caption {
                id: keys

                anchors.centerIn: parent
                text: qsTr("Ctrl K")
            }
        }
    }
}
