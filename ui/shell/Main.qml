import QtQuick
import QtCore
import QtQuick.Controls
import QtPositioning
import Furrow.Best
import Furrow.Commands
import Furrow.Compare
import Furrow.Controls
import Furrow.Drive
import Furrow.Edit
import Furrow.Export
import Furrow.Farm
import Furrow.Layers
import Furrow.Plan
import Furrow.Project
import Furrow.Report
import Furrow.Review

/// The window: top bar, steps, map, and what stands beside it.
ApplicationWindow {
    id: root

    required property Session session
    readonly property bool roomForPanel: width >= 1200
    /// All fields of the farm are in view in place of the steps and results of one.
    property bool farmWanted: false
    readonly property bool farmOpen: farmWanted && session.farm.hasField
    /// Beside the map; otherwise the steps are a drawer over it.
    readonly property bool roomForSteps: width >= (beside.twoMaps ? 1640 : 860)
    property bool stepsWanted: true
    /// When there was no more room for them.
    property bool stepsWereWanted: true
    readonly property bool stepsOpen: stepsWanted && !farmOpen
    readonly property int currentFinding: page.editor.selectedFinding
    /// The steps to the cells are gone through: of the plan the map shows the swaths only.
    readonly property bool steppingCells: session.planning.cells.current >= 0
    /// The drive-through is at hand; remembered.
    property bool driveWanted: true
    /// What was not saved is settled: the window may close.
    property bool settled: false
    /// The tour starts by itself where it was never shown.
    property bool offersTour: false

    objectName: "mainWindow"
    width: 1440
    height: 900
    // Not more than there is, where everything is drawn large.
    minimumWidth: Math.min(900, windowFit.room.width)
    minimumHeight: Math.min(600, windowFit.room.height)
    visible: true
    title: session.farm.hasField ? qsTr("%1%2 – Furrow").arg(session.farm.fieldName).arg(session.document.modified ? "*" : "") : qsTr("Furrow")
    menuBar: MainMenu {
        commands: appCommands
        recent: RecentList {
            recent: root.session.recent
            onChosen: path => root.openPath(path)
        }
    }
    color: Theme.background
    palette {
        window: Theme.panel
        windowText: Theme.ink
        base: Theme.panel
        alternateBase: Theme.sunken
        text: Theme.ink
        button: Theme.panel
        buttonText: Theme.ink
        highlight: Theme.accent
        highlightedText: Theme.accentInk
        mid: Theme.line
        dark: Theme.line
        light: Theme.hover
        placeholderText: Theme.muted
    }
    readonly property Settings stored: Settings {
        category: "geometry"
        property alias width: root.width
        property alias height: root.height
        property alias maximised: root.maximised
        property alias driveBar: root.driveWanted
        property alias x: root.x
        property alias y: root.y
    }
    WindowFit {
        id: windowFit

        window: root
    }
    WindowKeys { window: root }
    property bool maximised: false
    property bool started: false

    onVisibilityChanged: visibility => {
        if (started)
            maximised = visibility === Window.Maximized;
    }
    // The map first; the steps are a press away.
    onRoomForStepsChanged: {
        if (!roomForSteps)
            stepsWereWanted = stepsWanted;
        stepsWanted = roomForSteps && stepsWereWanted;
    }
    Component.onCompleted: {
        beside.panelWanted = roomForPanel;
        stepsWanted = roomForSteps;
        // Also where it will be maximised: it is to fit when that ends.
        windowFit.begin();
        if (maximised)
            showMaximized();
        started = true;
        if (offersTour && !tour.seen)
            tour.start();
    }

    onClosing: close => {
        if (root.settled || !root.session.document.modified)
            return;
        close.accepted = false;
        dialogs.settleThen(() => {
            root.settled = true;
            root.close();
        });
    }

    AppCommands {
        id: appCommands

        file: FileCommands {
            document: root.session.document
            files: root.session.files
            farm: root.session.farm
            onNewRequested: dialogs.startNew()
            onOpenRequested: dialogs.open()
            onImageryRequested: imageryDialogs.addFiles()
            onTileFolderRequested: imageryDialogs.addTileFolder()
            onSaveRequested: dialogs.save()
            onSaveAsRequested: dialogs.saveAs()
            onExportRequested: root.exportPlan()
            onPrintRequested: {
                root.session.printing.chosen = [];
                printDialog.open();
            }
            onQuitRequested: root.close()
        }
        edit: EditCommands {
            document: root.session.document
            farm: root.session.farm
            page: page
            onPaletteRequested: finder.open()
        }
        field: FieldCommands {
            farm: root.session.farm
            page: page
            onFieldFromTrackRequested: beside.askForFieldTrack()
            onRenameFieldRequested: root.askName(qsTr("Rename the field"), root.session.farm.fieldName, "", false, name => root.session.farm.renameField(name))
            onFarmRequested: root.farmOpen ? root.closeFarm() : root.showFarm()
        }
        plan: PlanCommands {
            farm: root.session.farm
            shown: root.session.shown
            planning: root.session.planning
            review: root.session.review
            drive: root.session.drive
            page: page
            twoMaps: beside.twoMaps
            onAddPlanRequested: root.askName(qsTr("Add a plan"), "", "", false, name => root.session.farm.addPlan(name))
            onCompareRequested: beside.compareOpen ? beside.closeCompare() : beside.showCompare()
            onTwoMapsRequested: beside.toggleTwoMaps()
            onTrackRequested: beside.askForTrack()
            onRenamePlanRequested: root.askName(qsTr("Rename the plan"), root.session.farm.planName, root.session.farm.season, true, (name, season) => root.session.farm.renamePlan(name, season))
            onBestPlanRequested: bestPlanDialog.open()
            onOrderRequested: {
                root.stepsWanted = true;
                steps.changeOrder();
            }
            onDriveBarRequested: on => root.driveWanted = on
            onDriveRequested: segment => root.driveFrom(segment)
            onCommentRequested: atPlace => root.comment(atPlace)
            onSendRequested: reviewDialogs.send()
            onTakeInRequested: reviewDialogs.takeIn()
            onFindingRequested: by => root.stepFinding(by)
            onFindingOfKindRequested: by => root.showAndGoTo(root.session.findings.nextOfKind(root.currentFinding, by))
        }
        view: ViewCommands {
            farm: root.session.farm
            shown: root.session.shown
            drive: root.session.drive
            driveBar: driveBar
            page: page
            layersPanel: layersPanel
            scaleSetting: windowDialogs.scaleSetting
            onDriveBarRequested: on => root.driveWanted = on
            onPlaceRequested: finder.openForPlace()
            onStepsRequested: root.stepsWanted = !root.stepsWanted
            onPanelRequested: beside.togglePanel()
            onPreferencesRequested: windowDialogs.preferences.open()
        }
        help: HelpCommands {
            onGuideRequested: beside.guideOpen ? beside.closeGuide() : beside.showGuide()
            onTourRequested: tour.start()
            onKeysRequested: windowDialogs.keys.open()
            onTroubleRequested: windowDialogs.trouble.open()
            onAboutRequested: windowDialogs.about.open()
        }
    }
    Shortcut {
        sequences: ["F10"]
        onActivated: root.menuBar.itemAt(0).click()
    }
    Shortcut {
        sequences: ["Ctrl+Y"]
        onActivated: appCommands.named("redo").trigger()
    }
    Finder {
        id: finder

        x: (root.width - width) / 2
        y: 72
        parent: Overlay.overlay
        commands: appCommands.all
        session: root.session
        page: page
        overlays: mapOverlays
        beside: beside
        steps: steps
        onStepsRequested: root.stepsWanted = true
        onFindingRequested: index => root.goToFinding(index)
        onPlaceVisited: emptyState.away = true
    }
    WindowDialogs {
        id: windowDialogs

        commands: appCommands
        report: root.session.trouble
    }
    NameDialog {
        id: nameDialog

        property var then: null

        anchors.centerIn: Overlay.overlay
        onNamed: (name, season) => then(name, season)
    }
    ProjectDialogs {
        id: dialogs

        document: root.session.document
        files: root.session.files
        opener: root.session.opener
        offer: (url, openIt) => reviewDialogs.offer(url, openIt)
    }
    ImageryDialogs {
        id: imageryDialogs

        imagery: root.session.imagery
    }

    TopBar {
        id: topBar

        anchors { left: parent.left; right: parent.right; top: parent.top }
        session: root.session
        commands: appCommands
        panelOffered: !root.roomForPanel && root.session.shown.hasPlan && !root.farmOpen && !beside.otherOpen
        farmOpen: root.farmOpen
        panelOpen: beside.panelOpen
        stepsOffered: !root.farmOpen
        stepsOpen: root.stepsOpen
    }
    FarmPanel {
        id: farmPanel

        objectName: "farmPanel"
        anchors { left: parent.left; top: topBar.bottom; bottom: parent.bottom }
        // At the least a strip of the map stays.
        width: Math.min(820, Math.max(540, root.width - 520))
        visible: root.farmOpen
        fields: root.session.farmList
        plans: root.session.farmPlans
        onCloseRequested: root.closeFarm()
        onFieldOpened: root.closeFarm()
        onAddPlansRequested: root.askName(qsTr("Add a plan to each field"), "", "", true, (name, season) => root.session.farmList.addPlans(name, season))
        onPrintRequested: {
            root.session.printing.chosen = root.session.farmList.chosenIds();
            printDialog.open();
        }
        onExportRequested: {
            root.session.exporter.chosen = root.session.farmList.chosenIds();
            exportDialog.open();
        }
    }
    StepsPanel {
        id: steps

        anchors { left: parent.left; top: topBar.bottom; bottom: parent.bottom }
        // In a small window a drawer over the map.
        z: root.roomForSteps ? 0 : 1
        width: Math.min(348, root.width - 48)
        visible: root.stepsOpen
        planning: root.session.planning
        opener: root.session.opener
        onOpenRequested: dialogs.open()
        onDrawRequested: page.startDrawing()
        onCheckRequested: beside.showFindings()
        onExportRequested: root.exportPlan()
        onBestPlanRequested: bestPlanDialog.open()
        onSwathChosen: segment => page.editor.selectSegment(segment)
    }
    MapStyle {
        id: mapStyle

        shown: root.session.shown
        planning: root.session.planning
        imagery: root.session.imagery
        layers: layersPanel.layers
        editor: page.editor
        steppingCells: root.steppingCells
    }
    MapPage {
        id: page

        objectName: "mapPage"
        anchors { left: root.farmOpen ? farmPanel.right : root.stepsOpen && root.roomForSteps ? steps.right : parent.left; right: otherMap.beside ? otherMap.left : beside.left; top: topBar.bottom; bottom: otherMap.below ? otherMap.top : driveBar.visible ? driveBar.top : parent.bottom }
        focus: true
        other: root.session.comparison.drawing
        showOther: beside.compareOpen && root.session.comparison.ready && !beside.twoMaps && (otherHeld || beside.holdingOther)
        document: root.session.document
        shown: root.session.shown
        imagery: root.session.imagery
        hasField: root.session.farm.hasField
        cells: root.session.planning.cells.drawing
        steppingCells: root.steppingCells
        imageryShown: layersPanel.layers.imagery
        online: layersPanel.layers.online
        layersOpen: layersPanel.open
        onLayersRequested: layersPanel.open = !layersPanel.open
        planStyle: mapStyle.style
        overlays: PlanOverlays {
            id: mapOverlays

            anchors.fill: parent
            session: root.session
            page: page
            beside: beside
            farmOpen: root.farmOpen
            steppingCells: root.steppingCells
            otherColor: otherMap.lineColor
            onFieldPicked: (row, how) => {
                root.session.farmList.pick(row, how);
                farmPanel.show(row);
            }
            onFieldOpened: row => farmPanel.open(row)
            onCommentClicked: row => root.showComment(row)
            onCommentPlaced: place => {
                beside.showResults();
                beside.results.showReview();
                beside.results.reviewSection.write(place);
            }
        }
        onFindingClicked: index => {
            beside.showResults();
            page.editor.selectFinding(index);
            beside.results.showFinding(index);
        }
        onFieldDrawn: boundary => root.session.opener.addDrawn(boundary)
        onInspectRequested: {
            beside.showResults();
            beside.results.focusInspector();
        }

        MapName {
            objectName: "firstName"
            anchors { right: parent.right; bottom: parent.bottom; margins: 12 }
            visible: beside.twoMaps
            name: qsTr("This plan: %1").arg(root.session.comparison.firstName)
            lineColor: Theme.accent
        }
        StatusChip {
            anchors { right: parent.right; top: parent.top; margins: 16 }
            planning: root.session.planning
            onCheckRequested: beside.showFindings()
        }
        FilesNotice {
            anchors { left: parent.left; top: parent.top; leftMargin: page.toolBar.x + page.toolBar.width + 16; topMargin: 62 }
            files: root.session.files
            onSaveAsRequested: dialogs.saveAs()
        }
        MapNotices {
            id: notices

            z: 1
            anchors { left: parent.left; bottom: sketchHint.visible ? sketchHint.top : parent.bottom; leftMargin: page.toolBar.x + page.toolBar.width + 16; bottomMargin: sketchHint.visible ? 8 : 68 }
            // Beside the tour.
            width: Math.min(400, parent.width - anchors.leftMargin - 16 - (tour.takenWidth > 0 ? tour.takenWidth + 16 : 0))
            session: root.session
            page: page
            onReportRequested: windowDialogs.trouble.open()
        }
        ProblemCard {
            anchors { right: parent.right; top: parent.top; rightMargin: 16; topMargin: 62 }
            problem: root.session.problem
            planning: root.session.planning
            hasField: root.session.farm.hasField
            onPlaceRequested: page.camera.centreOn(root.session.problem.place, 16, true)
            onOpenRequested: dialogs.open()
        }
        EmptyState {
            id: emptyState

            /// The user went to a place, to draw there: nothing covers it until there is a field.
            property bool away: false
            readonly property bool hasField: root.session.farm.hasField
            onHasFieldChanged: away = false

            // Beside the tour. Where there is no room for both, the tour's first task is the same.
            readonly property bool besideTour: tour.takenWidth === 0 || parent.width >= width + tour.takenWidth + 16 + 76
            readonly property real roomTo: parent.width - (tour.takenWidth > 0 ? tour.takenWidth + 16 : 0)
            // Beside the cards of what happened, or above them; what does not fit there scrolls.
            readonly property real noticesEnd: notices.height > 0 ? notices.x + notices.width + 16 : 0
            readonly property bool besideNotices: noticesEnd + width <= roomTo
            readonly property real roomBelow: notices.height > 0 && !besideNotices ? notices.y : parent.height
            readonly property bool hasRoom: besideTour && roomBelow >= Math.min(implicitHeight, 200) + 16
            x: Math.max(besideNotices ? noticesEnd : 0, Math.min((parent.width - width) / 2, roomTo - width))
            y: (roomBelow - height) / 2
            width: Math.min(implicitWidth, parent.width - 16)
            height: Math.min(implicitHeight, roomBelow - 16)
            visible: hasRoom && !away && (root.session.planning.state === PlanState.Empty || root.session.planning.state === PlanState.Failed && !root.session.farm.hasField) && !page.editor.drawing && !beside.fromTrackOpen && root.session.imagery.count === 0
            opener: root.session.opener
            recent: root.session.recent
            onOpenRequested: dialogs.open()
            onDrawRequested: page.startDrawing()
            onProjectRequested: path => root.openPath(path)
        }
        FieldChooser {
            anchors.centerIn: parent
            width: Math.min(implicitWidth, parent.width - 16)
            height: Math.min(parent.height - 32, 134 + 52 * root.session.opener.choices.count)
            visible: root.session.planning.state === PlanState.Choosing
            opener: root.session.opener
        }
        LayersPanel {
            id: layersPanel

            x: page.toolBar.x + page.toolBar.width + 8
            y: 16
            room: page.height - 72
            imagery: root.session.imagery
            zoomLevel: page.camera.zoomLevel
            escapeTaken: beside.otherOpen || root.farmOpen || root.steppingCells
            onAreaRequested: row => page.fitArea(root.session.imagery.areaOf(row), true)
            onFileRequested: imageryDialogs.addFiles()
            onFolderRequested: imageryDialogs.addTileFolder()
        }
        SketchHint {
            id: sketchHint

            anchors { horizontalCenter: parent.horizontalCenter; bottom: parent.bottom; bottomMargin: page.clearOfScale(width) }
            visible: page.editor.drawing
            editor: page.editor
            traceTolerance: page.traceTolerance
        }
        DropArea {
            id: drop

            anchors.fill: parent
            keys: ["text/uri-list"]
            onDropped: event => {
                if (event.hasUrls)
                    dialogs.openUrls(event.urls);
            }

            Rectangle {
                anchors { fill: parent; margins: 10 }
                visible: drop.containsDrag
                radius: 14
                color: Qt.alpha(Theme.accent, 0.12)
                border.width: 2
                border.color: Theme.accent
            }
        }
    }
    OtherMapPlace {
        id: otherMap

        objectName: "otherMap"
        fromX: page.x
        toX: beside.x
        fromY: page.y
        toY: driveBar.visible ? driveBar.y : root.contentItem.height
        open: beside.twoMaps
        onOpenChanged: change(open)
        page: page
        comparison: root.session.comparison
        imagery: root.session.imagery
        imageryShown: layersPanel.layers.imagery
        online: layersPanel.layers.online
        style: mapStyle.style
    }
    DriveBar {
        id: driveBar

        anchors { left: page.left; right: beside.left; bottom: parent.bottom }
        // Beside two panels in a small window there is no room for it.
        visible: root.driveWanted && !root.farmOpen && (root.roomForPanel || !beside.otherOpen) && root.session.shown.hasPlan && !page.editor.drawing
        slim: root.height < 700
        drive: root.session.drive
        onHideRequested: root.driveWanted = false
        onVisibleChanged: {
            if (!visible)
                drive.playing = false;
        }
    }
    Connections {
        target: root.session.drive
        enabled: driveBar.follows

        function onMoved(): void {
            if (root.session.drive.underWay)
                page.camera.centreOn(root.session.drive.place, page.camera.zoomLevel, false);
        }
    }
    BesidePanels {
        id: beside

        anchors { right: parent.right; top: topBar.bottom; bottom: parent.bottom }
        session: root.session
        page: page
        farmOpen: root.farmOpen
        roomForPanel: root.roomForPanel
        currentFinding: root.currentFinding
        drivenColors: [Theme.swath, Theme.headland, Theme.turn, Theme.finding, Theme.muted]
        onFarmGivesWay: root.farmWanted = false
        onStepsGiveWay: {
            if (!root.roomForSteps)
                root.stepsWanted = false;
        }
        onFindingRequested: index => root.goToFinding(index)
        onDriveRequested: segment => root.driveFrom(segment)
        onVariantRequested: root.askName(qsTr("Keep as a variant"), "", "", false, name => root.session.farm.addPlan(name))
    }
    ReviewDialogs {
        id: reviewDialogs

        review: root.session.review
        // What became of it is said there.
        onSent: beside.showResults()
        onTakenIn: {
            beside.showResults();
            beside.results.showReview();
        }
    }
    Connections {
        target: beside.results.reviewSection

        function onCommentRequested(row: int): void {
            root.showComment(row);
        }
        function onPlaceRequested(): void {
            mapOverlays.pins.placing = true;
        }
        function onSendRequested(): void {
            reviewDialogs.send();
        }
        function onTakeInRequested(): void {
            reviewDialogs.takeIn();
        }
    }
    ExportDialog {
        id: exportDialog

        anchors.centerIn: Overlay.overlay
        exporter: root.session.exporter
        planning: root.session.planning
    }
    PrintDialog {
        id: printDialog

        anchors.centerIn: Overlay.overlay
        printing: root.session.printing
        planning: root.session.planning
    }
    BestPlanDialog {
        id: bestPlanDialog

        anchors.centerIn: Overlay.overlay
        search: root.session.bestSearch
    }
    Tour {
        id: tour

        // The list of fields to choose from lies where the tour does.
        visible: running && root.session.planning.state !== PlanState.Choosing
        // Above the bar of what is drawn: its buttons are needed.
        anchors { left: parent.left; right: beside.left; top: parent.top; bottom: driveBar.visible ? driveBar.top : parent.bottom; bottomMargin: sketchHint.visible ? page.height - sketchHint.y - 8 : 0 }
        z: 10
        hasField: root.session.farm.hasField
        machineName: root.session.planning.machine.name
        dragging: page.editor.dragging
        exported: root.session.exporter.state === ExportModel.Done || root.session.exporter.stick.state === StickExport.Done
        places: [steps, steps, page, topBar.exportButton]
        onTaskRequested: task => root.beginTask(task)
    }
    Connections {
        target: root.session.planning

        function onFieldOpened(): void {
            page.fitField(false);
        }
    }
    Connections {
        target: root.session.planning.machine

        function onNameRequested(): void {
            root.askName(qsTr("Keep the machine as"), root.session.planning.machine.name, "", false, name => root.session.planning.machine.keepAs(name));
        }
    }
    Connections {
        target: page.editor

        function onSegmentClicked(index: int): void {
            root.session.planning.order.point(index);
        }
    }

    /// What a task of the tour is about, opened.
    function beginTask(task: int): void {
        if (task === 0 && !root.session.farm.hasField) {
            root.session.opener.openSample(Math.max(0, root.session.opener.sampleNames.indexOf("Home Field")));
        } else if (task === 1) {
            root.stepsWanted = true;
            steps.openStep = "machine";
        } else if (task === 2) {
            page.startTool(FieldEditor.Select);
        } else if (task === 3 && root.session.farm.hasField) {
            root.exportPlan();
        }
    }
    function exportPlan(): void {
        root.session.exporter.chosen = [];
        exportDialog.open();
    }
    function showFarm(): void {
        beside.guideOpen = false;
        root.farmWanted = true;
        farmPanel.begin();
        page.fitArea(root.session.farmList.bounds(), true);
    }
    function closeFarm(): void {
        root.farmWanted = false;
        page.fitField(true);
        page.forceActiveFocus();
    }
    function goToFinding(index: int): void {
        const place = root.session.findings.placeOf(index);
        page.editor.selectFinding(index);
        page.camera.centreOn(place, 17, true);
        mapOverlays.pulseAt(place);
    }
    /// The drive from the beginning of a segment.
    function driveFrom(segment: int): void {
        root.driveWanted = true;
        root.session.drive.goTo(segment);
    }
    /// A comment in the list and at its place.
    function showComment(row: int): void {
        mapOverlays.pins.current = row;
        beside.results.reviewSection.current = row;
        beside.showResults();
        beside.results.showReview();
        const place = root.session.review.placeOf(row);
        if (place.isValid)
            page.camera.centreOn(place, 17, true);
    }
    /// A comment on a place of the map that is clicked next, or on the whole plan.
    function comment(atPlace: bool): void {
        beside.showResults();
        beside.results.showReview();
        if (atPlace)
            mapOverlays.pins.placing = true;
        else
            beside.results.reviewSection.write(QtPositioning.coordinate());
    }
    /// From one finding to the next, or back.
    function stepFinding(by: int): void {
        const count = root.session.findings.count;
        if (count === 0)
            return;
        const next = root.currentFinding < 0 ? (by > 0 ? 0 : count - 1) : (root.currentFinding + by + count) % count;
        root.showAndGoTo(next);
    }
    function showAndGoTo(finding: int): void {
        if (finding < 0)
            return;
        beside.showResults();
        root.goToFinding(finding);
        beside.results.showFinding(finding);
    }
    function openPath(path: string): void {
        dialogs.openUrls([root.session.files.urlOf(path)]);
    }
    function askName(title: string, name: string, season: string, withSeason: bool, then: var): void {
        nameDialog.then = then;
        nameDialog.ask(title, name, season, withSeason);
    }
}
