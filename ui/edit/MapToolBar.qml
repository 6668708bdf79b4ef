import QtQuick
import Furrow.Controls

/// The tools that float on the map.
Rectangle {
    id: root

    required property bool drawing
    required property bool hasField
    signal selectRequested()
    signal drawRequested()
    signal fitRequested()
    signal zoomRequested(levels: real)

    objectName: "mapToolBar"
    width: 46
    height: column.height + 8
    radius: Theme.cardRadius
    color: Theme.panel
    border.width: Theme.hairline
    border.color: Theme.line

    SoftShadow { radius: root.radius }
    Column {
        id: column

        x: 4
        y: 4
        spacing: 2

        ToolIconButton {
            objectName: "selectTool"
            iconName: "select"
            hint: qsTr("Select and drag points of the boundary")
            checked: !root.drawing
            onClicked: root.selectRequested()
        }
        ToolIconButton {
            objectName: "drawTool"
            iconName: "draw"
            hint: qsTr("Draw a new boundary (B)")
            checked: root.drawing
            onClicked: root.drawRequested()
        }
        Rectangle { width: 38; height: Theme.hairline; color: Theme.line }
        ToolIconButton {
            objectName: "fitTool"
            iconName: "fit"
            hint: qsTr("Show the whole field (F)")
            enabled: root.hasField
            onClicked: root.fitRequested()
        }
        ToolIconButton {
            objectName: "zoomInTool"
            iconName: "zoom-in"
            hint: qsTr("Closer (+)")
            onClicked: root.zoomRequested(1)
        }
        ToolIconButton {
            objectName: "zoomOutTool"
            iconName: "zoom-out"
            hint: qsTr("Further away (−)")
            onClicked: root.zoomRequested(-1)
        }
    }
}
