pragma ComponentBehavior: Bound
import QtQuick
import Furrow.Controls
import Furrow.Text

/// The field that would be made from a recorded track: how the track was driven, what comes out, and taking it.
SidePanel {
    id: root

    required property FieldFromTrack source
    readonly property bool ready: source.ready
    /// It was offered to take the field: Return does it.
    property bool offered: false

    title: qsTr("Field from a track")
    closeName: "fromTrack.close"
    onVisibleChanged: root.offered = false
    onReadyChanged: {
        if (root.ready && root.visible && !root.offered) {
            root.offered = true;
            take.forceActiveFocus(Qt.TabFocusReason);
        }
    }

    component Labelled: Column {
        required property string label

        width: root.bodyWidth
        spacing: 5

        Caption { text: parent.label }
    }

    Column {
        width: parent.width
        spacing: 3

        BodyText {
            width: parent.width
            text: root.source.name
            elide: Text.ElideMiddle
            font.weight: Font.Medium
        }
        Caption {
            objectName: "fromTrack.recording"
            width: parent.width
            text: root.source.recording
            wrapMode: Text.WordWrap
        }
    }
    ProgressLine {
        width: parent.width
        visible: root.source.busy
        value: root.source.progress
    }
    Labelled {
        label: qsTr("How it was driven")

        ChoiceField {
            objectName: "fromTrack.kind"
            width: parent.width
            name: qsTr("How it was driven")
            model: root.source.kinds
            chosen: root.source.kind
            onActivated: index => root.source.kind = index
        }
    }
    Labelled {
        label: qsTr("Operating width")

        NumberField {
            objectName: "fromTrack.width"
            width: parent.width
            name: qsTr("Operating width")
            kind: QuantityText.Length
            from: 0.1
            to: 100
            step: 0.1
            decimals: 2
            value: root.source.width
            onCommitted: entered => root.source.width = entered
        }
    }
    Labelled {
        visible: root.source.round
        label: qsTr("The edge lies outside of the line by")

        NumberField {
            objectName: "fromTrack.beyond"
            width: parent.width
            name: qsTr("The edge lies outside of the line by")
            kind: QuantityText.Length
            from: -50
            to: 50
            step: 0.5
            decimals: 2
            value: root.source.beyond
            onCommitted: entered => root.source.beyond = entered
        }
        SmallButton {
            x: -6
            objectName: "fromTrack.half"
            height: 34
            text: root.source.beyond === 0 ? qsTr("Half a width: the implement ran along the edge") : qsTr("None: the line is the edge")
            onClicked: root.source.beyond = root.source.beyond === 0 ? root.source.width / 2 : 0
        }
    }
    Labelled {
        visible: !root.source.round
        label: qsTr("Gaps between strips are closed up to")

        NumberField {
            objectName: "fromTrack.gap"
            width: parent.width
            name: qsTr("Gaps between strips are closed up to")
            kind: QuantityText.Length
            from: 0
            to: 100
            step: 0.5
            decimals: 2
            value: root.source.gap
            onCommitted: entered => root.source.gap = entered
        }
    }
    Column {
        width: parent.width
        spacing: 4
        visible: trouble.text.length > 0 && !root.source.busy

        BodyText {
            id: trouble

            objectName: "fromTrack.trouble"
            width: parent.width
            text: root.source.trouble
            color: Theme.failure
            wrapMode: Text.WordWrap
            Accessible.role: Accessible.AlertMessage
            Accessible.name: text
        }
        BodyText {
            width: parent.width
            text: root.source.remedy
            wrapMode: Text.WordWrap
        }
    }
    Column {
        width: parent.width
        visible: root.source.figures.length > 0

        Repeater {
            model: root.source.figures

            Item {
                id: figure

                required property var modelData
                required property int index

                objectName: "fromTrack.figure." + index
                width: root.bodyWidth
                height: 29
                Accessible.role: Accessible.StaticText
                Accessible.name: qsTr("%1: %2").arg(modelData.label).arg(modelData.value)

                BodyText {
                    anchors.verticalCenter: parent.verticalCenter
                    text: figure.modelData.label
                    color: Theme.muted
                }
                BodyText {
                    anchors { right: parent.right; verticalCenter: parent.verticalCenter }
                    text: figure.modelData.value
                    font.weight: Font.Medium
                }
                Rectangle {
                    anchors.bottom: parent.bottom
                    width: parent.width
                    height: Theme.hairline
                    color: Theme.line
                }
            }
        }
    }
    Repeater {
        model: root.source.notes

        Caption {
            required property string modelData

            width: root.bodyWidth
            text: modelData
            wrapMode: Text.WordWrap
        }
    }
    Row {
        spacing: 8
        topPadding: 4

        PushButton {
            id: take

            objectName: "fromTrack.take"
            primary: true
            enabled: root.source.ready
            text: qsTr("Make the field")
            onClicked: root.source.take()
        }
        PushButton {
            objectName: "fromTrack.cancel"
            text: qsTr("Cancel")
            onClicked: root.closeRequested()
        }
    }
}
