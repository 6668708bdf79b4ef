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

    /// With Alt, the first letter of a title that no title before it has.
    readonly property var letters: {
        const taken = [];
        for (const title of root.titles) {
            let at = 0;
            while (at + 1 < title.length && taken.includes(title[at].toLowerCase()))
                ++at;
            taken.push(title[at].toLowerCase());
        }
        return taken;
    }
    readonly property list<string> titles: commands.menus.map(menu => menu.title)

    component Entries: ThemedMenu {
        id: menu

        required property var entries

        Instantiator {
            model: menu.entries
            delegate: ThemedMenuItem {
                required property Command modelData

                objectName: modelData.objectName + ".item"
                action: modelData
            }
            onObjectAdded: (index, object) => menu.insertItem(index, object as ThemedMenuItem)
            onObjectRemoved: (index, object) => menu.removeItem(object as ThemedMenuItem)
        }
    }
    component Group: Entries {
        required property MenuCommands group

        objectName: "menu." + group.title
        title: root.marked(group.title)
        entries: group.commands.filter(command => command.submenu === null)
    }
    component Submenu: Entries {
        required property CommandGroup group

        objectName: "menu." + group.title
        title: group.title
        entries: root.commands.all.filter(command => command.submenu === group)
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

        objectName: menu ? "bar." + menu.title.replace("&", "") : ""
        implicitWidth: label.implicitWidth + 20
        implicitHeight: Theme.controlHeight
        Accessible.name: text.replace("&", "")
        background: Rectangle {
            anchors { fill: parent; margins: 3 }
            radius: 6
            color: entry.highlighted || entry.hovered ? Theme.hover : "transparent"
            border.width: entry.highlighted && Theme.sunlight ? 2 : 0
        }
        contentItem: BodyText {
            id: label

            text: entry.text.replace(/&(.)/, "<u>$1</u>")
            textFormat: Text.StyledText
            horizontalAlignment: Text.AlignHCenter
            verticalAlignment: Text.AlignVCenter
        }
    }

    Group {
        group: root.commands.file
        Component.onCompleted: insertMenu(2, root.recent)
    }
    Group { group: root.commands.edit }
    Group { group: root.commands.field }
    Group {
        group: root.commands.plan

        Submenu { group: root.commands.plan.driveMenu }
        Submenu { group: root.commands.plan.reviewMenu }
        Submenu { group: root.commands.plan.findingsMenu }
    }
    Group {
        group: root.commands.view

        Submenu { group: root.commands.view.layersMenu }
        Submenu { group: root.commands.view.coloursMenu }
        Submenu { group: root.commands.view.sizeMenu }
    }
    Group { group: root.commands.help }

    /// A title with its letter for Alt.
    function marked(title: string): string {
        const letter = root.letters[root.titles.indexOf(title)];
        const at = title.toLowerCase().indexOf(letter);
        return at < 0 ? title : title.slice(0, at) + "&" + title.slice(at);
    }
}
