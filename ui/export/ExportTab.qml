import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// One of the ways to export, as a tab.
T.AbstractButton {
    id: root

    implicitWidth: label.implicitWidth + 28
    implicitHeight: Theme.controlHeight
    focusPolicy: Qt.StrongFocus
    checkable: true
    autoExclusive: true
    Accessible.role: Accessible.PageTab
    Accessible.name: root.text

    background: Rectangle {
        radius: Theme.radius
        color: root.checked ? Theme.softAccent : root.hovered ? Theme.hover : "transparent"
        border.width: root.checked && Theme.sunlight ? Theme.hairline : 0
        border.color: Theme.line

        Focusable { control: root }
    }
    contentItem: BodyText {
        id: label

        text: root.text
        font.weight: root.checked ? Font.DemiBold : Font.Normal
        color: root.checked ? Theme.accent : Theme.ink
        horizontalAlignment: Text.AlignHCenter
        verticalAlignment: Text.AlignVCenter
    }
}
