pragma ComponentBehavior: Bound
import QtQuick
import Furrow.Controls

/// What the mouse and the keys do.
ThemedDialog {
    id: root

    required property AppCommands commands
    readonly property int columns: width < 800 ? 1 : 2
    readonly property list<var> onMap: [
        [qsTr("Drag the map, wheel"), qsTr("move, zoom")],
        [qsTr("Arrows, + and −"), qsTr("move the selection or the map, zoom")],
        [qsTr(", and ."), qsTr("the point before, the next point")],
        [qsTr("Enter"), qsTr("finish drawing; type into the inspector")],
        [qsTr("Alt"), qsTr("no snapping while it is held")],
        [qsTr("Esc"), qsTr("stop what was begun")]
    ]

    objectName: "keysDialog"
    title: qsTr("Keys and mouse")
    width: Math.min(980, windowWidth - 40)
    closePolicy: ThemedDialog.CloseOnEscape | ThemedDialog.CloseOnPressOutside

    Grid {
        width: parent.width
        columnSpacing: 24
        rowSpacing: 6
        flow: Grid.TopToBottom
        rows: Math.ceil((keyed.count + root.onMap.length) / root.columns)

        component Line: Item {
            property string keys
            property string what

            width: (root.width - 48 - 24 * (root.columns - 1)) / root.columns
            height: Math.max(20, whatText.implicitHeight)
            Accessible.role: Accessible.StaticText
            Accessible.name: qsTr("%1: %2").arg(keys).arg(what)

            BodyText {
                width: 168
                text: parent.keys
                color: Theme.muted
                elide: Text.ElideRight
            }
            BodyText {
                id: whatText

                x: 176
                width: parent.width - 176
                text: parent.what
                wrapMode: Text.WordWrap
            }
        }
        Repeater {
            id: keyed

            model: root.commands.all.filter(command => command.keysText.length > 0)

            Line {
                required property Command modelData

                keys: modelData.keysText
                what: modelData.name
            }
        }
        Repeater {
            model: root.onMap

            Line {
                required property var modelData

                keys: modelData[0]
                what: modelData[1]
            }
        }
    }
    PushButton {
        objectName: "keysDialog.close"
        anchors.right: parent.right
        text: qsTr("Close")
        primary: true
        focus: true
        onClicked: root.close()
    }
}
