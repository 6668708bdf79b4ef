import QtQuick
import Furrow.Controls

/// The next click on the map is a place that is asked for.
Item {
    id: root

    required property MapCamera camera
    property bool picking: false
    property string hint: ""
    signal picked(place: var)

    onPickingChanged: {
        if (picking)
            forceActiveFocus();
    }
    Keys.onEscapePressed: root.picking = false

    MouseArea {
        anchors.fill: parent
        enabled: root.picking
        visible: enabled
        cursorShape: Qt.CrossCursor
        onClicked: mouse => {
            root.picking = false;
            root.picked(root.camera.coordinateAt(Qt.point(mouse.x, mouse.y)));
        }
    }
    Rectangle {
        anchors { horizontalCenter: parent.horizontalCenter; bottom: parent.bottom; bottomMargin: 64 }
        visible: root.picking
        width: label.implicitWidth + 32
        height: 38
        radius: 19
        color: Theme.panel
        border.width: Theme.hairline
        border.color: Theme.line

        BodyText {
            id: label

            objectName: root.objectName + ".hint"
            anchors.centerIn: parent
            text: root.hint
        }
    }
}
