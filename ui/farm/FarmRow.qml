import QtQuick
import QtQuick.Templates as T
import Furrow.Controls
import Furrow.Project

/// A field of the farm and what its plan comes to.
T.ItemDelegate {
    id: root

    required property int index
    required property string name
    required property string plan
    required property string machine
    required property string area
    required property string time
    required property string way
    required property int planState
    required property string stateText
    required property string hint
    required property list<point> outline
    required property bool selected
    required property bool current
    required property FarmColumns columns
    /// The keys are on this row.
    property bool keyed: false
    readonly property bool fails: planState === FarmList.Problems || planState === FarmList.Failed
    /// As on the map: what cannot be driven is a warning, what could not be planned a failure.
    readonly property color stateColour: planState === FarmList.Failed ? Theme.failure : planState === FarmList.Problems || planState === FarmList.OutOfDate ? Theme.warning : Theme.ink
    readonly property string second: [plan, columns.machine > 0 ? "" : machine, hint].filter(part => part.length > 0).join(" · ")
    signal picked(how: int)
    signal opened()

    height: 52
    focusPolicy: Qt.NoFocus
    // The list gives its current row the keys.
    Keys.onSpacePressed: root.picked(FarmList.Toggle)
    Accessible.role: Accessible.ListItem
    Accessible.name: qsTr("%1, %2, %3").arg(name).arg(area).arg(stateText)
    Accessible.selected: selected

    background: Rectangle {
        radius: 6
        color: root.selected ? Theme.softAccent : root.hovered ? Theme.hover : "transparent"
        border.width: root.keyed ? (Theme.sunlight ? 4 : 2) : root.selected && Theme.sunlight ? 2 : 0
        border.color: Theme.accent
    }
    contentItem: Item {
        Rectangle {
            x: root.columns.mark
            anchors.verticalCenter: parent.verticalCenter
            width: 16
            height: 16
            radius: 4
            color: root.selected ? Theme.accent : "transparent"
            border.width: root.selected ? 0 : 1.2
            border.color: Theme.muted

            Icon {
                anchors.centerIn: parent
                width: 14
                height: 14
                name: "check"
                color: Theme.accentInk
                visible: root.selected
            }
        }
        FieldThumbnail {
            x: 34
            anchors.verticalCenter: parent.verticalCenter
            width: 34
            height: 34
            outline: root.outline
        }
        Column {
            x: root.columns.nameAt
            anchors.verticalCenter: parent.verticalCenter
            width: root.columns.name - 8
            spacing: 1

            BodyText {
                width: parent.width
                text: root.name
                elide: Text.ElideRight
                font.weight: root.current ? Font.Bold : Font.Medium
            }
            Caption {
                width: parent.width
                visible: text.length > 0
                text: root.second
                color: root.hint.length > 0 ? Theme.failure : Theme.muted
                elide: Text.ElideRight
            }
        }
        BodyText {
            x: root.columns.machineAt
            anchors.verticalCenter: parent.verticalCenter
            width: root.columns.machine - 8
            visible: root.columns.machine > 0
            text: root.machine
            color: Theme.muted
            elide: Text.ElideRight
        }
        BodyText {
            x: root.columns.areaAt
            anchors.verticalCenter: parent.verticalCenter
            width: root.columns.area - 8
            text: root.area
            elide: Text.ElideRight
        }
        BodyText {
            x: root.columns.timeAt
            anchors.verticalCenter: parent.verticalCenter
            width: root.columns.time - 8
            text: root.time
            elide: Text.ElideRight
        }
        BodyText {
            x: root.columns.wayAt
            anchors.verticalCenter: parent.verticalCenter
            width: root.columns.way - 8
            text: root.way
            elide: Text.ElideRight
        }
        Row {
            x: root.columns.stateAt
            anchors.verticalCenter: parent.verticalCenter
            spacing: 7

            // A shape for each, not only a colour: full, ring, half as large.
            Rectangle {
                anchors.verticalCenter: parent.verticalCenter
                width: 9
                height: 9
                radius: root.fails ? 1 : 4.5
                rotation: root.fails ? 45 : 0
                color: root.planState === FarmList.Drivable ? Theme.accent : root.fails || root.planState === FarmList.OutOfDate ? root.stateColour : "transparent"
                border.width: color.a > 0 ? 0 : 1.4
                border.color: Theme.muted
            }
            BodyText {
                width: root.columns.state - 22
                text: root.stateText
                elide: Text.ElideRight
                color: root.stateColour
            }
        }
        MouseArea {
            anchors.fill: parent
            hoverEnabled: false
            onClicked: mouse => {
                const onMark = mouse.x < 30;
                root.picked(mouse.modifiers & Qt.ShiftModifier ? FarmList.UpTo : onMark || mouse.modifiers & Qt.ControlModifier ? FarmList.Toggle : FarmList.Only);
            }
            onDoubleClicked: root.opened()
        }
    }
}
