import QtQuick
import QtPositioning
import Furrow.Controls
import Furrow.Map

/// Rings that spread from the place of a finding as it is gone to, so that the eye finds it.
Item {
    id: root

    required property MapCamera camera
    property geoCoordinate place
    /// Again with every move of the camera.
    readonly property point at: root.camera.zoomLevel > 0 && root.camera.center.isValid && place.isValid ? root.camera.position(place) : Qt.point(-200, -200)

    visible: pulse.running

    Rectangle {
        id: ring

        property real spread: 0

        x: root.at.x - width / 2
        y: root.at.y - height / 2
        width: 34 + 46 * spread
        height: width
        radius: width / 2
        color: "transparent"
        border { width: 3; color: Theme.finding }
        opacity: 1 - spread
    }
    SequentialAnimation {
        id: pulse

        loops: 3

        NumberAnimation {
            target: ring
            property: "spread"
            from: 0
            to: 1
            duration: Theme.motion * 5
            easing.type: Easing.OutCubic
        }
    }

    function begin(place: geoCoordinate): void {
        root.place = place;
        if (Theme.motion > 0)
            pulse.restart();
    }
}
