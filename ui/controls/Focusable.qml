import QtQuick

/// The ring around the control that has the keyboard.
Rectangle {
    required property Item control
    property real gap: 2

    anchors.fill: parent
    anchors.margins: -gap
    radius: Theme.radius + gap
    color: "transparent"
    border.width: 2
    border.color: Theme.accent
    visible: control.visualFocus ?? control.activeFocus
}
