import QtQuick
import Furrow.Controls
import Furrow.Text

/// A round length and how long it is on the map.
Rectangle {
    id: root

    required property MapCamera camera
    readonly property real metres: Display.quantities.roundLengthBelow(120 * camera.metresPerPixel)

    objectName: "scaleBar"
    width: 148
    height: 34
    radius: 6
    color: Qt.alpha(Theme.panel, 0.86)
    Accessible.role: Accessible.StaticText
    Accessible.name: qsTr("Scale: the bar is %1 long").arg(label.text)

    BodyText {
        id: label

        anchors { horizontalCenter: bar.horizontalCenter; bottom: bar.top; bottomMargin: 1 }
        text: Display.quantities.scaleText(root.metres)
        font.pixelSize: Theme.labelSize
    }
    Item {
        id: bar

        x: 12
        y: 21
        width: root.metres / root.camera.metresPerPixel
        height: 6

        Rectangle { width: 1.6; height: parent.height; color: Theme.ink }
        Rectangle { y: parent.height - 1.6; width: parent.width; height: 1.6; color: Theme.ink }
        Rectangle { x: parent.width - 1.6; width: 1.6; height: parent.height; color: Theme.ink }
    }
}
