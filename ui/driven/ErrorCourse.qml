import QtQuick
import QtQuick.Shapes
import QtQuick.Templates as T
import Furrow.Controls

/// How far left or right of the plan was driven, along the recording. A click, or Return at the mark that the
/// arrow keys move, goes to the place.
T.Control {
    id: root

    required property list<point> course
    required property string upper
    property real mark: -1
    signal placeChosen(share: real)

    implicitHeight: 110
    focusPolicy: Qt.StrongFocus
    Accessible.role: Accessible.Chart
    Accessible.name: qsTr("Distance from the plan along the recording, up to %1").arg(top)
    Keys.onLeftPressed: root.mark = Math.max(0, root.mark < 0 ? 0 : root.mark - 0.01)
    Keys.onRightPressed: root.mark = Math.min(1, root.mark < 0 ? 0 : root.mark + 0.01)
    Keys.onReturnPressed: {
        if (root.mark >= 0)
            root.placeChosen(root.mark);
    }

    background: Rectangle {
        radius: Theme.radius
        color: Theme.sunken
        border.width: Theme.hairline
        border.color: Theme.line

        Focusable { control: root }
    }
    contentItem: Item {
        Rectangle {
            x: 8
            y: parent.height / 2
            width: parent.width - 16
            height: 1
            color: Theme.line
        }
        Shape {
            id: shape

            anchors { fill: parent; leftMargin: 8; rightMargin: 8; topMargin: 18; bottomMargin: 18 }
            preferredRendererType: Shape.CurveRenderer

            ShapePath {
                strokeColor: Theme.swath
                strokeWidth: 1.4
                fillColor: "transparent"
                scale: Qt.size(shape.width, shape.height)

                PathPolyline { path: root.course }
            }
        }
        Rectangle {
            x: 8 + (parent.width - 16) * root.mark
            y: 14
            visible: root.mark >= 0
            width: 2
            height: parent.height - 28
            color: Theme.accent
        }
        Caption {
            x: 8
            y: 3
            text: qsTr("%1 to the left").arg(root.upper)
            font.pixelSize: 11
        }
        Caption {
            anchors { left: parent.left; leftMargin: 8; bottom: parent.bottom; bottomMargin: 3 }
            text: qsTr("%1 to the right").arg(root.upper)
            font.pixelSize: 11
        }
        MouseArea {
            anchors.fill: parent
            onClicked: mouse => {
                root.mark = Math.max(0, Math.min(1, (mouse.x - 8) / Math.max(1, width - 16)));
                root.placeChosen(root.mark);
            }
        }
    }
}
