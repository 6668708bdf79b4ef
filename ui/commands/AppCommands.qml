pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Controls
import Furrow.Controls
import Furrow.Drive
import Furrow.Edit
import Furrow.Layers
import Furrow.Map
import Furrow.Plan
import Furrow.Project
import Furrow.Review
import Furrow.Settings

/// Everything that can be done in the window.
QtObject {
    id: root

    required property Document document
    required property ProjectFiles files
    required property FarmModel farm
    required property ShownPlan shown
    required property Planning planning
    required property ReviewModel review
    required property DriveThrough drive
    required property DriveBar driveBar
    required property MapPage page
    required property LayersPanel layersPanel
    required property ScaleSetting scaleSetting
    required property bool twoMaps
    signal newRequested()
    signal openRequested()
    signal saveRequested()
    signal saveAsRequested()
    signal exportRequested()
    signal printRequested()
    signal bestPlanRequested()
    signal orderRequested()
    signal findingRequested(by: int)
    signal findingOfKindRequested(by: int)
    signal commentRequested(atPlace: bool)
    signal sendRequested()
    signal takeInRequested()
    signal driveBarRequested(on: bool)
    signal driveRequested(segment: int)
    signal trackRequested()
    signal fieldFromTrackRequested()
    signal compareRequested()
    signal twoMapsRequested()
    signal farmRequested()
    signal renameFieldRequested()
    signal addPlanRequested()
    signal renamePlanRequested()
    signal paletteRequested()
    signal placeRequested()
    signal keysRequested()
    signal guideRequested()
    signal aboutRequested()
    signal troubleRequested()
    signal preferencesRequested()
    signal tourRequested()
    signal quitRequested()
    signal panelRequested()
    signal stepsRequested()
    signal imageryRequested()
    signal tileFolderRequested()

    readonly property CommandGroup fileGroup: CommandGroup { title: qsTr("File") }
    readonly property CommandGroup editGroup: CommandGroup { title: qsTr("Edit") }
    readonly property CommandGroup fieldGroup: CommandGroup { title: qsTr("Field") }
    readonly property CommandGroup planGroup: CommandGroup { title: qsTr("Plan") }
    readonly property CommandGroup viewGroup: CommandGroup { title: qsTr("View") }
    readonly property CommandGroup helpGroup: CommandGroup { title: qsTr("Help") }
    readonly property CommandGroup layersMenu: CommandGroup { title: qsTr("What the map shows") }
    readonly property CommandGroup coloursMenu: CommandGroup { title: qsTr("Colours") }
    readonly property CommandGroup sizeMenu: CommandGroup { title: qsTr("Size of everything") }

    component LayerCommand: Command {
        required property string layer

        objectName: "command.layer." + layer
        group: root.viewGroup
        submenu: root.layersMenu
        checkable: true
        checked: root.layersPanel.layers[layer]
        onTriggered: root.layersPanel.layers[layer] = checked
    }

    component ScaleCommand: Command {
        required property int percent

        objectName: "command.scale." + percent
        group: root.viewGroup
        submenu: root.sizeMenu
        text: qsTr("Everything at %1 %").arg(percent)
        keywords: qsTr("size scaling zoom large text")
        checkable: true
        checked: root.scaleSetting.percent === percent
        onTriggered: root.scaleSetting.set(percent)
    }

    component ToolCommand: Command {
        required property int tool

        group: root.fieldGroup
        enabled: root.farm.hasField
        onTriggered: root.page.startTool(tool)
    }

    readonly property list<Command> all: [
        Command {
            objectName: "command.new"
            group: root.fileGroup
            text: qsTr("New project")
            shortcut: "Ctrl+N"
            keywords: qsTr("farm")
            onTriggered: root.newRequested()
        },
        Command {
            objectName: "command.open"
            group: root.fileGroup
            text: qsTr("Open…")
            shortcut: "Ctrl+O"
            keywords: qsTr("boundary import project")
            onTriggered: root.openRequested()
        },
        Command {
            objectName: "command.addImagery"
            ruled: true
            group: root.fileGroup
            text: qsTr("Add imagery…")
            keywords: qsTr("GeoTIFF MBTiles aerial photo satellite background heights elevation")
            onTriggered: root.imageryRequested()
        },
        Command {
            objectName: "command.addTileFolder"
            group: root.fileGroup
            text: qsTr("Add a folder of tiles…")
            keywords: qsTr("imagery XYZ TMS")
            onTriggered: root.tileFolderRequested()
        },
        Command {
            objectName: "command.save"
            ruled: true
            group: root.fileGroup
            text: qsTr("Save")
            shortcut: "Ctrl+S"
            enabled: root.document.modified || root.files.path.length === 0
            onTriggered: root.saveRequested()
        },
        Command {
            objectName: "command.saveAs"
            group: root.fileGroup
            text: qsTr("Save as…")
            shortcut: "Ctrl+Shift+S"
            onTriggered: root.saveAsRequested()
        },
        Command {
            objectName: "command.export"
            ruled: true
            group: root.fileGroup
            text: qsTr("Export the plan…")
            shortcut: "Ctrl+E"
            keywords: qsTr("ISOXML USB terminal")
            enabled: root.farm.hasField
            onTriggered: root.exportRequested()
        },
        Command {
            objectName: "command.print"
            group: root.fileGroup
            text: qsTr("Print the work order…")
            shortcut: "Ctrl+P"
            keywords: qsTr("print pdf report work order picture printer")
            enabled: root.farm.hasField
            onTriggered: root.printRequested()
        },
        Command {
            objectName: "command.quit"
            ruled: true
            group: root.fileGroup
            text: qsTr("Quit")
            shortcut: "Ctrl+Q"
            onTriggered: root.quitRequested()
        },
        Command {
            objectName: "command.undo"
            group: root.editGroup
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
            group: root.editGroup
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
            group: root.editGroup
            text: qsTr("Delete what is selected")
            keysText: qsTr("Del")
            enabled: root.page.editor.canDelete
            onTriggered: root.page.editor.deleteSelection()
        },
        Command {
            objectName: "command.next"
            group: root.editGroup
            text: qsTr("Select the next point")
            keysText: qsTr("Space")
            enabled: root.farm.hasField
            onTriggered: root.page.editor.selectNext(1)
        },
        Command {
            objectName: "command.edge"
            group: root.editGroup
            text: qsTr("Select the next edge")
            shortcut: "E"
            enabled: root.farm.hasField && !root.page.editor.drawing
            onTriggered: root.page.editor.selectEdge()
        },
        Command {
            objectName: "command.nextShape"
            group: root.editGroup
            text: qsTr("Select the next outline, line or gate")
            keysText: qsTr("PgDown")
            enabled: root.farm.hasField
            onTriggered: root.page.editor.selectNextShape(1)
        },
        Command {
            objectName: "command.palette"
            ruled: true
            group: root.editGroup
            text: qsTr("Find a command…")
            shortcut: "Ctrl+K"
            onTriggered: root.paletteRequested()
        },
        Command {
            objectName: "command.draw"
            group: root.fieldGroup
            text: qsTr("Draw a field")
            shortcut: "B"
            keywords: qsTr("boundary polygon")
            onTriggered: root.page.startDrawing()
        },
        Command {
            objectName: "command.fieldFromTrack"
            group: root.fieldGroup
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
            group: root.fieldGroup
            text: qsTr("Select and change")
            shortcut: "V"
            onTriggered: root.page.startTool(FieldEditor.Select)
        },
        Command {
            objectName: "command.straightenSteps"
            group: root.fieldGroup
            text: qsTr("Make the outline's steps straight")
            keywords: qsTr("pixels image stairs smooth simplify")
            enabled: root.page.editor.outlineSteps > 0
            onTriggered: root.page.editor.straightenSteps(false)
        },
        Command {
            objectName: "command.renameField"
            ruled: true
            group: root.fieldGroup
            text: qsTr("Rename the field…")
            enabled: root.farm.hasField
            onTriggered: root.renameFieldRequested()
        },
        Command {
            objectName: "command.removeField"
            group: root.fieldGroup
            text: qsTr("Remove the field")
            keywords: qsTr("delete")
            enabled: root.farm.hasField
            onTriggered: root.farm.removeField()
        },
        Command {
            objectName: "command.nextField"
            ruled: true
            group: root.fieldGroup
            text: qsTr("Next field")
            shortcut: "Ctrl+PgDown"
            enabled: root.farm.fields.length > 1
            onTriggered: root.farm.currentField = (root.farm.currentField + 1) % root.farm.fields.length
        },
        Command {
            objectName: "command.farm"
            group: root.fieldGroup
            text: qsTr("All fields of the farm")
            shortcut: "Ctrl+Shift+F"
            keywords: qsTr("list overview plan all batch totals")
            enabled: root.farm.hasField
            onTriggered: root.farmRequested()
        },
        Command {
            objectName: "command.addPlan"
            group: root.planGroup
            text: qsTr("Add a plan…")
            keywords: qsTr("season operation copy")
            enabled: root.farm.hasField
            onTriggered: root.addPlanRequested()
        },
        Command {
            objectName: "command.compare"
            ruled: true
            group: root.planGroup
            text: qsTr("Compare with another plan")
            shortcut: "Ctrl+D"
            keywords: qsTr("compare variants differences side by side better")
            enabled: root.shown.hasPlan
            onTriggered: root.compareRequested()
        },
        Command {
            objectName: "command.twoMaps"
            group: root.planGroup
            text: qsTr("Compare on two maps")
            shortcut: "Ctrl+Shift+D"
            keywords: qsTr("compare side by side split map")
            checkable: true
            checked: root.twoMaps
            enabled: root.shown.hasPlan
            onTriggered: root.twoMapsRequested()
        },
        Command {
            objectName: "command.track"
            group: root.planGroup
            text: qsTr("Compare with a recorded track…")
            shortcut: "Ctrl+T"
            keywords: qsTr("driven recorded GPX NMEA log cross-track error compare")
            onTriggered: root.trackRequested()
        },
        Command {
            objectName: "command.renamePlan"
            ruled: true
            group: root.planGroup
            text: qsTr("Rename the plan…")
            enabled: root.farm.hasField
            onTriggered: root.renamePlanRequested()
        },
        Command {
            objectName: "command.removePlan"
            group: root.planGroup
            text: qsTr("Remove the plan")
            keywords: qsTr("delete")
            enabled: root.farm.plans.length > 1
            onTriggered: root.farm.removePlan()
        },
        Command {
            objectName: "command.planAgain"
            ruled: true
            group: root.planGroup
            text: qsTr("Plan again")
            shortcut: "F5"
            enabled: root.farm.hasField
            onTriggered: root.planning.planAgain()
        },
        Command {
            objectName: "command.bestPlan"
            group: root.planGroup
            text: qsTr("Find the best plan…")
            shortcut: "Ctrl+B"
            keywords: qsTr("quickest optimise compare alternatives")
            enabled: root.farm.hasField
            onTriggered: root.bestPlanRequested()
        },
        Command {
            objectName: "command.order"
            group: root.planGroup
            text: qsTr("Change the order by hand…")
            keywords: qsTr("order swaths list drag sequence")
            enabled: root.planning.order.count > 1
            onTriggered: root.orderRequested()
        },
        Command {
            objectName: "command.drive"
            ruled: true
            group: root.planGroup
            name: qsTr("Drive through the plan")
            text: root.drive.playing ? qsTr("Pause the drive") : name
            shortcut: "Ctrl+Space"
            keywords: qsTr("drive play pause simulate machine")
            enabled: root.drive.available
            onTriggered: {
                root.driveBarRequested(true);
                root.drive.playing = !root.drive.playing;
            }
        },
        Command {
            objectName: "command.driveHere"
            group: root.planGroup
            text: qsTr("Drive from what is selected")
            keywords: qsTr("drive play here swath turn")
            enabled: root.drive.available && root.page.editor.selectedSegment >= 0
            onTriggered: root.driveRequested(root.page.editor.selectedSegment)
        },
        Command {
            objectName: "command.driveFaster"
            group: root.planGroup
            text: qsTr("Drive faster")
            keywords: qsTr("pace speed")
            enabled: root.drive.available
            onTriggered: root.drive.faster()
        },
        Command {
            objectName: "command.driveSlower"
            group: root.planGroup
            text: qsTr("Drive slower")
            keywords: qsTr("pace speed")
            enabled: root.drive.available
            onTriggered: root.drive.slower()
        },
        Command {
            objectName: "command.driveFollow"
            group: root.viewGroup
            text: qsTr("Follow the machine")
            keywords: qsTr("drive camera centre")
            checkable: true
            checked: root.driveBar.follows
            enabled: root.drive.available
            onTriggered: root.driveBar.follows = checked
        },
        Command {
            objectName: "command.driveBar"
            group: root.viewGroup
            text: qsTr("Drive-through bar")
            keywords: qsTr("drive play slider")
            checkable: true
            checked: root.driveBar.visible
            enabled: root.shown.hasPlan
            onTriggered: root.driveBarRequested(checked)
        },
        Command {
            objectName: "command.commentPlace"
            ruled: true
            group: root.planGroup
            text: qsTr("Comment on a place…")
            shortcut: "Ctrl+M"
            keywords: qsTr("review note remark pin")
            enabled: root.shown.hasPlan
            onTriggered: root.commentRequested(true)
        },
        Command {
            objectName: "command.commentPlan"
            group: root.planGroup
            text: qsTr("Comment on the whole plan…")
            keywords: qsTr("review note remark")
            enabled: root.shown.hasPlan
            onTriggered: root.commentRequested(false)
        },
        Command {
            objectName: "command.sendReview"
            group: root.planGroup
            text: root.review.sendText
            keywords: qsTr("contractor share file approve")
            enabled: root.shown.hasPlan
            onTriggered: root.sendRequested()
        },
        Command {
            objectName: "command.takeInReview"
            group: root.planGroup
            text: qsTr("Take in a review that came back…")
            keywords: qsTr("merge comments contractor")
            enabled: root.farm.hasField
            onTriggered: root.takeInRequested()
        },
        Command {
            objectName: "command.nextFinding"
            ruled: true
            group: root.planGroup
            text: qsTr("Next finding")
            shortcut: "F8"
            keywords: qsTr("problem check step through")
            enabled: root.shown.hasPlan
            onTriggered: root.findingRequested(1)
        },
        Command {
            objectName: "command.previousFinding"
            group: root.planGroup
            text: qsTr("Previous finding")
            shortcut: "Shift+F8"
            keywords: qsTr("problem check step back")
            enabled: root.shown.hasPlan
            onTriggered: root.findingRequested(-1)
        },
        Command {
            objectName: "command.nextOfKind"
            group: root.planGroup
            text: qsTr("Next finding of the same kind")
            shortcut: "Ctrl+F8"
            keywords: qsTr("problem check step through")
            enabled: root.shown.hasPlan
            onTriggered: root.findingOfKindRequested(1)
        },
        Command {
            objectName: "command.previousOfKind"
            group: root.planGroup
            text: qsTr("Previous finding of the same kind")
            shortcut: "Ctrl+Shift+F8"
            keywords: qsTr("problem check step back")
            enabled: root.shown.hasPlan
            onTriggered: root.findingOfKindRequested(-1)
        },
        Command {
            objectName: "command.fit"
            ruled: true
            group: root.viewGroup
            text: qsTr("Show the whole field")
            shortcut: "F"
            enabled: root.farm.hasField
            onTriggered: root.page.fitField(true)
        },
        Command {
            objectName: "command.place"
            group: root.viewGroup
            text: qsTr("Go to a place…")
            keywords: qsTr("coordinates latitude longitude map")
            onTriggered: root.placeRequested()
        },
        Command {
            objectName: "command.zoomIn"
            group: root.viewGroup
            text: qsTr("Closer")
            shortcut: "Ctrl++"
            keywords: qsTr("zoom in")
            onTriggered: root.page.camera.zoomBy(1)
        },
        Command {
            objectName: "command.zoomOut"
            group: root.viewGroup
            text: qsTr("Further away")
            shortcut: "Ctrl+-"
            keywords: qsTr("zoom out")
            onTriggered: root.page.camera.zoomBy(-1)
        },
        Command {
            objectName: "command.steps"
            ruled: true
            group: root.viewGroup
            text: qsTr("Steps")
            shortcut: "F7"
            onTriggered: root.stepsRequested()
        },
        Command {
            objectName: "command.panel"
            group: root.viewGroup
            text: qsTr("Results panel")
            shortcut: "F9"
            enabled: root.shown.hasPlan
            onTriggered: root.panelRequested()
        },
        Command {
            objectName: "command.layers"
            group: root.viewGroup
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
            group: root.viewGroup
            text: qsTr("Language and units…")
            shortcut: "Ctrl+,"
            keywords: qsTr("preferences settings metric imperial feet acres")
            onTriggered: root.preferencesRequested()
        },
        Command {
            objectName: "command.light"
            group: root.viewGroup
            submenu: root.coloursMenu
            text: qsTr("Light colours")
            keywords: qsTr("theme")
            onTriggered: root.setTheme(Theme.Light)
        },
        Command {
            objectName: "command.dark"
            group: root.viewGroup
            submenu: root.coloursMenu
            text: qsTr("Dark colours")
            keywords: qsTr("theme night")
            onTriggered: root.setTheme(Theme.Dark)
        },
        Command {
            objectName: "command.sunlight"
            group: root.viewGroup
            submenu: root.coloursMenu
            text: qsTr("Sunlight colours")
            keywords: qsTr("theme contrast")
            onTriggered: root.setTheme(Theme.Sunlight)
        },
        ScaleCommand { percent: 100 },
        ScaleCommand { percent: 150 },
        ScaleCommand { percent: 200 },
        ScaleCommand { percent: 300 },
        Command {
            objectName: "command.guide"
            group: root.helpGroup
            text: qsTr("Guide")
            shortcut: "F1"
            keywords: qsTr("help manual how to documentation")
            onTriggered: root.guideRequested()
        },
        Command {
            objectName: "command.tour"
            group: root.helpGroup
            text: qsTr("Take the tour")
            keywords: qsTr("help introduction first start")
            onTriggered: root.tourRequested()
        },
        Command {
            objectName: "command.keys"
            group: root.helpGroup
            text: qsTr("Keys and mouse")
            shortcut: "Ctrl+F1"
            keywords: qsTr("shortcuts help")
            onTriggered: root.keysRequested()
        },
        Command {
            objectName: "command.trouble"
            ruled: true
            group: root.helpGroup
            text: qsTr("Report a problem…")
            keywords: qsTr("bug crash support error")
            onTriggered: root.troubleRequested()
        },
        Command {
            objectName: "command.about"
            ruled: true
            group: root.helpGroup
            text: qsTr("About Furrow")
            keywords: qsTr("version licence credits")
            onTriggered: root.aboutRequested()
        }
    ]

    function inGroup(group: CommandGroup): var {
        return root.all.filter(command => command.group === group);
    }
    function named(name: string): Command {
        return root.all.find(command => command.objectName === "command." + name);
    }
    function setTheme(mode: int): void {
        Theme.forced = Theme.System;
        Theme.mode = mode;
    }
}
