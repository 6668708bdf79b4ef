import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// A finding with its number on the map; pressing it goes there.
T.Button {
    id: root

    required property int number
    required property string finding
    required property string suggestion
    required property int weight
    /// The first of those that are just so.
    required property bool beginsInformation
    readonly property bool blocking: weight === FindingsModel.Blocks
    /// What corrects it, where that is one setting: "Passes: 3".
    required property string change
    /// Where the row stands for several of a kind: which of them it shows, from 1.
    required property int placeInKind
    required property int kindCount
    property bool current: false
    signal applied()
    signal stepped(by: int)

    implicitHeight: heading.height + lines.height + 20
    topInset: heading.height
    focusPolicy: Qt.StrongFocus
    Accessible.name: qsTr("Finding %1: %2 %3").arg(number).arg(finding).arg(suggestion)
    Accessible.description: kindCount > 1 ? qsTr("%1 of %2 of this kind").arg(placeInKind).arg(kindCount) : ""
    Keys.onLeftPressed: event => root.stepWith(event, -1)
    Keys.onRightPressed: event => root.stepWith(event, 1)

    background: Rectangle {
        radius: Theme.radius
        color: root.blocking ? Theme.warningGround : root.hovered ? Theme.hover : Theme.sunken
        border.width: root.current ? 2 : Theme.sunlight ? 1 : 0
        border.color: root.current ? Theme.finding : Theme.line

        Rectangle {
            width: 3
            height: parent.height
            color: root.blocking ? Theme.warning : Theme.line
        }
        Focusable { control: root }
    }
    contentItem: Item {
        Caption {
            id: heading

            width: parent.width
            height: root.beginsInformation ? implicitHeight + 6 : 0
            visible: root.beginsInformation
            topPadding: 10
            text: qsTr("For information")
        }
        Rectangle {
            id: mark

            // As on the map: full what blocks, an outline what wants a look, round what is just so.
            x: 14
            y: heading.height + 13
            width: 15
            height: 15
            rotation: root.weight === FindingsModel.Information ? 0 : 45
            radius: root.weight === FindingsModel.Information ? 7.5 : 0
            color: root.blocking ? Theme.finding : Theme.panel
            border { width: root.blocking ? 0 : 1.4; color: Theme.finding }
        }
        BodyText {
            anchors.fill: mark
            text: root.number
            color: root.blocking ? Theme.panel : Theme.finding
            font.pixelSize: 10
            font.weight: Font.DemiBold
            horizontalAlignment: Text.AlignHCenter
            verticalAlignment: Text.AlignVCenter
        }
        Column {
            id: lines

            anchors { left: parent.left; right: parent.right; leftMargin: 42; rightMargin: 10 }
            y: heading.height + 10
            spacing: 3

            BodyText {
                width: parent.width
                text: root.finding
                wrapMode: Text.WordWrap
                font.pixelSize: 13
                lineHeight: 1.15
            }
            Caption {
                width: parent.width
                visible: text.length > 0
                text: root.suggestion
                wrapMode: Text.WordWrap
                lineHeight: 1.15
                color: Theme.sunlight ? Theme.ink : Theme.muted
            }
            Row {
                visible: root.kindCount > 1
                x: -8
                height: visible ? Theme.controlHeight : 0

                ToolIconButton {
                    objectName: root.objectName + ".previous"
                    height: Theme.controlHeight
                    width: Theme.controlHeight
                    iconName: "chevron-left"
                    hint: qsTr("The one before, of this kind (Ctrl+Shift+F8)")
                    hintBelow: true
                    onClicked: root.stepped(-1)
                }
                BodyText {
                    objectName: root.objectName + ".place"
                    height: Theme.controlHeight
                    verticalAlignment: Text.AlignVCenter
                    text: qsTr("%1 of %2 of this kind").arg(root.placeInKind).arg(root.kindCount)
                    color: Theme.sunlight ? Theme.ink : Theme.muted
                }
                ToolIconButton {
                    objectName: root.objectName + ".next"
                    height: Theme.controlHeight
                    width: Theme.controlHeight
                    iconName: "chevron-right"
                    hint: qsTr("The next of this kind (Ctrl+F8)")
                    hintBelow: true
                    onClicked: root.stepped(1)
                }
            }
            SmallButton {
                objectName: root.objectName + ".apply"
                x: -6
                visible: root.change.length > 0
                height: visible ? 28 : 0
                text: qsTr("Apply: %1").arg(root.change)
                onClicked: root.applied()
            }
        }
    }

    function stepWith(event: var, by: int): void {
        event.accepted = root.kindCount > 1;
        if (event.accepted)
            root.stepped(by);
    }
}
