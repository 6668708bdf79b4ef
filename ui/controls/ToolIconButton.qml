import QtQuick
import QtQuick.Templates as T

/// A square button with an icon and a hint.
T.Button {
    id: root

    required property string iconName
    /// What it does, for the hint and for screen readers.
    required property string hint
    /// Where there is no room beside it.
    property bool hintBelow: false
    /// Pressed since the pointer came: the hint is no longer needed, and would lie over what has opened.
    property bool known: false

    implicitWidth: 38
    implicitHeight: 38
    focusPolicy: Qt.TabFocus
    Accessible.name: root.hint
    onPressed: root.known = true
    onHoveredChanged: {
        if (!root.hovered)
            root.known = false;
    }

    background: Rectangle {
        radius: Theme.radius
        // Not "transparent": that is black, and would show on the way.
        color: root.checked ? Theme.softAccent : root.hovered ? Theme.hover : Qt.alpha(Theme.hover, 0)

        Behavior on color {
            ColorAnimation { duration: Theme.motion }
        }

        Focusable { control: root; gap: 0 }
    }
    contentItem: Item {
        Icon {
            anchors.centerIn: parent
            name: root.iconName
            color: root.checked ? Theme.accent : Theme.muted
            opacity: root.enabled ? 1 : 0.4
        }
    }

    T.ToolTip {
        id: tip

        x: root.hintBelow ? (root.width - width) / 2 : root.width + 8
        y: root.hintBelow ? root.height + 6 : (root.height - height) / 2
        margins: 4
        visible: root.hovered && !root.known
        delay: 500
        implicitWidth: tipText.implicitWidth + 16
        implicitHeight: tipText.implicitHeight + 10
        text: root.hint
        background: Rectangle {
            radius: 6
            color: Theme.ink
        }
        contentItem: BodyText {
            id: tipText

            text: tip.text
            color: Theme.panel
            font.pixelSize: Theme.labelSize
            horizontalAlignment: Text.AlignHCenter
            verticalAlignment: Text.AlignVCenter
        }
    }
}
