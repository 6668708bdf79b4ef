import QtQuick
import QtPositioning
import Furrow.Controls
import Furrow.Layers
import Furrow.Map
import Furrow.Project

/// The map with the plan on it, and the tools to draw and change a field.
FocusScope {
    id: root

    required property Document document
    required property ShownPlan shown
    required property planStyle planStyle
    required property ImageryModel imagery
    required property bool hasField
    /// The cells at one step of how they came about; shown while `steppingCells`.
    required property cellDrawing cells
    required property bool steppingCells
    /// Another plan of the field, drawn in place of the one that is shown while that is wanted.
    property planDrawing other
    property bool showOther: false
    /// Its key is held.
    property bool otherHeld: false
    readonly property planDrawing drawing: shown.drawing
    property bool imageryShown: true
    /// The map from the network is wanted.
    property bool online: false
    property string onlineServer: "https://tile.openstreetmap.org/"
    property bool layersOpen: false
    readonly property alias camera: camera
    readonly property alias editor: editor
    readonly property alias planLayer: ground.planLayer
    /// How near a traced line is kept to, m.
    readonly property real traceTolerance: camera.zoomLevel > 0 && camera.center.isValid ? edit.traceTolerance() : 0
    readonly property alias toolBar: tools
    /// What lies over the plan and below the tools.
    property alias overlays: overlay.data

    signal findingClicked(index: int)
    signal fieldDrawn(boundary: list<geoCoordinate>)
    signal inspectRequested()
    signal layersRequested()

    /// No room for the tools beside the state of the plan: they begin below it.
    readonly property bool narrow: width < 420

    /// Worked with keys just now, so it shows that it has them.
    property bool keyed: false

    clip: true
    onActiveFocusChanged: root.otherHeld = false
    Keys.onReleased: event => {
        root.keyed = true;
        if (event.key === Qt.Key_X && !event.isAutoRepeat)
            root.otherHeld = false;
    }
    Keys.onPressed: event => {
        event.accepted = true;
        const drawing = editor.drawing;
        const step = camera.metresPerPixel * (event.modifiers & Qt.ShiftModifier ? 10 : 1);
        const ways = { [Qt.Key_Left]: [-1, 0], [Qt.Key_Right]: [1, 0], [Qt.Key_Up]: [0, 1], [Qt.Key_Down]: [0, -1] };
        const way = ways[event.key];
        if (event.key === Qt.Key_Escape)
            event.accepted = editor.escape();
        else if ((event.key === Qt.Key_Return || event.key === Qt.Key_Enter) && drawing)
            editor.finishSketch();
        else if ((event.key === Qt.Key_Return || event.key === Qt.Key_Enter) && editor.hasSelection)
            root.inspectRequested();
        else if (event.key === Qt.Key_Backspace && drawing)
            editor.removeLastPoint();
        else if (event.key === Qt.Key_Delete || event.key === Qt.Key_Backspace)
            editor.deleteSelection();
        else if (event.key === Qt.Key_Space && drawing)
            editor.addPointAt(camera.center);
        else if (event.key === Qt.Key_Space || event.key === Qt.Key_Period)
            editor.selectNext(1);
        else if (event.key === Qt.Key_Comma)
            editor.selectNext(-1);
        else if (event.key === Qt.Key_PageDown && !drawing)
            editor.selectNextShape(1);
        else if (event.key === Qt.Key_PageUp && !drawing)
            editor.selectNextShape(-1);
        else if (event.key === Qt.Key_Plus)
            camera.zoomBy(1);
        else if (event.key === Qt.Key_Minus)
            camera.zoomBy(-1);
        else if (way && editor.hasSelection && !drawing)
            editor.nudge(way[0] * step, way[1] * step);
        else if (way)
            camera.panBy(-60 * way[0], 60 * way[1]);
        else if (event.key === Qt.Key_X)
            root.otherHeld = true;
        else
            event.accepted = false;
    }

    FieldEditor {
        id: editor

        document: root.document
        shown: root.shown
        onFieldDrawn: boundary => root.fieldDrawn(boundary)
    }
    MapCamera {
        id: camera

        viewport: Qt.size(root.width, root.height)
        motion: Theme.motion
    }
    PlanMap {
        id: ground

        anchors.fill: parent
        camera: camera
        imagery: root.imagery
        imageryShown: root.imageryShown
        online: root.online
        onlineServer: root.onlineServer
        drawing: root.showOther ? root.other : root.drawing
        style: root.showOther ? root.planStyle.ofAnotherPlan() : root.planStyle
    }
    Item {
        id: map

        objectName: "map"
        anchors.fill: parent

        CellLayer {
            objectName: "cellLayer"
            anchors.fill: parent
            z: 1
            visible: root.steppingCells
            camera: camera
            drawing: root.cells
            color: Theme.ink
            fillColor: Theme.accent
            casingColor: Theme.panel
            joinedColor: Theme.turn
            lineFactor: Theme.lineFactor
        }
        EditLayer {
            id: edit

            objectName: "editLayer"
            anchors.fill: parent
            z: 2
            focus: true
            camera: camera
            editor: editor
            lineColor: Theme.boundary
            casingColor: Theme.casing
            handleColor: Theme.dark ? "#E8EFEA" : "#FFFFFF"
            accentColor: Theme.accent
            guideColor: Theme.startMark
            splitColor: Theme.split
            obstacleColor: Theme.obstacle
            lineFactor: Theme.lineFactor
            Accessible.name: qsTr("Map")

            onClicked: pixel => {
                const finding = ground.planLayer.findingAt(pixel);
                if (finding >= 0) {
                    edit.accept();
                    root.findingClicked(finding);
                }
            }
        }
        PinchHandler {
            property real last: 1

            target: null
            onActiveChanged: last = 1
            onActiveScaleChanged: {
                camera.zoomAt(centroid.position, Math.log2(activeScale / last), false);
                last = activeScale;
            }
        }
    }
    Item {
        id: overlay

        anchors.fill: parent
    }
    MapToolBar {
        id: tools

        x: 16
        y: root.narrow ? 62 : 16
        room: scaleBar.y - 8 - y
        editor: editor
        hasField: root.hasField
        layersOpen: root.layersOpen
        onLayersRequested: root.layersRequested()
        onToolRequested: tool => root.startTool(tool)
        onFitRequested: root.fitField(true)
        onZoomRequested: levels => camera.zoomBy(levels)
    }
    HoverHandler { onPointChanged: root.keyed = false }
    Rectangle {
        anchors.fill: parent
        visible: root.keyed && edit.activeFocus
        color: "transparent"
        border.width: 2
        border.color: Theme.accent
    }
    ScaleBar {
        id: scaleBar

        anchors { left: parent.left; bottom: parent.bottom; margins: 12 }
        camera: camera
    }

    /// How far from the lower edge something this wide stands in the middle without hiding the scale.
    function clearOfScale(wide: real): real {
        const free = (root.width - wide) / 2 > scaleBar.x + scaleBar.width + 8;
        return free ? 20 : scaleBar.height + 24;
    }
    function startTool(tool: int): void {
        editor.tool = tool;
        edit.forceActiveFocus();
    }
    function startDrawing(): void {
        root.startTool(FieldEditor.Field);
    }
    function fitField(animated: bool): void {
        if (!root.drawing.empty)
            root.fitArea(root.drawing.bounds, animated);
    }
    /// Beside the tools and the status.
    function fitArea(area: geoRectangle, animated: bool): void {
        camera.fit(area, tools.x + tools.width + 22, 72, 48, 72, animated);
    }
}
