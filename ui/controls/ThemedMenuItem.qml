import QtQuick
import QtQuick.Templates as T

/// A line of a menu: a mark where it is on, its text, its keys.
T.MenuItem {
    id: root

    readonly property string keysText: action?.keysText ?? ""
    /// A line parts it from the one before.
    readonly property bool ruled: action?.ruled ?? false
    /// The key that runs it while the menu is open; in small. Set by the menu.
    property string letter: ""
    readonly property int letterAt: letter.length > 0 ? text.toLowerCase().indexOf(letter) : -1
    readonly property real room: ruled ? 9 : 0

    implicitWidth: Math.max(272, 28 + label.implicitWidth + 12 + keys.implicitWidth + 34)
    implicitHeight: Theme.controlHeight + room
    topPadding: room
    topInset: room
    Accessible.name: root.text

    background: Rectangle {
        radius: 6
        color: root.highlighted ? Theme.softAccent : "transparent"
        border.width: root.highlighted && Theme.sunlight ? 2 : 0
        border.color: Theme.accent
    }
    Rectangle {
        x: 8
        y: 4
        width: parent.width - 16
        height: Theme.hairline
        visible: root.ruled
        color: Theme.line
    }

    function plain(text: string): string {
        return text.replace(/&/g, "&amp;").replace(/</g, "&lt;");
    }

    contentItem: Item {
        opacity: root.enabled ? 1 : 0.45

        Icon {
            x: 6
            anchors.verticalCenter: parent.verticalCenter
            width: 16
            height: 16
            name: "check"
            color: Theme.accent
            visible: root.checkable && root.checked
        }
        BodyText {
            id: label

            anchors { left: parent.left; leftMargin: 28; right: keys.left; rightMargin: 12; verticalCenter: parent.verticalCenter }
            text: root.letterAt < 0 ? root.text : root.plain(root.text.slice(0, root.letterAt)) + "<u>" + root.plain(root.text[root.letterAt]) + "</u>" + root.plain(root.text.slice(root.letterAt + 1))
            textFormat: root.letterAt < 0 ? Text.PlainText : Text.StyledText
            elide: Text.ElideRight
        }
        BodyText {
            id: keys

            anchors { right: parent.right; rightMargin: root.subMenu ? 24 : 10; verticalCenter: parent.verticalCenter }
            text: root.keysText
            color: Theme.muted
            font.pixelSize: Theme.labelSize
        }
        Icon {
            anchors { right: parent.right; rightMargin: 4; verticalCenter: parent.verticalCenter }
            width: 16
            height: 16
            name: "chevron-right"
            color: Theme.muted
            visible: root.subMenu !== null
        }
    }
}
