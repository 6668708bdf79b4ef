import QtQuick
import Furrow.Controls

/// Which of two plans a map shows, with a sample of the line that its differences are drawn in.
Rectangle {
    id: root

    required property string name
    required property color lineColor
    property bool dashed: false

    width: Math.min(parent.width - 24, row.implicitWidth + 24)
    height: 30
    radius: 15
    color: Theme.panel
    border.width: Theme.hairline
    border.color: Theme.line
    Accessible.role: Accessible.StaticText
    Accessible.name: root.name

    SoftShadow { radius: root.radius }
    Row {
        id: row

        anchors { left: parent.left; leftMargin: 12; verticalCenter: parent.verticalCenter }
        spacing: 8

        Row {
            id: sample

            anchors.verticalCenter: parent.verticalCenter
            spacing: root.dashed ? 4 : 0

            Repeater {
                model: root.dashed ? 2 : 1

                Rectangle {
                    width: root.dashed ? 8 : 20
                    height: 3
                    color: root.lineColor
                }
            }
        }
        BodyText {
            anchors.verticalCenter: parent.verticalCenter
            width: Math.min(implicitWidth, root.parent.width - 24 - 24 - 28)
            text: root.name
            font.weight: Font.Medium
            elide: Text.ElideRight
        }
    }
}
