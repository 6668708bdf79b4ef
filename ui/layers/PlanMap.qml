pragma ComponentBehavior: Bound
import QtQuick
import Furrow.Controls
import Furrow.Map

/// A plan on its ground, as a camera sees it: the coasts, the map from the network, imagery and one plan. Takes no
/// mouse and no keys.
Item {
    id: root

    required property MapCamera camera
    required property ImageryModel imagery
    required property planDrawing drawing
    required property planStyle style
    property bool imageryShown: true
    /// The map from the network is wanted.
    property bool online: false
    property string onlineServer: "https://tile.openstreetmap.org/"
    /// Before the names of its layers, where there are several maps.
    property string prefix: ""
    readonly property alias planLayer: plan

    Rectangle {
        anchors.fill: parent
        color: Theme.mapGround

        Rectangle {
            anchors.fill: parent
            color: Theme.mapSea
            opacity: world.loaded ? Math.max(0, Math.min(1, (11 - root.camera.zoomLevel) / 2)) : 0
        }
    }
    WorldLayer {
        id: world

        anchors.fill: parent
        camera: root.camera
        landColor: Theme.mapGround
        coastColor: Theme.mapCoast
        gridColor: Theme.mapGrid
    }
    Loader {
        anchors.fill: parent
        active: root.online
        sourceComponent: OnlineMap {
            camera: root.camera
            server: root.onlineServer
        }
    }
    ImageryItem {
        objectName: root.prefix + "imageryItem"
        anchors.fill: parent
        visible: root.imageryShown
        camera: root.camera
        imagery: root.imagery
    }
    PlanLayer {
        id: plan

        objectName: root.prefix + "planLayer"
        anchors.fill: parent
        camera: root.camera
        drawing: root.drawing
        style: root.style
    }
}
