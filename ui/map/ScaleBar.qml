import QtQuick
import Furrow.Controls

/// A round length and how long it is on the map.
Rectangle {
    id: root

    required property MapCamera camera
    // The call alone would not be made again when the camera moves.
    readonly property real metres: camera.metresPerPixel > 0 ? camera.roundLengthFor(120) : 1

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
        text: root.metres >= 1000 ? qsTr("%1 km").arg(Number(root.metres / 1000).toLocaleString(Qt.locale(), "f", 0)) : qsTr("%1 m").arg(root.metres >= 1 ? root.metres : root.metres.toFixed(2))
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
