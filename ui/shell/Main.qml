import QtQuick
import QtQuick.Controls
import QtQuick.Dialogs
import QtPositioning
import Furrow.Controls
import Furrow.Map
import Furrow.Plan

/// The window: top bar, steps, map, results.
ApplicationWindow {
    id: root

    required property PlanSession session
    readonly property bool roomForPanel: width >= 1200
    property bool panelWanted: true
    readonly property bool panelOpen: session.hasPlan && (roomForPanel || panelWanted)
    property int currentFinding: -1

    objectName: "mainWindow"
    width: 1440
    height: 900
    minimumWidth: 900
    minimumHeight: 600
    visible: true
    title: session.hasField ? qsTr("%1 – Furrow").arg(session.fieldName) : qsTr("Furrow")
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
    onRoomForPanelChanged: panelWanted = roomForPanel
    Component.onCompleted: panelWanted = roomForPanel

    Shortcut {
        sequences: [StandardKey.Open]
        onActivated: root.openFile()
    }
    Shortcut {
        sequence: "Ctrl+E"
        enabled: root.session.hasPlan
        onActivated: exportDialog.open()
    }

    TopBar {
        id: topBar

        anchors { left: parent.left; right: parent.right; top: parent.top }
        session: root.session
        panelOffered: !root.roomForPanel && root.session.hasPlan
        panelOpen: root.panelOpen
        onOpenRequested: root.openFile()
        onExportRequested: exportDialog.open()
        onPanelToggled: root.panelWanted = !root.panelWanted
    }
    StepsPanel {
        id: steps

        anchors { left: parent.left; top: topBar.bottom; bottom: parent.bottom }
        width: 348
        session: root.session
        onOpenRequested: root.openFile()
        onDrawRequested: page.startDrawing()
    }
    MapPage {
        id: page

        objectName: "mapPage"
        anchors { left: steps.right; right: results.left; top: topBar.bottom; bottom: parent.bottom }
        focus: true
        drawing: root.session.drawing
        planStyle: ({
                boundary: Theme.boundary,
                casing: Theme.casing,
                headland: Theme.headland,
                swath: Theme.swath,
                turn: Theme.turn,
                finding: Theme.finding,
                obstacle: Theme.obstacle,
                start: Theme.startMark,
                end: Theme.endMark,
                ground: Theme.panel,
                ink: Theme.ink,
                lineFactor: Theme.lineFactor,
                showBoundary: results.layers.boundary && !page.editLayer.dragging,
                showHeadland: results.layers.headland,
                showSwaths: results.layers.swaths,
                showTurns: results.layers.turns,
                showDirections: results.layers.directions,
                showNumbers: results.layers.numbers,
                showFindings: results.layers.findings,
                selectedFinding: root.currentFinding
            })
        onBoundaryDrawn: points => root.session.setBoundary(points)
        onVertexMoved: (part, ring, vertex, place, finished) => root.session.moveVertex(part, ring, vertex, place, finished)
        onFindingClicked: index => {
            if (index >= root.session.findings.few)
                root.session.findings.all = true;
            root.currentFinding = index;
        }

        StatusChip {
            anchors { right: parent.right; top: parent.top; margins: 16 }
            session: root.session
        }
        ProblemCard {
            anchors { right: parent.right; top: parent.top; rightMargin: 16; topMargin: 62 }
            session: root.session
            onPlaceRequested: page.camera.centreOn(root.session.problemPlace, 16, true)
            onOpenRequested: root.openFile()
        }
        EmptyState {
            anchors.centerIn: parent
            visible: (root.session.state === PlanSession.Empty || root.session.state === PlanSession.Failed && !root.session.hasField) && !page.drawingBoundary
            session: root.session
            onOpenRequested: root.openFile()
            onDrawRequested: page.startDrawing()
        }
        FieldChooser {
            anchors.centerIn: parent
            height: Math.min(parent.height - 80, 84 + 52 * root.session.choices.count)
            visible: root.session.state === PlanSession.Choosing
            session: root.session
        }
        DrawingHint {
            anchors { horizontalCenter: parent.horizontalCenter; bottom: parent.bottom; bottomMargin: 20 }
            visible: page.drawingBoundary
            points: page.editLayer.draftCount
            lengthM: page.editLayer.draftLengthM
            onFinishRequested: page.editLayer.finishDraft()
            onCancelRequested: page.editLayer.cancelDraft()
        }
        DropArea {
            id: drop

            anchors.fill: parent
            keys: ["text/uri-list"]
            onDropped: event => {
                if (event.hasUrls)
                    root.session.openUrl(event.urls[0]);
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
    ResultsPanel {
        id: results

        anchors { right: parent.right; top: topBar.bottom; bottom: parent.bottom; rightMargin: root.panelOpen ? 0 : -width }
        width: 308
        visible: root.panelOpen
        session: root.session
        currentFinding: root.currentFinding
        onFindingRequested: index => {
            root.currentFinding = index;
            page.camera.centreOn(root.session.findings.placeOf(index), 17, true);
        }
    }
    ExportDialog {
        id: exportDialog

        anchors.centerIn: Overlay.overlay
        session: root.session
    }
    FileDialog {
        id: fileDialog

        title: qsTr("Open a field boundary")
        nameFilters: [qsTr("Field boundaries (%1)").arg("*.geojson *.json *.shp *.zip *.kml *.kmz *.gpkg *.gml *.fgb *.wkt *.csv"), qsTr("All files (*)")]
        onAccepted: root.session.openUrl(selectedFile)
    }
    Connections {
        target: root.session

        function onFieldOpened(): void {
            page.fitField(false);
        }
        function onPlanChanged(): void {
            if (root.currentFinding >= root.session.findings.count)
                root.currentFinding = -1;
        }
    }

    function openFile(): void {
        fileDialog.open();
    }
}
