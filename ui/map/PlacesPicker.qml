pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// Clicks on the map add places, a click on one of them removes it, until Done is said.
Item {
    id: root

    required property MapCamera camera
    property bool picking: false
    property string hint: ""
    /// The places so far, as coordinates.
    property var places: []
    signal added(place: var)
    signal removed(index: int)

    onPickingChanged: {
        if (picking)
            forceActiveFocus();
    }
    Keys.onEscapePressed: root.picking = false
    Keys.onReturnPressed: root.picking = false
    Keys.onEnterPressed: root.picking = false

    MouseArea {
        anchors.fill: parent
        enabled: root.picking
        visible: enabled
        cursorShape: Qt.CrossCursor
        onClicked: mouse => root.added(root.camera.coordinateAt(Qt.point(mouse.x, mouse.y)))
    }
    Repeater {
        model: root.picking ? root.places : []

        T.Button {
            id: mark

            required property int index
            required property var modelData
            /// Again with every move of the camera.
            readonly property point at: root.camera.zoomLevel > 0 && root.camera.center.isValid ? root.camera.position(modelData) : Qt.point(-100, -100)

            objectName: root.objectName + ".place." + index
            x: at.x - width / 2
            y: at.y - height / 2
            width: 26
            height: 26
            focusPolicy: Qt.StrongFocus
            // A finger needs more than the mark.
            containmentMask: Item {
                x: (mark.width - width) / 2
                y: (mark.height - height) / 2
                width: Theme.controlHeight
                height: Theme.controlHeight
            }
            Accessible.name: qsTr("Place %1: remove it").arg(index + 1)
            onClicked: {
                // The mark goes, and the keys stay here.
                root.forceActiveFocus();
                root.removed(index);
            }

            background: Rectangle {
                radius: width / 2
                color: mark.hovered ? Theme.failure : Theme.accent
                border { width: 2; color: Theme.panel }

                Focusable { control: mark; gap: 2 }
            }
            contentItem: BodyText {
                text: mark.hovered ? "×" : mark.index + 1
                color: Theme.accentInk
                font.pixelSize: 12
                font.weight: Font.DemiBold
                horizontalAlignment: Text.AlignHCenter
                verticalAlignment: Text.AlignVCenter
            }
        }
    }
    Rectangle {
        anchors { horizontalCenter: parent.horizontalCenter; bottom: parent.bottom; bottomMargin: 64 }
        visible: root.picking
        width: row.implicitWidth + 28
        height: 52
        radius: Theme.cardRadius
        color: Theme.panel
        border.width: Theme.hairline
        border.color: Theme.line

        Row {
            id: row

            anchors.centerIn: parent
            spacing: 12

            BodyText {
                objectName: root.objectName + ".hint"
                anchors.verticalCenter: parent.verticalCenter
                text: root.hint
            }
            PushButton {
                objectName: root.objectName + ".done"
                text: qsTr("Done")
                primary: true
                onClicked: root.picking = false
            }
        }
    }
}
