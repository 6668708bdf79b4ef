pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// One part of where the user is, with a menu of the others.
T.Button {
    id: root

    required property list<string> choices
    required property int current
    property bool strong: false
    /// Below the choices.
    property list<Command> commands
    signal chosen(index: int)

    implicitWidth: label.implicitWidth + 34
    implicitHeight: 34
    focusPolicy: Qt.StrongFocus
    Accessible.name: root.text
    onClicked: menu.popup(0, height + 2)

    background: Rectangle {
        radius: Theme.radius
        color: root.hovered || menu.visible ? Theme.hover : "transparent"

        Focusable { control: root; gap: 0 }
    }
    contentItem: Item {
        BodyText {
            id: label

            anchors { left: parent.left; leftMargin: 8; right: arrow.left; rightMargin: 2; verticalCenter: parent.verticalCenter }
            text: root.text
            font.weight: root.strong ? Font.DemiBold : Font.Normal
            color: root.strong ? Theme.ink : Theme.muted
            elide: Text.ElideRight
        }
        Icon {
            id: arrow

            anchors { right: parent.right; rightMargin: 6; verticalCenter: parent.verticalCenter }
            width: 14
            height: 14
            name: "chevron-down"
            color: Theme.muted
        }
    }
    ThemedMenu {
        id: menu

        Instantiator {
            model: root.choices
            delegate: ThemedMenuItem {
                required property int index
                required property string modelData

                objectName: root.objectName + "." + index
                text: modelData
                checkable: true
                checked: index === root.current
                onTriggered: root.chosen(index)
            }
            onObjectAdded: (index, object) => menu.insertItem(index, object as ThemedMenuItem)
            onObjectRemoved: (index, object) => menu.removeItem(object as ThemedMenuItem)
        }
        T.MenuSeparator {
            implicitHeight: 9
            contentItem: Rectangle {
                implicitHeight: Theme.hairline
                color: Theme.line
            }
            background: null
            topPadding: 4
            bottomPadding: 4
        }
        Instantiator {
            model: root.commands
            delegate: ThemedMenuItem {
                required property Command modelData

                action: modelData
            }
            onObjectAdded: (index, object) => menu.addItem(object as ThemedMenuItem)
            onObjectRemoved: (index, object) => menu.removeItem(object as ThemedMenuItem)
        }
    }
}
