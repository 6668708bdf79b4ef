import QtQuick
import QtQuick.Templates as T

T.Button {
    id: root

    property bool primary: false
    property string iconName: ""

    implicitWidth: Math.max(row.implicitWidth + 28, 64)
    implicitHeight: Theme.controlHeight
    focusPolicy: Qt.StrongFocus
    font.family: Theme.family
    font.pixelSize: Theme.bodySize
    font.weight: Font.Medium
    Accessible.name: root.text

    background: Rectangle {
        radius: Theme.radius
        color: root.primary ? (root.hovered ? Theme.accentHover : Theme.accent) : (root.down || root.hovered ? Theme.hover : Theme.panel)
        border.width: root.primary ? 0 : Theme.hairline
        border.color: Theme.line
        opacity: root.enabled ? 1 : 0.45

        Behavior on color {
            ColorAnimation { duration: Theme.motion }
        }

        Focusable { control: root }
    }
    contentItem: Item {
        Row {
            id: row

            anchors.centerIn: parent
            spacing: 8

            Icon {
                anchors.verticalCenter: parent.verticalCenter
                visible: root.iconName.length > 0
                width: 18
                height: 18
                name: root.iconName
                color: label.color
            }
            BodyText {
                id: label

                anchors.verticalCenter: parent.verticalCenter
                text: root.text
                font: root.font
                color: root.primary ? Theme.accentInk : Theme.ink
                opacity: root.enabled ? 1 : 0.6
            }
        }
    }
}
