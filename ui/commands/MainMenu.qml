pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// The menu bar: every command of the window, by its group.
T.MenuBar {
    id: root

    required property AppCommands commands
    required property T.Menu recent

    objectName: "menuBar"
    implicitWidth: contentItem.implicitWidth
    implicitHeight: Theme.controlHeight
    leftPadding: 8

    component Group: ThemedMenu {
        id: menu

        required property string group

        objectName: "menu." + group
        title: group

        Instantiator {
            model: root.commands.inGroup(menu.group)
            delegate: ThemedMenuItem {
                required property Command modelData

                objectName: modelData.objectName + ".item"
                action: modelData
            }
            onObjectAdded: (index, object) => menu.insertItem(index, object as ThemedMenuItem)
            onObjectRemoved: (index, object) => menu.removeItem(object as ThemedMenuItem)
        }
    }

    background: Rectangle {
        color: Theme.panel
    }
    contentItem: Row {
        spacing: 0

        Repeater { model: root.contentModel }
    }
    delegate: T.MenuBarItem {
        id: entry

        objectName: menu ? "bar." + menu.title : ""
        implicitWidth: label.implicitWidth + 20
        implicitHeight: Theme.controlHeight
        Accessible.name: text
        background: Rectangle {
            anchors { fill: parent; margins: 3 }
            radius: 6
            color: entry.highlighted || entry.hovered ? Theme.hover : "transparent"
            border.width: entry.highlighted && Theme.sunlight ? 2 : 0
        }
        contentItem: BodyText {
            id: label

            text: entry.text.replace("&", "")
            horizontalAlignment: Text.AlignHCenter
            verticalAlignment: Text.AlignVCenter
        }
    }

    Group {
        group: root.commands.fileGroup
        Component.onCompleted: insertMenu(2, root.recent)
    }
    Group { group: root.commands.editGroup }
    Group { group: root.commands.fieldGroup }
    Group { group: root.commands.planGroup }
    Group { group: root.commands.viewGroup }
    Group { group: root.commands.helpGroup }
}
