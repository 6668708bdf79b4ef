import QtQuick
import QtQuick.Templates as T

/// A quiet button that is only text, as "Auto" beside a number.
T.Button {
    id: root

    implicitWidth: label.implicitWidth + 12
    implicitHeight: 24
    focusPolicy: Qt.StrongFocus
    Accessible.name: root.text
    // A finger needs more than the text.
    containmentMask: Item {
        x: -4
        y: (root.height - height) / 2
        width: root.width + 8
        height: Math.max(root.height, Theme.controlHeight)
    }

    background: Rectangle {
        radius: 6
        color: root.hovered ? Theme.softAccent : "transparent"

        Focusable { control: root; gap: 0 }
    }
    contentItem: BodyText {
        id: label

        text: root.text
        font.pixelSize: Theme.labelSize
        font.weight: Font.Medium
        color: Theme.accent
        horizontalAlignment: Text.AlignHCenter
        verticalAlignment: Text.AlignVCenter
    }
}
