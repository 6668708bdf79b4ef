import QtQuick

/// How much of something long is done.
Rectangle {
    id: root

    /// In [0, 1].
    required property real value

    implicitHeight: 6
    radius: 3
    color: Theme.line
    Accessible.role: Accessible.ProgressBar

    Rectangle {
        width: parent.width * root.value
        height: parent.height
        radius: 3
        color: Theme.accent
    }
}
