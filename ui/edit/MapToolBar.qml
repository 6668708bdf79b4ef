import QtQuick
import Furrow.Controls

/// The tools that float on the map.
Rectangle {
    id: root

    required property FieldEditor editor
    required property bool hasField
    property bool layersOpen: false
    /// As high as it may be. If that is too little, what draws stands in one column and the rest in another.
    property real room: 100000
    readonly property real side: 38
    // Tools above the first line, and below it.
    readonly property int drawing: 7
    readonly property int others: 4
    readonly property bool oneColumn: room - 8 >= (drawing + others) * (side + flow.spacing) + 2 * (Theme.hairline + flow.spacing)
    signal toolRequested(tool: int)
    signal fitRequested()
    signal layersRequested()
    signal zoomRequested(levels: real)

    objectName: "mapToolBar"
    width: flow.implicitWidth + 8
    height: flow.implicitHeight + 8
    radius: Theme.cardRadius
    color: Theme.panel
    border.width: Theme.hairline
    border.color: Theme.line

    component Tool: ToolIconButton {
        required property int tool

        checked: root.editor.tool === tool
        onClicked: root.toolRequested(tool)
    }
    component Line: Rectangle {
        width: root.side
        height: Theme.hairline
        color: Theme.line
    }

    SoftShadow { radius: root.radius }
    Flow {
        id: flow

        x: 4
        y: 4
        height: Math.max(root.side, Math.min(root.room - 8, root.oneColumn ? root.room : root.drawing * (root.side + spacing)))
        flow: Flow.TopToBottom
        spacing: 2

        Tool {
            objectName: "selectTool"
            tool: FieldEditor.Select
            iconName: "select"
            hint: qsTr("Select and change (V)")
        }
        Tool {
            objectName: "drawTool"
            tool: FieldEditor.Field
            iconName: "draw"
            hint: qsTr("Draw a field (B)")
        }
        Tool {
            objectName: "holeTool"
            tool: FieldEditor.Hole
            iconName: "hole"
            hint: qsTr("Draw a hole (H)")
            enabled: root.hasField
        }
        Tool {
            objectName: "obstacleTool"
            tool: FieldEditor.Obstacle
            iconName: "obstacle"
            hint: qsTr("Draw an obstacle (O)")
            enabled: root.hasField
        }
        Tool {
            objectName: "guideTool"
            tool: FieldEditor.Guide
            iconName: "ab-line"
            hint: qsTr("Draw an AB line (L)")
            enabled: root.hasField
        }
        Tool {
            objectName: "splitTool"
            tool: FieldEditor.Split
            iconName: "split"
            hint: qsTr("Draw a split line (S)")
            enabled: root.hasField
        }
        Tool {
            objectName: "gateTool"
            tool: FieldEditor.Gate
            iconName: "gate"
            hint: qsTr("Add a gate (G)")
            enabled: root.hasField
        }
        Line { visible: root.oneColumn }
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
        Line {}
        ToolIconButton {
            objectName: "layersTool"
            iconName: "layers"
            hint: qsTr("Layers (Ctrl+L)")
            checked: root.layersOpen
            onClicked: root.layersRequested()
        }
    }
}
