import QtQuick
import QtQuick.Shapes
import Furrow.Controls

/// The outline of a field, small.
Shape {
    id: root

    /// In the unit square.
    required property list<point> outline

    preferredRendererType: Shape.CurveRenderer

    ShapePath {
        strokeColor: Theme.accent
        strokeWidth: 1.4
        fillColor: Theme.softAccent
        scale: Qt.size(root.width, root.height)

        PathPolyline { path: root.outline }
    }
}
