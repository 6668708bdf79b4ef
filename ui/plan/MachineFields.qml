pragma ComponentBehavior: Bound
import QtQuick
import Furrow.Controls

/// The machine: one of the library and the numbers that decide a plan.
Column {
    id: root

    required property MachineModel machine

    spacing: 12

    Column {
        width: parent.width
        spacing: 5

        Item {
            width: parent.width
            height: 16

            Caption {
                anchors.verticalCenter: parent.verticalCenter
                text: qsTr("Machine")
            }
            SmallButton {
                objectName: "machine.reset"
                anchors { right: parent.right; rightMargin: -6; verticalCenter: parent.verticalCenter }
                visible: root.machine.changed
                text: qsTr("Back to the original")
                onClicked: root.machine.reset()
            }
        }
        ChoiceField {
            objectName: "machine.library"
            width: parent.width
            name: qsTr("Machine")
            model: root.machine.library
            chosen: root.machine.libraryIndex
            displayText: currentIndex < 0 ? root.machine.name : currentText
            onActivated: index => root.machine.libraryIndex = index
        }
        Row {
            x: -6
            spacing: 4
            visible: root.machine.changed || root.machine.own || root.machine.libraryIndex < 0

            SmallButton {
                objectName: "machine.keep"
                visible: root.machine.changed || root.machine.libraryIndex < 0
                height: 34
                text: qsTr("Keep as your own…")
                onClicked: root.machine.askForName()
            }
            SmallButton {
                objectName: "machine.forget"
                visible: root.machine.own
                height: 34
                text: qsTr("Remove from your own")
                onClicked: root.machine.forget()
            }
        }
    }
    Flow {
        width: parent.width
        spacing: 12

        Repeater {
            model: root.machine

            Column {
                id: entry

                required property int index
                required property string key
                required property string name
                required property real value
                required property string autoText
                required property int quantity
                required property real from
                required property real to
                required property real step
                required property int decimals

                width: (root.width - 12) / 2
                spacing: 5

                Caption {
                    width: parent.width
                    text: entry.name
                    elide: Text.ElideRight
                }
                NumberField {
                    objectName: "machine." + entry.key
                    width: parent.width
                    name: entry.name
                    value: entry.value
                    autoText: entry.autoText
                    kind: entry.quantity
                    from: entry.from
                    to: entry.to
                    step: entry.step
                    decimals: entry.decimals
                    onCommitted: newValue => root.machine.setNumber(entry.index, newValue)
                }
            }
        }
    }
    NoticeBar {
        width: parent.width
        visible: text.length > 0
        text: root.machine.problem
    }
}
