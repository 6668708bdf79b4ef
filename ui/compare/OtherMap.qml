import QtQuick
import Furrow.Controls
import Furrow.Layers
import Furrow.Map

/// The other one of two plans on a map of its own. It has the camera of the first map: what moves one, moves both.
Item {
    id: root

    required property PlanComparison comparison
    required property MapCamera camera
    required property ImageryModel imagery
    required property planStyle style
    property bool imageryShown: true
    property bool online: false
    property string onlineServer
    property color lineColor
    property color casingColor

    clip: true
    Accessible.role: Accessible.Pane
    Accessible.name: qsTr("Map of the other plan: %1").arg(comparison.secondName)

    PlanMap {
        id: map

        anchors.fill: parent
        prefix: "other."
        camera: root.camera
        imagery: root.imagery
        imageryShown: root.imageryShown
        online: root.online
        onlineServer: root.onlineServer
        drawing: root.comparison.drawing
        style: root.style
    }
    DifferenceLayer {
        objectName: "other.differences"
        anchors.fill: parent
        camera: root.camera
        comparison: root.comparison
        showFirst: false
        secondColor: root.lineColor
        casingColor: root.casingColor
        lineFactor: Theme.lineFactor
    }
    DragHandler {
        id: drag

        property vector2d last

        target: null
        dragThreshold: 4
        cursorShape: active ? Qt.ClosedHandCursor : Qt.ArrowCursor
        onActiveChanged: last = Qt.vector2d(0, 0)
        onActiveTranslationChanged: {
            root.camera.panBy(activeTranslation.x - last.x, activeTranslation.y - last.y);
            last = Qt.vector2d(activeTranslation.x, activeTranslation.y);
        }
    }
    WheelHandler {
        acceptedDevices: PointerDevice.Mouse | PointerDevice.TouchPad
        onWheel: event => root.camera.turnWheel(Qt.point(event.x, event.y), event.angleDelta.y)
    }
    PinchHandler {
        property real last: 1

        target: null
        onActiveChanged: last = 1
        onActiveScaleChanged: {
            root.camera.zoomAt(centroid.position, Math.log2(activeScale / last), false);
            last = activeScale;
        }
    }
    Column {
        anchors.centerIn: parent
        width: Math.min(260, parent.width - 32)
        visible: root.comparison.busy && !root.comparison.ready
        spacing: 8

        BodyText {
            width: parent.width
            text: qsTr("The other plan is being made …")
            horizontalAlignment: Text.AlignHCenter
            wrapMode: Text.WordWrap
        }
        ProgressLine {
            width: parent.width
            value: root.comparison.progress
        }
    }
    MapName {
        objectName: "other.name"
        anchors { right: parent.right; bottom: parent.bottom; margins: 12 }
        name: qsTr("The other: %1").arg(root.comparison.secondName)
        lineColor: root.lineColor
        dashed: true
    }
}
