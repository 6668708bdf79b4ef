import QtQuick
import Furrow.Controls
import Furrow.Edit
import Furrow.Project

/// Undo, and what is selected.
MenuCommands {
    id: root

    required property Document document
    required property FarmModel farm
    required property MapPage page
    signal paletteRequested()

    title: qsTr("Edit")
    commands: [
        Command {
            objectName: "command.undo"
            group: root
            // What is being drawn is not in the document yet.
            readonly property bool ofSketch: root.page.editor.sketchCount > 0
            text: ofSketch ? qsTr("Undo: %1").arg(qsTr("Draw a point")) : root.document.canUndo ? qsTr("Undo: %1").arg(root.document.undoText) : qsTr("Undo")
            name: qsTr("Undo")
            shortcut: "Ctrl+Z"
            enabled: ofSketch || root.document.canUndo
            onTriggered: ofSketch ? root.page.editor.removeLastPoint() : root.document.undo()
        },
        Command {
            objectName: "command.redo"
            group: root
            readonly property bool ofSketch: root.page.editor.canDrawAgain
            text: ofSketch ? qsTr("Redo: %1").arg(qsTr("Draw a point")) : root.document.canRedo ? qsTr("Redo: %1").arg(root.document.redoText) : qsTr("Redo")
            name: qsTr("Redo")
            shortcut: "Ctrl+Shift+Z"
            enabled: ofSketch || root.document.canRedo
            onTriggered: ofSketch ? root.page.editor.drawAgain() : root.document.redo()
        },
        Command {
            objectName: "command.delete"
            ruled: true
            group: root
            text: qsTr("Delete what is selected")
            keysText: qsTr("Del")
            enabled: root.page.editor.canDelete
            onTriggered: root.page.editor.deleteSelection()
        },
        Command {
            objectName: "command.next"
            group: root
            text: qsTr("Select the next point")
            keysText: qsTr("Space")
            enabled: root.farm.hasField
            onTriggered: root.page.editor.selectNext(1)
        },
        Command {
            objectName: "command.edge"
            group: root
            text: qsTr("Select the next edge")
            shortcut: "E"
            enabled: root.farm.hasField && !root.page.editor.drawing
            onTriggered: root.page.editor.selectEdge()
        },
        Command {
            objectName: "command.nextShape"
            group: root
            text: qsTr("Select the next outline, line or gate")
            keysText: qsTr("PgDown")
            enabled: root.farm.hasField
            onTriggered: root.page.editor.selectNextShape(1)
        },
        Command {
            objectName: "command.palette"
            ruled: true
            group: root
            text: qsTr("Find a command…")
            shortcut: "Ctrl+K"
            onTriggered: root.paletteRequested()
        }
    ]
}
