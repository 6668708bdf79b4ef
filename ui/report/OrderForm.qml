pragma ComponentBehavior: Bound
import QtQuick
import Furrow.Controls

/// What a plan is handed out with: number, customer, operator, rate and so on.
Flow {
    id: root

    required property OrderModel order

    spacing: 12

    Column {
        width: (root.width - 12) / 2
        spacing: 5

        Caption { text: qsTr("Status") }
        ChoiceField {
            objectName: "order.status"
            width: parent.width
            name: qsTr("Status")
            model: root.order.statusNames
            chosen: root.order.status
            onActivated: index => root.order.status = index
        }
    }
    Repeater {
        model: root.order

        Column {
            id: line

            required property int index
            required property string key
            required property string name
            required property string text
            required property bool half

            width: half ? (root.width - 12) / 2 : root.width
            spacing: 5

            Caption {
                width: parent.width
                text: line.name
                elide: Text.ElideRight
            }
            TextEntry {
                objectName: "order." + line.key
                width: parent.width
                name: line.name
                value: line.text
                accepts: entered => root.order.accepts(line.index, entered)
                onCommitted: entered => root.order.setText(line.index, entered)
            }
        }
    }
}
