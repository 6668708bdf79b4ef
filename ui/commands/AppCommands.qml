import QtQuick
import Furrow.Controls

/// Everything that can be done in the window, menu by menu.
QtObject {
    id: root

    required property FileCommands file
    required property EditCommands edit
    required property FieldCommands field
    required property PlanCommands plan
    required property ViewCommands view
    required property HelpCommands help
    readonly property list<MenuCommands> menus: [root.file, root.edit, root.field, root.plan, root.view, root.help]
    readonly property list<Command> all: root.menus.reduce((all, menu) => all.concat(Array.from(menu.commands)), [])

    function named(name: string): Command {
        return root.all.find(command => command.objectName === "command." + name);
    }
}
