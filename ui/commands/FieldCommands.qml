pragma ComponentBehavior: Bound
import QtQuick
import Furrow.Controls
import Furrow.Edit
import Furrow.Project

/// Fields and what is drawn in them.
MenuCommands {
    id: root

    required property FarmModel farm
    required property MapPage page
    signal fieldFromTrackRequested()
    signal renameFieldRequested()
    signal farmRequested()

    title: qsTr("Field")

    component ToolCommand: Command {
        required property int tool

        group: root
        enabled: root.farm.hasField
        onTriggered: root.page.startTool(tool)
    }

    commands: [
        Command {
            objectName: "command.draw"
            group: root
            text: qsTr("Draw a field")
            shortcut: "B"
            keywords: qsTr("boundary polygon")
            onTriggered: root.page.startDrawing()
        },
        Command {
            objectName: "command.fieldFromTrack"
            group: root
            text: qsTr("Make a field from a recorded track…")
            keywords: qsTr("boundary driven recorded GPX NMEA log drive around")
            onTriggered: root.fieldFromTrackRequested()
        },
        ToolCommand {
            objectName: "command.hole"
            ruled: true
            tool: FieldEditor.Hole
            text: qsTr("Draw a hole")
            shortcut: "H"
        },
        ToolCommand {
            objectName: "command.obstacle"
            tool: FieldEditor.Obstacle
            text: qsTr("Draw an obstacle")
            shortcut: "O"
            keywords: qsTr("pond tree pole wet")
        },
        ToolCommand {
            objectName: "command.guide"
            tool: FieldEditor.Guide
            text: qsTr("Draw an AB line")
            shortcut: "L"
            keywords: qsTr("guidance curve direction")
        },
        ToolCommand {
            objectName: "command.split"
            tool: FieldEditor.Split
            text: qsTr("Draw a split line")
            shortcut: "S"
            keywords: qsTr("cut divide mainland parts")
        },
        ToolCommand {
            objectName: "command.gate"
            tool: FieldEditor.Gate
            text: qsTr("Add a gate")
            shortcut: "G"
            keywords: qsTr("entry road")
        },
        Command {
            objectName: "command.select"
            ruled: true
            group: root
            text: qsTr("Select and change")
            shortcut: "V"
            onTriggered: root.page.startTool(FieldEditor.Select)
        },
        Command {
            objectName: "command.straightenSteps"
            group: root
            text: qsTr("Make the outline's steps straight")
            keywords: qsTr("pixels image stairs smooth simplify")
            enabled: root.page.editor.outlineSteps > 0
            onTriggered: root.page.editor.straightenSteps(false)
        },
        Command {
            objectName: "command.renameField"
            ruled: true
            group: root
            text: qsTr("Rename the field…")
            enabled: root.farm.hasField
            onTriggered: root.renameFieldRequested()
        },
        Command {
            objectName: "command.removeField"
            group: root
            text: qsTr("Remove the field")
            keywords: qsTr("delete")
            enabled: root.farm.hasField
            onTriggered: root.farm.removeField()
        },
        Command {
            objectName: "command.nextField"
            ruled: true
            group: root
            text: qsTr("Next field")
            shortcut: "Ctrl+PgDown"
            enabled: root.farm.fields.length > 1
            onTriggered: root.farm.currentField = (root.farm.currentField + 1) % root.farm.fields.length
        },
        Command {
            objectName: "command.farm"
            group: root
            text: qsTr("All fields of the farm")
            shortcut: "Ctrl+Shift+F"
            keywords: qsTr("list overview plan all batch totals")
            enabled: root.farm.hasField
            onTriggered: root.farmRequested()
        }
    ]
}
