import QtQuick
import QtQuick.Shapes
import Furrow.Controls

/// The best time over the time of the search, falling from the plan as asked.
Item {
    id: root

    required property list<point> course

    implicitHeight: 72

    Rectangle {
        anchors.fill: parent
        radius: Theme.radius
        color: Theme.sunken
        border.width: Theme.hairline
        border.color: Theme.line
    }
    Shape {
        id: shape

        anchors { fill: parent; leftMargin: 10; rightMargin: 10; topMargin: 12; bottomMargin: 12 }
        preferredRendererType: Shape.CurveRenderer

        ShapePath {
            strokeColor: Theme.accent
            strokeWidth: 2
            fillColor: "transparent"
            capStyle: ShapePath.RoundCap
            joinStyle: ShapePath.RoundJoin
            scale: Qt.size(shape.width, shape.height)

            PathPolyline { path: root.course }
        }
    }
}
