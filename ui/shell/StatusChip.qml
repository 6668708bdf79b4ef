import QtQuick
import Furrow.Controls
import Furrow.Plan

/// State of the plan, how long it took and the one figure that matters; progress while it takes long.
Rectangle {
    id: root

    required property PlanSession session
    readonly property bool working: session.state === PlanSession.Planning || session.state === PlanSession.Reading
    readonly property bool slow: working && session.slow

    objectName: "statusChip"
    visible: session.state !== PlanSession.Empty && session.state !== PlanSession.Choosing && text.text.length > 0
    width: row.width + 28
    height: 34
    radius: 17
    color: Theme.panel
    border.width: Theme.hairline
    border.color: Theme.line
    Accessible.role: Accessible.StaticText
    Accessible.name: text.text

    SoftShadow { radius: root.radius }
    Row {
        id: row

        anchors { left: parent.left; leftMargin: 14; verticalCenter: parent.verticalCenter }
        spacing: 10

        Rectangle {
            readonly property bool warned: root.session.state === PlanSession.Stopped || root.session.findings.blockingCount > 0

            anchors.verticalCenter: parent.verticalCenter
            width: 9
            height: 9
            radius: root.session.state === PlanSession.Failed || warned ? 1.5 : 4.5
            rotation: warned ? 45 : 0
            color: root.session.state === PlanSession.Failed ? Theme.failure : root.working ? Theme.muted : warned ? Theme.warning : Theme.accent
        }
        BodyText {
            id: text

            objectName: "statusText"
            anchors.verticalCenter: parent.verticalCenter
            text: root.session.statusText
        }
        Rectangle {
            anchors.verticalCenter: parent.verticalCenter
            visible: root.slow
            width: 90
            height: 5
            radius: 2.5
            color: Theme.line

            Rectangle {
                width: Math.max(5, parent.width * root.session.progress)
                height: 5
                radius: 2.5
                color: Theme.accent

                Behavior on width {
                    NumberAnimation { duration: 80 }
                }
            }
        }
        SmallButton {
            objectName: "cancelButton"
            anchors.verticalCenter: parent.verticalCenter
            visible: root.slow
            text: qsTr("Stop")
            onClicked: root.session.cancel()
        }
        SmallButton {
            objectName: "planAgainButton"
            anchors.verticalCenter: parent.verticalCenter
            visible: root.session.state === PlanSession.Stopped
            text: qsTr("Plan again")
            onClicked: root.session.planAgain()
        }
    }
}
