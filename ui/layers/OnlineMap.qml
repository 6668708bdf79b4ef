pragma ComponentBehavior: Bound
import QtQuick
import QtLocation
import QtPositioning
import Furrow.Controls
import Furrow.Map

/// The map of OpenStreetMap from its servers. Nothing is fetched before this item is made.
Item {
    id: root

    required property MapCamera camera
    /// Where the tiles come from, with the slash at its end.
    required property string server
    /// Its tiles end at this zoom; closer they are drawn larger.
    readonly property real finest: 19
    readonly property real larger: Math.pow(2, Math.max(0, camera.zoomLevel - finest))

    objectName: "onlineMap"
    clip: true

    // A parameter of a plugin is taken once: it has to be known when the map is made.
    Loader {
        width: root.width / root.larger
        height: root.height / root.larger
        transformOrigin: Item.TopLeft
        scale: root.larger
        active: root.server.length > 0
        sourceComponent: Map {
            maximumTilt: 0
            copyrightsVisible: false
            center: root.camera.center
            zoomLevel: Math.min(root.camera.zoomLevel, root.finest)
            plugin: Plugin {
                name: "osm"

                PluginParameter { name: "osm.useragent"; value: "Furrow/" + Application.version }
                PluginParameter { name: "osm.mapping.providersrepository.disabled"; value: true }
                PluginParameter { name: "osm.mapping.custom.host"; value: root.server }
                PluginParameter { name: "osm.mapping.custom.mapcopyright"; value: "OpenStreetMap" }
            }
            onMapReadyChanged: {
                const custom = supportedMapTypes.find(type => type.style === MapType.CustomMap);
                if (custom)
                    activeMapType = custom;
            }
        }
    }
    Rectangle {
        anchors { right: parent.right; bottom: parent.bottom }
        width: credit.width + 16
        height: credit.height + 8
        color: Qt.alpha(Theme.panel, 0.86)

        BodyText {
            id: credit

            anchors.centerIn: parent
            objectName: "onlineMap.credit"
            text: qsTr("© OpenStreetMap contributors")
            font.pixelSize: Theme.labelSize
            Accessible.role: Accessible.StaticText
            Accessible.name: text
        }
    }
}
