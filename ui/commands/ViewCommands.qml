pragma ComponentBehavior: Bound
import QtQuick
import Furrow.Controls
import Furrow.Drive
import Furrow.Edit
import Furrow.Layers
import Furrow.Map
import Furrow.Project
import Furrow.Settings

/// What the map and the window show.
MenuCommands {
    id: root

    required property FarmModel farm
    required property ShownPlan shown
    required property DriveThrough drive
    required property DriveBar driveBar
    required property MapPage page
    required property LayersPanel layersPanel
    required property ScaleSetting scaleSetting
    signal driveBarRequested(on: bool)
    signal placeRequested()
    signal stepsRequested()
    signal panelRequested()
    signal preferencesRequested()

    title: qsTr("View")

    readonly property CommandGroup layersMenu: CommandGroup { title: qsTr("What the map shows") }
    readonly property CommandGroup coloursMenu: CommandGroup { title: qsTr("Colours") }
    readonly property CommandGroup sizeMenu: CommandGroup { title: qsTr("Size of everything") }

    component LayerCommand: Command {
        required property string layer

        objectName: "command.layer." + layer
        group: root
        submenu: root.layersMenu
        checkable: true
        checked: root.layersPanel.layers[layer]
        onTriggered: root.layersPanel.layers[layer] = checked
    }

    component ScaleCommand: Command {
        required property int percent

        objectName: "command.scale." + percent
        group: root
        submenu: root.sizeMenu
        text: qsTr("Everything at %1 %").arg(percent)
        keywords: qsTr("size scaling zoom large text")
        checkable: true
        checked: root.scaleSetting.percent === percent
        onTriggered: root.scaleSetting.set(percent)
    }

    commands: [
        Command {
            objectName: "command.driveFollow"
            group: root
            text: qsTr("Follow the machine")
            keywords: qsTr("drive camera centre")
            checkable: true
            checked: root.driveBar.follows
            enabled: root.drive.available
            onTriggered: root.driveBar.follows = checked
        },
        Command {
            objectName: "command.driveBar"
            group: root
            text: qsTr("Drive-through bar")
            keywords: qsTr("drive play slider")
            checkable: true
            checked: root.driveBar.visible
            enabled: root.shown.hasPlan
            onTriggered: root.driveBarRequested(checked)
        },
        Command {
            objectName: "command.fit"
            ruled: true
            group: root
            text: qsTr("Show the whole field")
            shortcut: "F"
            enabled: root.farm.hasField
            onTriggered: root.page.fitField(true)
        },
        Command {
            objectName: "command.place"
            group: root
            text: qsTr("Go to a place…")
            keywords: qsTr("coordinates latitude longitude map")
            onTriggered: root.placeRequested()
        },
        Command {
            objectName: "command.zoomIn"
            group: root
            text: qsTr("Closer")
            shortcut: "Ctrl++"
            keywords: qsTr("zoom in")
            onTriggered: root.page.camera.zoomBy(1)
        },
        Command {
            objectName: "command.zoomOut"
            group: root
            text: qsTr("Further away")
            shortcut: "Ctrl+-"
            keywords: qsTr("zoom out")
            onTriggered: root.page.camera.zoomBy(-1)
        },
        Command {
            objectName: "command.steps"
            ruled: true
            group: root
            text: qsTr("Steps")
            shortcut: "F7"
            onTriggered: root.stepsRequested()
        },
        Command {
            objectName: "command.panel"
            group: root
            text: qsTr("Results panel")
            shortcut: "F9"
            enabled: root.shown.hasPlan
            onTriggered: root.panelRequested()
        },
        Command {
            objectName: "command.layers"
            group: root
            text: qsTr("Layers")
            shortcut: "Ctrl+L"
            keywords: qsTr("imagery map background")
            checkable: true
            checked: root.layersPanel.open
            onTriggered: root.layersPanel.open = checked
        },
        LayerCommand { layer: "imagery"; text: qsTr("Layer: imagery") },
        LayerCommand { layer: "online"; text: qsTr("Layer: OpenStreetMap from the network"); keywords: qsTr("online tiles") },
        LayerCommand { layer: "boundary"; text: qsTr("Layer: boundary") },
        LayerCommand { layer: "headland"; text: qsTr("Layer: headland") },
        LayerCommand { layer: "swaths"; text: qsTr("Layer: swaths") },
        LayerCommand { layer: "turns"; text: qsTr("Layer: turns") },
        LayerCommand { layer: "directions"; text: qsTr("Layer: driving direction") },
        LayerCommand { layer: "numbers"; text: qsTr("Layer: swath numbers") },
        LayerCommand { layer: "order"; text: qsTr("Layer: order numbers") },
        LayerCommand { layer: "coverage"; text: qsTr("Layer: coverage") },
        LayerCommand { layer: "overlap"; text: qsTr("Layer: worked twice"); keywords: qsTr("overlap") },
        LayerCommand { layer: "missed"; text: qsTr("Layer: missed"); keywords: qsTr("gap uncovered") },
        LayerCommand { layer: "wheels"; text: qsTr("Layer: driven over often"); keywords: qsTr("wheel passes traffic compaction") },
        LayerCommand { layer: "findings"; text: qsTr("Layer: findings") },
        Command {
            objectName: "command.preferences"
            ruled: true
            group: root
            text: qsTr("Language and units…")
            shortcut: "Ctrl+,"
            keywords: qsTr("preferences settings metric imperial feet acres")
            onTriggered: root.preferencesRequested()
        },
        Command {
            objectName: "command.light"
            group: root
            submenu: root.coloursMenu
            text: qsTr("Light colours")
            keywords: qsTr("theme")
            onTriggered: root.setTheme(Theme.Light)
        },
        Command {
            objectName: "command.dark"
            group: root
            submenu: root.coloursMenu
            text: qsTr("Dark colours")
            keywords: qsTr("theme night")
            onTriggered: root.setTheme(Theme.Dark)
        },
        Command {
            objectName: "command.sunlight"
            group: root
            submenu: root.coloursMenu
            text: qsTr("Sunlight colours")
            keywords: qsTr("theme contrast")
            onTriggered: root.setTheme(Theme.Sunlight)
        },
        ScaleCommand { percent: 100 },
        ScaleCommand { percent: 150 },
        ScaleCommand { percent: 200 },
        ScaleCommand { percent: 300 }
    ]

    function setTheme(mode: int): void {
        Theme.forced = Theme.System;
        Theme.mode = mode;
    }
}
