pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls
import Furrow.Map

/// Comments at their places on the map, and the click that gives a new one its place.
Item {
    id: root

    required property ReviewModel review
    required property MapCamera camera
    property int current: -1
    /// The next click on the map is the place of a comment.
    property alias placing: picker.picking
    signal clicked(row: int)
    signal placed(place: var)

    Repeater {
        model: root.review

        T.Button {
            id: pin

            required property int index
            required property int number
            required property bool hasPlace
            required property bool settled
            required property string said
            required property var place
            /// Again with every move of the camera.
            readonly property point at: root.camera.zoomLevel > 0 && root.camera.center.isValid && hasPlace ? root.camera.position(place) : Qt.point(-100, -100)

            objectName: "pin." + index
            visible: hasPlace
            x: at.x - width / 2
            y: at.y - height - 7
            width: 26
            height: 24
            focusPolicy: Qt.NoFocus
            // A finger needs more than the pin.
            containmentMask: Item {
                x: (pin.width - width) / 2
                y: (pin.height - height) / 2
                width: Theme.controlHeight
                height: Theme.controlHeight
            }
            Accessible.name: qsTr("Comment %1: %2").arg(number).arg(said)
            onClicked: root.clicked(index)

            background: Item {
                Rectangle {
                    anchors { horizontalCenter: parent.horizontalCenter; top: box.bottom; topMargin: -6 }
                    width: 10
                    height: 10
                    rotation: 45
                    color: box.color
                    border { width: box.border.width; color: box.border.color }
                }
                Rectangle {
                    id: box

                    anchors.fill: parent
                    radius: 7
                    color: pin.settled ? Theme.panel : Theme.accent
                    border.width: root.current === pin.index ? 3 : 1.5
                    border.color: root.current === pin.index ? Theme.ink : pin.settled ? Theme.muted : Theme.panel
                }
            }
            contentItem: BodyText {
                text: pin.number
                color: pin.settled ? Theme.muted : Theme.accentInk
                font.pixelSize: 12
                font.weight: Font.DemiBold
                horizontalAlignment: Text.AlignHCenter
                verticalAlignment: Text.AlignVCenter
            }
        }
    }
    PlacePicker {
        id: picker

        objectName: "commentPicker"
        anchors.fill: parent
        camera: root.camera
        hint: qsTr("Click the place that you want to comment on. Esc ends it.")
        onPicked: place => root.placed(place)
    }
}
