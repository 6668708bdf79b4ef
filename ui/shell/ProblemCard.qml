import QtQuick
import Furrow.Controls
import Furrow.Plan

/// What went wrong, where the trouble is and what helps.
Rectangle {
    id: root

    required property PlanSession session
    signal placeRequested()
    signal openRequested()

    objectName: "problemCard"
    visible: session.problem.length > 0 && session.state !== PlanState.Planning && session.state !== PlanState.Reading && session.state !== PlanState.Choosing
    width: 344
    height: column.height + 32
    radius: Theme.cardRadius
    color: Theme.panel
    border.width: Theme.hairline
    border.color: Theme.failure
    Accessible.role: Accessible.AlertMessage
    Accessible.name: root.session.problem

    SoftShadow { radius: root.radius }
    Column {
        id: column

        x: 16
        y: 16
        width: parent.width - 32
        spacing: 8

        Row {
            width: parent.width
            spacing: 10

            Icon {
                name: "warning"
                color: Theme.failure
            }
            BodyText {
                objectName: "problemText"
                width: parent.width - 30
                text: root.session.problem
                font.weight: Font.DemiBold
                wrapMode: Text.WordWrap
                lineHeight: 1.15
            }
        }
        Caption {
            width: parent.width
            visible: text.length > 0
            text: root.session.problemWhere
            wrapMode: Text.Wrap
        }
        BodyText {
            width: parent.width
            visible: text.length > 0
            text: root.session.problemRemedy
            wrapMode: Text.WordWrap
            lineHeight: 1.15
        }
        Row {
            topPadding: 4
            spacing: 8

            PushButton {
                objectName: "problemPlaceButton"
                visible: root.session.problemPlace.isValid
                text: qsTr("Show the place")
                onClicked: root.placeRequested()
            }
            PushButton {
                objectName: "problemCloseButton"
                // Where there is no plan, the card says why.
                visible: root.session.state !== PlanState.Failed
                text: qsTr("Close")
                onClicked: root.session.dismissProblem()
            }
            PushButton {
                visible: !root.session.hasField
                text: qsTr("Open another file…")
                onClicked: root.openRequested()
            }
        }
    }
}
