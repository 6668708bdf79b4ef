pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls
import Furrow.Plan

/// The steps from field to turns, one of them open.
Rectangle {
    id: root

    required property PlanSession session
    property string openStep: "field"
    signal openRequested()
    signal drawRequested()

    objectName: "stepsPanel"
    color: Theme.panel

    Flickable {
        id: flick

        anchors.fill: parent
        contentHeight: column.height + 24
        boundsBehavior: Flickable.StopAtBounds
        clip: true

        T.ScrollBar.vertical: T.ScrollBar {
            id: bar

            width: 8
            padding: 2
            contentItem: Rectangle {
                radius: 2
                color: Theme.line
                visible: bar.size < 1
            }
        }

        Column {
            id: column

            x: 12
            y: 12
            width: flick.width - 24
            spacing: 2

            Repeater {
                model: root.session.steps

                StepItem {
                    width: column.width
                    session: root.session
                    open: root.openStep === stepId
                    onToggled: root.openStep = open ? "" : stepId
                    onOpenRequested: root.openRequested()
                    onDrawRequested: root.drawRequested()
                }
            }
        }
    }
    Rectangle {
        anchors { top: parent.top; bottom: parent.bottom; right: parent.right }
        width: Theme.hairline
        color: Theme.line
    }
}
