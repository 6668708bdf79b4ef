import QtQuick
import QtQuick.Templates as T

/// A line with a box to tick and, where it stands for a map layer, a swatch of its colour.
T.CheckBox {
    id: root

    property color swatch: "transparent"
    property bool hasSwatch: false

    implicitWidth: 26 + (hasSwatch ? 26 : 0) + label.implicitWidth
    implicitHeight: Theme.controlHeight
    focusPolicy: Qt.StrongFocus
    Accessible.name: root.text

    background: Rectangle {
        radius: 6
        anchors.fill: parent
        anchors.leftMargin: -6
        color: root.hovered ? Theme.hover : "transparent"
    }
    indicator: Rectangle {
        y: (root.height - height) / 2
        width: 16
        height: 16
        radius: 4
        color: root.checked ? Theme.accent : Theme.panel
        border.width: root.checked ? 0 : 1.4
        border.color: Theme.muted

        Icon {
            anchors.centerIn: parent
            width: 14
            height: 14
            name: "check"
            color: Theme.accentInk
            visible: root.checked
        }
        Focusable { control: root; radius: 6 }
    }
    contentItem: Item {
        Rectangle {
            id: line

            x: 26
            anchors.verticalCenter: parent.verticalCenter
            width: root.hasSwatch ? 16 : 0
            height: 3.5
            radius: 1.75
            color: root.swatch
        }
        BodyText {
            id: label

            anchors { left: line.right; leftMargin: root.hasSwatch ? 10 : 0; right: parent.right; verticalCenter: parent.verticalCenter }
            text: root.text
            elide: Text.ElideRight
        }
    }
}
