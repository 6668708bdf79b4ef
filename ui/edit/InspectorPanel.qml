pragma ComponentBehavior: Bound
import QtQuick
import Furrow.Controls

/// What is selected on the map: a sentence, its figures, and fields for what can be typed.
Column {
    id: root

    required property Inspector inspector
    readonly property FieldEditor editor: inspector.editor
    /// The drive-through is to go to the segment that is selected.
    signal driveRequested(segment: int)

    objectName: "inspector"
    visible: inspector.shown
    spacing: 8

    Item {
        width: parent.width
        height: Math.max(title.implicitHeight, 24)

        BodyText {
            id: title

            objectName: "inspector.title"
            anchors { left: parent.left; right: note.left; rightMargin: 8; verticalCenter: parent.verticalCenter }
            text: root.inspector.title
            font.pixelSize: Theme.titleSize
            font.weight: Font.DemiBold
            wrapMode: Text.WordWrap
            Accessible.role: Accessible.Heading
            Accessible.name: text
        }
        Caption {
            id: note

            anchors { right: parent.right; verticalCenter: parent.verticalCenter }
            text: qsTr("selected")
        }
    }
    BodyText {
        objectName: "inspector.sentence"
        width: parent.width
        visible: text.length > 0
        text: root.inspector.sentence
        color: Theme.muted
        wrapMode: Text.WordWrap
        lineHeight: 1.2
    }
    Repeater {
        model: root.inspector

        Item {
            id: row

            required property int index
            required property string label
            required property string text
            required property int kind
            required property real number
            required property int quantity
            required property int decimals
            required property real from
            required property real to

            width: root.width
            height: kind === Inspector.Figure ? 29 : 40

            BodyText {
                anchors.verticalCenter: parent.verticalCenter
                text: row.label
                color: Theme.muted
            }
            BodyText {
                anchors { right: parent.right; verticalCenter: parent.verticalCenter }
                visible: row.kind === Inspector.Figure
                text: row.text
                Accessible.role: Accessible.StaticText
                Accessible.name: qsTr("%1: %2").arg(row.label).arg(row.text)
            }
            Loader {
                anchors { right: parent.right; verticalCenter: parent.verticalCenter }
                width: 170
                sourceComponent: row.kind === Inspector.Number ? number : row.kind === Inspector.Text ? words : null
            }
            Rectangle {
                anchors.bottom: parent.bottom
                width: parent.width
                height: Theme.hairline
                color: Theme.line
                visible: row.kind === Inspector.Figure
            }
            Component {
                id: number

                NumberField {
                    objectName: "inspector.number." + row.index
                    name: row.label
                    value: row.number
                    kind: row.quantity
                    decimals: row.decimals
                    from: row.from
                    to: row.to
                    onCommitted: value => root.inspector.setNumber(row.index, value)
                }
            }
            Component {
                id: words

                TextEntry {
                    objectName: "inspector.text." + row.index
                    name: row.label
                    value: row.text
                    onCommitted: entered => root.inspector.setText(row.index, entered)
                }
            }
        }
    }
    CheckRow {
        objectName: "inspector.passable"
        width: parent.width
        visible: root.inspector.hasPassable
        text: qsTr("May be driven on")
        checked: root.inspector.passable
        onToggled: root.inspector.passable = checked
    }
    Flow {
        width: parent.width
        spacing: 8

        PushButton {
            objectName: "inspector.guide"
            visible: root.inspector.isEdge
            text: qsTr("Swaths along it")
            onClicked: root.editor.guideAlongEdge()
        }
        PushButton {
            objectName: "inspector.headlandAsElsewhere"
            visible: root.inspector.hasOwnHeadland
            text: qsTr("Headland as elsewhere")
            onClicked: root.editor.clearEdgeHeadland()
        }
        PushButton {
            objectName: "inspector.drive"
            visible: root.editor.selectedSegment >= 0
            iconName: "play"
            text: qsTr("Drive from here")
            onClicked: root.driveRequested(root.editor.selectedSegment)
        }
        PushButton {
            objectName: "inspector.delete"
            visible: root.editor.canDelete
            iconName: "trash"
            text: qsTr("Delete")
            onClicked: root.editor.deleteSelection()
        }
    }
    Item { width: 1; height: 12 }

    function focusFirst(): void {
        nextItemInFocusChain(true)?.forceActiveFocus(Qt.TabFocusReason);
    }
}
