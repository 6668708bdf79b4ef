import QtQuick

/// The frame of what can be typed into or moved through with keys.
Rectangle {
    id: root

    required property bool focused
    property bool wrong: false

    radius: Theme.radius
    color: Theme.panel
    border.width: root.focused ? 2 : Theme.hairline
    border.color: root.wrong ? Theme.failure : root.focused ? Theme.accent : Theme.line
}
