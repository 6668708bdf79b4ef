pragma ComponentBehavior: Bound
import QtQuick
import Furrow.Controls

/// The plan on the map beside another one: all figures, the better one marked, and what was chosen otherwise.
SidePanel {
    id: root

    required property PlanComparison comparison
    /// The other plan is on the map, for as long as its button or key is held.
    readonly property bool holding: hold.pressed
    /// Each plan on a map of its own.
    property bool twoMaps: false
    signal variantRequested()
    signal twoMapsChosen(on: bool)

    title: qsTr("Compare")
    closeName: "compare.close"

    function begin(): void {
        choice.forceActiveFocus();
    }

    component Cell: BodyText {
        property bool better: false

        horizontalAlignment: Text.AlignRight
        wrapMode: Text.Wrap
        font.weight: better ? Font.Bold : Font.Normal
        color: better ? Theme.accent : Theme.ink
    }
    QtObject {
        id: columns

        readonly property real first: root.width * 0.31
        readonly property real value: (root.bodyWidth - first) / 2
    }
    Column {
        width: parent.width
        spacing: 5

        Caption {
            width: parent.width
            text: qsTr("%1 beside").arg(root.comparison.firstName)
            elide: Text.ElideRight
        }
        ChoiceField {
            id: choice

            objectName: "compare.choice"
            width: parent.width
            name: qsTr("The other plan")
            model: root.comparison.choices
            chosen: root.comparison.chosen
            onActivated: index => root.comparison.chosen = index
        }
    }
    CheckRow {
        objectName: "compare.twoMaps"
        width: parent.width
        leftPadding: 0
        text: qsTr("Two maps side by side (Ctrl+Shift+D)")
        checked: root.twoMaps
        onToggled: root.twoMapsChosen(checked)
    }
    PushButton {
        id: hold

        objectName: "compare.hold"
        width: parent.width
        visible: !root.twoMaps
        enabled: root.comparison.ready
        text: qsTr("Hold to see the other plan (key X)")
    }
    SmallButton {
        x: -6
        objectName: "compare.variant"
        text: qsTr("Keep this plan as a variant…")
        onClicked: root.variantRequested()
    }
    BodyText {
        objectName: "compare.trouble"
        width: parent.width
        visible: text.length > 0
        text: root.comparison.trouble
        color: Theme.failure
        wrapMode: Text.WordWrap
    }
    Column {
        width: parent.width
        spacing: 6
        visible: root.comparison.busy

        BodyText { text: qsTr("The other plan is being made …") }
        ProgressLine {
            width: parent.width
            value: root.comparison.progress
        }
    }
    Column {
        width: parent.width
        visible: root.comparison.ready
        spacing: 0

        Row {
            width: parent.width
            height: 26

            Item { width: columns.first; height: 1 }
            Caption {
                width: columns.value
                text: qsTr("This plan")
                horizontalAlignment: Text.AlignRight
                elide: Text.ElideRight
            }
            Caption {
                width: columns.value
                text: qsTr("The other")
                horizontalAlignment: Text.AlignRight
                elide: Text.ElideRight
            }
        }
        Repeater {
            model: root.comparison.figures

            Item {
                id: figure

                required property var modelData
                required property int index

                objectName: "compare.figure." + index
                width: root.bodyWidth
                height: Math.max(difference.visible ? 40 : 30, label.implicitHeight + 8)
                Accessible.role: Accessible.Row
                Accessible.name: qsTr("%1: %2, the other %3").arg(modelData.label).arg(modelData.first).arg(modelData.second)

                Rectangle {
                    width: parent.width
                    height: Theme.hairline
                    color: Theme.line
                }
                BodyText {
                    id: label

                    anchors.verticalCenter: parent.verticalCenter
                    width: columns.first - 6
                    text: figure.modelData.label
                    color: Theme.muted
                    wrapMode: Text.WordWrap
                }
                Cell {
                    anchors.verticalCenter: parent.verticalCenter
                    x: columns.first
                    width: columns.value
                    text: figure.modelData.better < 0 ? "✓ " + figure.modelData.first : figure.modelData.first
                    better: figure.modelData.better < 0
                }
                Cell {
                    anchors.verticalCenter: parent.verticalCenter
                    anchors.verticalCenterOffset: difference.visible ? -7 : 0
                    x: columns.first + columns.value
                    width: columns.value
                    text: figure.modelData.better > 0 ? "✓ " + figure.modelData.second : figure.modelData.second
                    better: figure.modelData.better > 0
                }
                Caption {
                    id: difference

                    anchors { right: parent.right; verticalCenter: parent.verticalCenter; verticalCenterOffset: 9 }
                    visible: text.length > 0
                    text: figure.modelData.difference
                }
            }
        }
    }
    Column {
        width: parent.width
        visible: root.comparison.ready
        spacing: 6

        BodyText {
            objectName: "compare.swaths"
            width: parent.width
            text: root.comparison.swathsText
            wrapMode: Text.WordWrap
        }
        Repeater {
            model: root.comparison.drivenTexts

            BodyText {
                required property string modelData
                required property int index

                objectName: "compare.driven." + index
                width: root.bodyWidth
                text: modelData
                wrapMode: Text.WordWrap
            }
        }
        Caption {
            objectName: "compare.legend"
            width: parent.width
            text: root.twoMaps ? qsTr("On the maps, swaths, headland passes and turns are coloured that the other plan has not: full lines in this plan, dashes in the other.") : qsTr("On the map, swaths, headland passes and turns: full lines only in this plan, dashes only in the other.")
            wrapMode: Text.WordWrap
        }
    }
    Column {
        width: parent.width
        visible: root.comparison.ready
        spacing: 8

        BodyText {
            text: qsTr("What was chosen otherwise")
            font.pixelSize: Theme.titleSize
            font.weight: Font.DemiBold
        }
        BodyText {
            visible: root.comparison.settings.length === 0
            text: qsTr("Machine and settings are the same.")
            color: Theme.muted
        }
        Repeater {
            model: root.comparison.settings

            Column {
                id: setting

                required property var modelData

                width: root.bodyWidth
                spacing: 1

                Caption {
                    width: parent.width
                    text: setting.modelData.label
                    wrapMode: Text.WordWrap
                }
                BodyText {
                    width: parent.width
                    text: qsTr("%1 → %2").arg(setting.modelData.first).arg(setting.modelData.second)
                    wrapMode: Text.Wrap
                    maximumLineCount: 4
                    elide: Text.ElideRight
                }
            }
        }
        PushButton {
            objectName: "compare.take"
            width: parent.width
            text: qsTr("Go on with the other plan")
            primary: true
            onClicked: root.comparison.takeSecond()
        }
    }
}
