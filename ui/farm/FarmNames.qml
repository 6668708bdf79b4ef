pragma ComponentBehavior: Bound
import QtQuick
import QtPositioning
import Furrow.Controls
import Furrow.Map

/// The fields of the farm on the map: their outlines always, their names and a click on them while the list
/// is in view.
Item {
    id: root

    required property FarmList fields
    required property MapCamera camera
    property bool choosing: false
    signal picked(row: int, how: int)
    signal opened(row: int)

    FarmLayer {
        objectName: "farmLayer"
        anchors.fill: parent
        camera: root.camera
        fields: root.fields
        showSelection: root.choosing
        lineColor: Theme.boundary
        casingColor: Theme.casing
        selectionColor: Theme.accent
        lineFactor: Theme.lineFactor
        opacity: root.choosing ? 1 : 0.55
    }
    Repeater {
        model: root.choosing ? root.fields : null

        Rectangle {
            id: label

            required property int index
            required property string name
            required property bool selected
            required property var bounds
            /// Again with every move of the camera.
            readonly property point corner: root.camera.zoomLevel > 0 && root.camera.center.isValid ? root.camera.position(bounds.topLeft) : Qt.point(0, 0)
            readonly property point opposite: root.camera.zoomLevel > 0 && root.camera.center.isValid ? root.camera.position(bounds.bottomRight) : Qt.point(0, 0)
            readonly property real span: opposite.x - corner.x
            /// A small field has its name below it.
            readonly property bool within: span > text.implicitWidth + 30 && opposite.y - corner.y > 40

            objectName: "farm.name." + index
            visible: span > 24 || selected && span > 4
            x: (corner.x + opposite.x - width) / 2
            y: within ? (corner.y + opposite.y - height) / 2 : opposite.y + 3
            width: Math.min(text.implicitWidth + 12, Math.max(90, span))
            height: 20
            radius: 10
            color: Qt.alpha(Theme.panel, 0.86)
            border.width: selected ? 1.5 : 0
            border.color: Theme.accent

            Caption {
                id: text

                anchors.centerIn: parent
                width: Math.min(implicitWidth, parent.width - 12)
                text: label.name
                color: Theme.ink
                elide: Text.ElideRight
            }
        }
    }
    TapHandler {
        enabled: root.choosing
        onTapped: point => {
            const row = root.fields.rowAt(root.camera.coordinateAt(point.position));
            if (row >= 0)
                root.picked(row, point.modifiers & (Qt.ControlModifier | Qt.ShiftModifier) ? FarmList.Toggle : FarmList.Only);
        }
        onDoubleTapped: point => {
            const row = root.fields.rowAt(root.camera.coordinateAt(point.position));
            if (row >= 0)
                root.opened(row);
        }
    }
}
