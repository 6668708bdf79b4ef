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

    objectName: "stepsPanel"
    color: Theme.panel

    ScrollArea {
        id: flick

        anchors.fill: parent
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
                    width: column.width
                    planning: root.planning
                    opener: root.opener
                    open: !leadsOn && root.openStep === stepId
                    onToggled: root.openStep = open ? "" : stepId
                    onOpenRequested: root.openRequested()
                    onDrawRequested: root.drawRequested()
                    onCheckRequested: root.checkRequested()
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
