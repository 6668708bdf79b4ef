import QtQuick
import Furrow.Controls
import Furrow.Project

/// Projects and files, export and print.
MenuCommands {
    id: root

    required property Document document
    required property ProjectFiles files
    required property FarmModel farm
    signal newRequested()
    signal openRequested()
    signal imageryRequested()
    signal tileFolderRequested()
    signal saveRequested()
    signal saveAsRequested()
    signal exportRequested()
    signal printRequested()
    signal quitRequested()

    title: qsTr("File")
    commands: [
        Command {
            objectName: "command.new"
            group: root
            text: qsTr("New project")
            shortcut: "Ctrl+N"
            keywords: qsTr("farm")
            onTriggered: root.newRequested()
        },
        Command {
            objectName: "command.open"
            group: root
            text: qsTr("Open…")
            shortcut: "Ctrl+O"
            keywords: qsTr("boundary import project")
            onTriggered: root.openRequested()
        },
        Command {
            objectName: "command.addImagery"
            ruled: true
            group: root
            text: qsTr("Add imagery…")
            keywords: qsTr("GeoTIFF MBTiles aerial photo satellite background heights elevation")
            onTriggered: root.imageryRequested()
        },
        Command {
            objectName: "command.addTileFolder"
            group: root
            text: qsTr("Add a folder of tiles…")
            keywords: qsTr("imagery XYZ TMS")
            onTriggered: root.tileFolderRequested()
        },
        Command {
            objectName: "command.save"
            ruled: true
            group: root
            text: qsTr("Save")
            shortcut: "Ctrl+S"
            enabled: root.document.modified || root.files.path.length === 0
            onTriggered: root.saveRequested()
        },
        Command {
            objectName: "command.saveAs"
            group: root
            text: qsTr("Save as…")
            shortcut: "Ctrl+Shift+S"
            onTriggered: root.saveAsRequested()
        },
        Command {
            objectName: "command.export"
            ruled: true
            group: root
            text: qsTr("Export the plan…")
            shortcut: "Ctrl+E"
            keywords: qsTr("ISOXML USB terminal")
            enabled: root.farm.hasField
            onTriggered: root.exportRequested()
        },
        Command {
            objectName: "command.print"
            group: root
            text: qsTr("Print the work order…")
            shortcut: "Ctrl+P"
            keywords: qsTr("print pdf report work order picture printer")
            enabled: root.farm.hasField
            onTriggered: root.printRequested()
        },
        Command {
            objectName: "command.quit"
            ruled: true
            group: root
            text: qsTr("Quit")
            shortcut: "Ctrl+Q"
            onTriggered: root.quitRequested()
        }
    ]
}
