import QtQuick
import Furrow.Controls

/// What to do while a boundary is drawn.
Rectangle {
    id: root

    required property int points
    required property real lengthM
    signal finishRequested()
    signal cancelRequested()

    objectName: "drawingHint"
    width: row.width + 28
    height: 48
    radius: Theme.cardRadius
    color: Theme.panel
    border.width: Theme.hairline
    border.color: Theme.line

    SoftShadow { radius: root.radius }
    Row {
        id: row

        anchors { left: parent.left; leftMargin: 16; verticalCenter: parent.verticalCenter }
        spacing: 12

        BodyText {
            anchors.verticalCenter: parent.verticalCenter
            text: root.points === 0 ? qsTr("Click the first corner of the field") : root.points < 3 ? qsTr("Click the next corner") : qsTr("Enter closes, Backspace takes one back, Esc stops")
        }
        BodyText {
            anchors.verticalCenter: parent.verticalCenter
            visible: root.points > 0 && root.lengthM > 0
            text: root.lengthM < 1000 ? qsTr("%1 m").arg(root.lengthM.toFixed(1)) : qsTr("%1 km").arg((root.lengthM / 1000).toFixed(2))
            color: Theme.muted
        }
        PushButton {
            objectName: "cancelDrawing"
            text: qsTr("Cancel")
            onClicked: root.cancelRequested()
        }
        PushButton {
            objectName: "finishDrawing"
            text: qsTr("Close boundary")
            primary: true
            enabled: root.points >= 3
            onClicked: root.finishRequested()
        }
    }
}
