pragma ComponentBehavior: Bound
import QtQuick
import Furrow.Controls

/// The project's imagery, topmost first.
Column {
    id: root

    required property ImageryModel imagery
    property real zoomLevel: 3
    signal areaRequested(row: int)
    signal fileRequested()
    signal folderRequested()

    objectName: "imageryList"
    spacing: 8

    BodyText {
        width: parent.width
        visible: root.imagery.count === 0
        text: qsTr("Your own pictures and heights: GeoTIFF, MBTiles or a folder of tiles. They stay on this computer.")
        color: Theme.muted
        wrapMode: Text.WordWrap
        lineHeight: 1.15
    }
    Repeater {
        model: root.imagery

        ImageryRow {
            width: root.width
            imagery: root.imagery
            zoomLevel: root.zoomLevel
            onAreaRequested: root.areaRequested(index)
        }
    }
    Flow {
        width: parent.width
        spacing: 8

        PushButton {
            objectName: "imagery.addFile"
            text: qsTr("Add files…")
            onClicked: root.fileRequested()
        }
        PushButton {
            objectName: "imagery.addFolder"
            text: qsTr("Add a folder of tiles…")
            onClicked: root.folderRequested()
        }
    }
}
