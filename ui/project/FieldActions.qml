import QtQuick
import Furrow.Controls

/// Where a field comes from.
Column {
    id: root

    required property FieldOpener opener
    signal openRequested()
    signal drawRequested()

    spacing: 12

    Row {
        width: parent.width
        spacing: 12

        PushButton {
            objectName: "field.open"
            width: (parent.width - 12) / 2
            text: qsTr("Open file…")
            onClicked: root.openRequested()
        }
        PushButton {
            objectName: "field.draw"
            width: (parent.width - 12) / 2
            text: qsTr("Draw")
            onClicked: root.drawRequested()
        }
    }
    Column {
        width: parent.width
        spacing: 5
        visible: root.opener.sampleNames.length > 0

        Caption { text: qsTr("Sample field") }
        ChoiceField {
            objectName: "field.sample"
            width: parent.width
            name: qsTr("Sample field")
            model: root.opener.sampleNames
            chosen: -1
            displayText: qsTr("Add one to look at")
            onActivated: index => root.opener.openSample(index)
        }
    }
}
