import QtQuick
import Furrow.Controls

/// State of the plan, how long it took and the one figure that matters; progress while it takes long. Problems lead to
/// their list.
Rectangle {
    id: root

    required property Planning planning
    readonly property int planState: planning.state
    readonly property bool working: planState === PlanState.Planning || planState === PlanState.Reading
    readonly property bool slow: working && planning.slow
    readonly property bool failed: planState === PlanState.Failed
    readonly property bool warned: planState === PlanState.OutOfDate || planState === PlanState.Problems
    signal checkRequested()

    objectName: "statusChip"
    visible: planState !== PlanState.Empty && planState !== PlanState.Choosing && text.text.length > 0
    width: row.width + 28
    height: 34
    radius: 17
    color: warned ? Theme.warningGround : Theme.panel
    border.width: Theme.hairline
    border.color: warned ? Theme.warning : Theme.line
    Accessible.role: Accessible.StaticText
    Accessible.name: text.text

    SoftShadow { radius: root.radius }
    Row {
        id: row

        anchors { left: parent.left; leftMargin: 14; verticalCenter: parent.verticalCenter }
        spacing: 10

        Rectangle {
            anchors.verticalCenter: parent.verticalCenter
            width: 9
            height: 9
            radius: root.failed || root.warned ? 1.5 : 4.5
            rotation: root.warned ? 45 : 0
            color: root.failed ? Theme.failure : root.working ? Theme.muted : root.warned ? Theme.warning : Theme.accent
        }
        BodyText {
            id: text

            objectName: "statusText"
            anchors.verticalCenter: parent.verticalCenter
            text: root.planning.statusText
        }
        Rectangle {
            anchors.verticalCenter: parent.verticalCenter
            visible: root.slow
            width: 90
            height: 5
            radius: 2.5
            color: Theme.line

            Rectangle {
                width: Math.max(5, parent.width * root.planning.progress)
                height: 5
                radius: 2.5
                color: Theme.accent
            }
        }
        SmallButton {
            objectName: "cancelButton"
            anchors.verticalCenter: parent.verticalCenter
            visible: root.slow
            text: qsTr("Stop")
            onClicked: root.planning.cancel()
        }
        SmallButton {
            objectName: "planAgainButton"
            anchors.verticalCenter: parent.verticalCenter
            visible: root.planState === PlanState.OutOfDate
            text: qsTr("Plan again")
            onClicked: root.planning.planAgain()
        }
        SmallButton {
            objectName: "showProblemsButton"
            anchors.verticalCenter: parent.verticalCenter
            visible: root.planState === PlanState.Problems
            text: qsTr("Show")
            Accessible.name: qsTr("Show the problems")
            onClicked: root.checkRequested()
        }
    }
}
