pragma ComponentBehavior: Bound
import QtQuick
import Furrow.Controls
import Furrow.Project

/// The steps from field to check, one of them open.
Rectangle {
    id: root

    required property Planning planning
    required property FieldOpener opener
    property string openStep: "field"
    signal openRequested()
    signal drawRequested()
    signal checkRequested()
    signal bestPlanRequested()
    signal swathChosen(segment: int)

    objectName: "stepsPanel"
    color: Theme.panel

    ScrollArea {
        id: flick

        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: foot.top }
        contentHeight: column.height + 24

        Column {
            id: column

            x: 12
            y: 12
            width: flick.width - 24
            spacing: 2

            Repeater {
                model: root.planning.steps

                StepItem {
                    id: step

                    width: column.width
                    planning: root.planning
                    opener: root.opener
                    open: !leadsOn && root.openStep === stepId
                    onToggled: root.openStep = open ? "" : stepId
                    onOpened: flick.bringIntoView(step)
                    onGrown: part => Qt.callLater(flick.bringIntoView, part)
                    onOpenRequested: root.openRequested()
                    onDrawRequested: root.drawRequested()
                    onCheckRequested: root.checkRequested()
                    onSwathChosen: segment => root.swathChosen(segment)
                }
            }
        }
    }
    Rectangle {
        id: foot

        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        height: visible ? best.height + 20 : 0
        visible: root.planning.state !== PlanState.Empty && root.planning.state !== PlanState.Choosing
        color: Theme.panel

        Rectangle {
            width: parent.width
            height: Theme.hairline
            color: Theme.line
        }
        PushButton {
            id: best

            objectName: "steps.bestPlan"
            anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter; margins: 12 }
            text: qsTr("Find the best plan…")
            onClicked: root.bestPlanRequested()
        }
    }
    Rectangle {
        anchors { top: parent.top; bottom: parent.bottom; right: parent.right }
        width: Theme.hairline
        color: Theme.line
    }
}
