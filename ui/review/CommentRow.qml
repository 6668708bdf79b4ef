import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// A comment with its number on the map; pressing it goes there.
T.Button {
    id: root

    required property int number
    required property string by
    required property string said
    required property bool hasPlace
    required property bool old
    required property bool settled
    /// Written by whoever writes here.
    required property bool own
    property bool current: false
    signal settledChosen(on: bool)
    signal editChosen()
    signal removeChosen()

    implicitHeight: lines.height + 18
    focusPolicy: Qt.StrongFocus
    Accessible.name: qsTr("Comment %1 by %2: %3").arg(number).arg(by).arg(said)

    background: Rectangle {
        radius: Theme.radius
        color: root.hovered ? Theme.hover : Theme.sunken
        border.width: root.current ? 2 : Theme.sunlight ? 1 : 0
        border.color: root.current ? Theme.accent : Theme.line

        Focusable { control: root }
    }
    contentItem: Item {
        Rectangle {
            x: 10
            y: 10
            width: 22
            height: 20
            radius: 6
            color: root.settled ? "transparent" : Theme.accent
            border.width: root.settled ? 1.5 : 0
            border.color: Theme.muted

            BodyText {
                anchors.centerIn: parent
                text: root.number
                color: root.settled ? Theme.muted : Theme.accentInk
                font.pixelSize: 11
                font.weight: Font.DemiBold
            }
        }
        Column {
            id: lines

            anchors { left: parent.left; right: parent.right; leftMargin: 42; rightMargin: 10 }
            y: 9
            spacing: 2

            BodyText {
                width: parent.width
                text: root.said
                wrapMode: Text.Wrap
                font.pixelSize: 13
                lineHeight: 1.15
                color: root.settled ? Theme.muted : Theme.ink
            }
            Caption {
                width: parent.width
                visible: text.length > 0
                text: root.by
                elide: Text.ElideRight
            }
            Caption {
                width: parent.width
                visible: root.old
                text: qsTr("Of a plan before the last change")
                color: Theme.warning
                wrapMode: Text.WordWrap
            }
            Flow {
                x: -6
                width: parent.width + 6
                spacing: 4

                SmallButton {
                    objectName: root.objectName + ".settle"
                    text: root.settled ? qsTr("Open again") : qsTr("Settled")
                    onClicked: root.settledChosen(!root.settled)
                }
                SmallButton {
                    objectName: root.objectName + ".edit"
                    visible: root.own
                    text: qsTr("Edit")
                    onClicked: root.editChosen()
                }
                SmallButton {
                    objectName: root.objectName + ".remove"
                    text: qsTr("Remove")
                    onClicked: root.removeChosen()
                }
            }
        }
    }
}
