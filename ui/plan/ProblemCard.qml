import QtQuick
import Furrow.Controls
import Furrow.Project

/// What went wrong, where the trouble is and what helps.
Rectangle {
    id: root

    required property Problem problem
    required property Planning planning
    required property bool hasField
    /// Where there is no plan, the card says why.
    readonly property bool closable: planning.state !== PlanState.Failed
    signal placeRequested()
    signal openRequested()

    objectName: "problemCard"
    visible: problem.text.length > 0 && planning.state !== PlanState.Planning && planning.state !== PlanState.Reading && planning.state !== PlanState.Choosing
    width: 344
    height: column.height + 32
    radius: Theme.cardRadius
    color: Theme.panel
    border.width: Theme.hairline
    border.color: Theme.failure
    Accessible.role: Accessible.AlertMessage
    Accessible.name: root.problem.text

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
                text: root.problem.text
                font.weight: Font.DemiBold
                wrapMode: Text.WordWrap
                lineHeight: 1.15
            }
        }
        Caption {
            width: parent.width
            visible: text.length > 0
            text: root.problem.where
            wrapMode: Text.Wrap
        }
        BodyText {
            objectName: "problemRemedy"
            width: parent.width
            visible: text.length > 0
            text: root.problem.remedy
            wrapMode: Text.WordWrap
            lineHeight: 1.15
        }
        Row {
            visible: root.problem.place.isValid || root.closable || !root.hasField
            topPadding: 4
            spacing: 8

            PushButton {
                objectName: "problemPlaceButton"
                visible: root.problem.place.isValid
                text: qsTr("Show the place")
                onClicked: root.placeRequested()
            }
            PushButton {
                objectName: "problemCloseButton"
                visible: root.closable
                text: qsTr("Close")
                onClicked: root.problem.dismiss()
            }
            PushButton {
                visible: !root.hasField
                text: qsTr("Open another file…")
                onClicked: root.openRequested()
            }
        }
    }
}
