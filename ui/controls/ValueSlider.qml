import QtQuick
import QtQuick.Templates as T

/// A slider whose value counts while it is dragged.
T.Slider {
    id: root

    required property string name

    implicitWidth: 200
    implicitHeight: 24
    containmentMask: Item {
        y: (root.height - height) / 2
        width: root.width
        height: Theme.controlHeight
    }
    live: true
    focusPolicy: Qt.StrongFocus
    Accessible.name: root.name

    background: Rectangle {
        x: root.leftPadding
        y: (root.height - height) / 2
        width: root.availableWidth
        height: 5
        radius: 2.5
        color: Theme.line

        Rectangle {
            width: root.visualPosition * parent.width
            height: parent.height
            radius: 2.5
            color: Theme.accent
        }
    }
    handle: Rectangle {
        x: root.leftPadding + root.visualPosition * (root.availableWidth - width)
        y: (root.height - height) / 2
        width: 18
        height: 18
        radius: 9
        color: Theme.panel
        border.width: 3
        border.color: Theme.accent

        Focusable { control: root; radius: width / 2 }
    }
}
