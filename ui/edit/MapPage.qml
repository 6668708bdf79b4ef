import QtQuick
import QtLocation
import QtPositioning
import Furrow.Controls

/// The map with the plan on it, and the tools to draw and change a boundary.
FocusScope {
    id: root

    required property planDrawing drawing
    required property planStyle planStyle
    readonly property alias camera: camera
    readonly property alias drawingBoundary: edit.drafting
    readonly property alias editLayer: edit
    readonly property alias planLayer: plan

    signal boundaryDrawn(points: list<geoCoordinate>)
    signal vertexMoved(part: int, ring: int, vertex: int, place: geoCoordinate, finished: bool)
    signal findingClicked(index: int)

    clip: true
    Keys.onPressed: event => {
        event.accepted = true;
        if (event.key === Qt.Key_Escape && edit.drafting)
            edit.cancelDraft();
        else if ((event.key === Qt.Key_Return || event.key === Qt.Key_Enter) && edit.drafting)
            edit.finishDraft();
        else if (event.key === Qt.Key_Backspace && edit.drafting)
            edit.removeLastPoint();
        else if (event.key === Qt.Key_Plus)
            camera.zoomBy(1);
        else if (event.key === Qt.Key_Minus)
            camera.zoomBy(-1);
        else if (event.key === Qt.Key_F)
            root.fitField(true);
        else if (event.key === Qt.Key_B)
            root.startDrawing();
        else if (event.key === Qt.Key_Left)
            camera.panBy(60, 0);
        else if (event.key === Qt.Key_Right)
            camera.panBy(-60, 0);
        else if (event.key === Qt.Key_Up)
            camera.panBy(0, 60);
        else if (event.key === Qt.Key_Down)
            camera.panBy(0, -60);
        else
            event.accepted = false;
    }

    MapCamera {
        id: camera

        viewport: Qt.size(root.width, root.height)
        motion: Theme.motion
    }
    Rectangle {
        anchors.fill: parent
        color: Theme.mapGround

        Rectangle {
            anchors.fill: parent
            color: Theme.mapSea
            opacity: world.loaded ? Math.max(0, Math.min(1, (11 - camera.zoomLevel) / 2)) : 0
        }
    }
    WorldLayer {
        id: world

        anchors.fill: parent
        camera: camera
        landColor: Theme.mapGround
        coastColor: Theme.mapCoast
        gridColor: Theme.mapGrid
    }
    Map {
        id: map

        objectName: "map"
        anchors.fill: parent
        plugin: Plugin { name: "itemsoverlay" }
        color: "transparent"
        copyrightsVisible: false
        maximumTilt: 0
        center: camera.center
        zoomLevel: camera.zoomLevel

        PlanLayer {
            id: plan

            objectName: "planLayer"
            anchors.fill: parent
            z: 1
            camera: camera
            drawing: root.drawing
            style: root.planStyle
        }
        EditLayer {
            id: edit

            readonly property bool drafting: tool === EditLayer.Draw

            objectName: "editLayer"
            anchors.fill: parent
            z: 2
            focus: true
            camera: camera
            drawing: root.drawing
            lineColor: Theme.boundary
            casingColor: Theme.casing
            handleColor: Theme.dark ? "#E8EFEA" : "#FFFFFF"
            accentColor: Theme.accent
            Accessible.name: qsTr("Map")

            onBoundaryDrawn: points => root.boundaryDrawn(points)
            onVertexMoved: (part, ring, vertex, place, finished) => root.vertexMoved(part, ring, vertex, place, finished)
            onClicked: pixel => {
                const finding = plan.findingAt(pixel);
                if (finding >= 0)
                    root.findingClicked(finding);
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
    MapToolBar {
        x: 16
        y: 16
        drawing: edit.drafting
        hasField: !root.drawing.empty
        onSelectRequested: {
            edit.cancelDraft();
            edit.forceActiveFocus();
        }
        onDrawRequested: root.startDrawing()
        onFitRequested: root.fitField(true)
        onZoomRequested: levels => camera.zoomBy(levels)
    }
    ScaleBar {
        anchors { left: parent.left; bottom: parent.bottom; margins: 12 }
        camera: camera
    }

    function startDrawing(): void {
        edit.tool = EditLayer.Draw;
        edit.forceActiveFocus();
    }
    function fitField(animated: bool): void {
        if (!root.drawing.empty)
            camera.fit(root.drawing.bounds, 84, 72, 48, 72, animated);
    }
}
