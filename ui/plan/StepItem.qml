pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls
import Furrow.Explain
import Furrow.Order
import Furrow.Project

/// One step of the plan: its number, what is chosen and what came of it; opens to its settings, or leads to the list
/// of what was found.
Rectangle {
    id: root

    required property int index
    required property string stepId
    required property int number
    required property string name
    required property string choice
    required property string result
    required property int status
    required property ParameterModel parameters
    required property Planning planning
    required property FieldOpener opener
    property bool open: false
    readonly property bool leadsOn: stepId === "check" || stepId === "export"
    /// The result is of a plan that does not belong to what the panels show.
    readonly property bool old: status === StepsModel.Old
    /// Only opening and closing are shown as a motion, not a line more or less in the header.
    property bool moving: false
    signal toggled()
    /// Opened, with all of its settings there.
    signal opened()
    /// This part of it needs more room.
    signal grown(part: Item)
    signal openRequested()
    signal drawRequested()
    signal checkRequested()
    signal exportRequested()
    signal swathChosen(segment: int)

    implicitHeight: header.height + (body.active ? body.height + 16 : 0)
    radius: Theme.cardRadius
    color: open ? Theme.sunken : "transparent"
    border.width: open ? Theme.hairline : 0
    border.color: Theme.line
    clip: true

    Behavior on implicitHeight {
        enabled: root.moving

        NumberAnimation { duration: Theme.motion; easing.type: Easing.OutCubic }
    }

    onOpenChanged: {
        moving = true;
        settled.restart();
    }

    Timer {
        id: settled

        interval: Theme.motion * 2
        onTriggered: {
            root.moving = false;
            if (root.open)
                root.opened();
        }
    }
    T.Button {
        id: header

        objectName: "step." + root.stepId
        width: parent.width
        height: lines.height + 20
        focusPolicy: Qt.StrongFocus
        Accessible.name: qsTr("%1. %2: %3. %4").arg(root.number).arg(root.name).arg(root.choice).arg(root.result)
        onClicked: root.stepId === "check" ? root.checkRequested() : root.stepId === "export" ? root.exportRequested() : root.toggled()

        background: Rectangle {
            radius: Theme.cardRadius
            color: header.hovered && !root.open ? Theme.hover : "transparent"

            Focusable { control: header; gap: -2 }
        }
        contentItem: Item {
            Rectangle {
                x: 10
                y: 11
                width: 24
                height: 24
                radius: 12
                color: Theme.softAccent
                border.width: Theme.sunlight ? 1 : 0
                border.color: Theme.accent

                BodyText {
                    anchors.centerIn: parent
                    text: root.number
                    color: Theme.accent
                    font.pixelSize: 12
                    font.weight: Font.DemiBold
                }
            }
            Column {
                id: lines

                anchors { left: parent.left; right: dot.left; leftMargin: 44; rightMargin: 10 }
                y: 9
                spacing: 2

                BodyText {
                    text: root.name
                    font.pixelSize: 14
                    font.weight: Font.DemiBold
                }
                BodyText {
                    width: parent.width
                    text: root.choice
                    elide: Text.ElideRight
                }
                Caption {
                    width: parent.width
                    visible: text.length > 0
                    text: root.result
                    elide: Text.ElideRight
                    opacity: root.old ? 0.6 : 1
                }
            }
            Rectangle {
                id: dot

                anchors { right: parent.right; rightMargin: 12 }
                y: 15
                width: 8
                height: 8
                radius: root.status === StepsModel.Warning ? 1 : 4
                rotation: root.status === StepsModel.Warning ? 45 : 0
                visible: root.status !== StepsModel.None
                color: root.old ? "transparent" : root.status === StepsModel.Good ? Theme.accent : root.status === StepsModel.Warning ? Theme.warning : Theme.failure
                border.width: root.old ? 1.5 : 0
                border.color: Theme.muted
            }
        }
    }
    Loader {
        id: body

        active: root.open
        x: 12
        y: header.height + 4
        width: parent.width - 24
        sourceComponent: content
    }
    Component {
        id: content

        Column {
            spacing: 12

            BodyText {
                objectName: "reason." + root.stepId
                width: parent.width
                visible: text.length > 0
                text: root.planning.reasons.texts[root.stepId] ?? ""
                wrapMode: Text.WordWrap
                lineHeight: 1.15
                // Of the plan before, while the next one is made; of another method nothing.
                opacity: root.planning.reasons.changedSteps.includes(root.stepId) ? 0 : root.old ? 0.6 : 1
                Accessible.ignored: opacity === 0
            }
            Loader {
                width: parent.width
                active: root.stepId === "swaths" && root.planning.reasons.headings.available
                visible: active
                sourceComponent: HeadingChart {
                    headings: root.planning.reasons.headings
                }
            }
            FieldActions {
                width: parent.width
                visible: root.stepId === "field"
                opener: root.opener
                onOpenRequested: root.openRequested()
                onDrawRequested: root.drawRequested()
            }
            MachineFields {
                width: parent.width
                visible: root.stepId === "machine"
                machine: root.planning.machine
            }
            Loader {
                width: parent.width
                active: root.stepId === "decomposition" && root.planning.cells.count > 0
                visible: active
                sourceComponent: CellStepper {
                    cells: root.planning.cells
                }
            }
            Loader {
                width: parent.width
                active: root.stepId === "route"
                visible: active
                sourceComponent: OrderEditor {
                    id: order

                    order: root.planning.order
                    onGrown: root.grown(order)
                    onSwathChosen: segment => root.swathChosen(segment)
                }
            }
            ParameterList {
                width: parent.width
                visible: root.stepId !== "machine"
                parameters: root.parameters
            }
        }
    }
}
