pragma ComponentBehavior: Bound
import QtQuick
import Furrow.Controls

/// The table of the choices: what was taken with a tick, then the alternatives with what they would cost.
Column {
    id: root

    required property ChoiceTableModel table

    spacing: 2

    Repeater {
        model: root.table

        Item {
            id: row

            required property string choice
            required property string said
            required property string worth
            required property bool taken
            required property double share

            width: root.width
            height: Math.max(30, words.implicitHeight + 10)
            Accessible.role: Accessible.ListItem
            Accessible.name: qsTr("%1, %2: %3").arg(choice).arg(said).arg(worth)

            Rectangle {
                anchors { fill: parent; leftMargin: -6; rightMargin: -6 }
                radius: 6
                visible: row.taken
                color: Theme.softAccent
                border.width: Theme.sunlight ? 2 : 0
                border.color: Theme.accent
            }
            Icon {
                id: tick

                anchors.verticalCenter: parent.verticalCenter
                width: 16
                height: 16
                visible: row.taken
                name: "check"
                color: Theme.accent
            }
            BodyText {
                id: words

                anchors { left: parent.left; leftMargin: 24; right: bar.left; rightMargin: 10; verticalCenter: parent.verticalCenter }
                text: row.said
                wrapMode: Text.WordWrap
                font.weight: row.taken ? Font.DemiBold : Font.Normal
            }
            Item {
                id: bar

                anchors { right: value.left; rightMargin: 10; verticalCenter: parent.verticalCenter }
                width: 70
                height: 6

                Rectangle {
                    visible: row.share > 0
                    width: Math.max(2, parent.width * row.share)
                    height: parent.height
                    radius: 3
                    color: row.taken ? Theme.accent : Theme.muted
                    opacity: row.taken ? 1 : 0.55
                }
            }
            BodyText {
                id: value

                anchors { right: parent.right; verticalCenter: parent.verticalCenter }
                width: 138
                horizontalAlignment: Text.AlignRight
                text: row.worth
                color: row.taken ? Theme.ink : Theme.muted
                elide: Text.ElideRight
            }
        }
    }
    Caption {
        width: parent.width
        visible: root.table.behind > 0
        topPadding: 6
        text: qsTr("%n other(s) are slower still, or cannot be driven.", "", root.table.behind)
        wrapMode: Text.WordWrap
    }
}
