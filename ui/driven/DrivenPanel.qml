pragma ComponentBehavior: Bound
import QtQuick
import QtPositioning
import Furrow.Controls

/// A recorded track beside the plan: figures, colours, and the error along the way.
SidePanel {
    id: root

    required property DrivenTrack track
    /// Of the steps on the map.
    required property list<color> colors
    signal openRequested()
    /// The track belongs to no plan: a field is to be made from it.
    signal fieldRequested()
    signal placeRequested(place: geoCoordinate)

    title: qsTr("Planned and driven")
    closeName: "driven.close"

    BodyText {
        width: parent.width
        text: root.track.name
        color: Theme.muted
        elide: Text.ElideMiddle
    }
    ProgressLine {
        width: parent.width
        visible: root.track.busy
        value: root.track.progress
    }
    Column {
        width: parent.width
        spacing: 4
        visible: trouble.text.length > 0

        BodyText {
            id: trouble

            objectName: "driven.trouble"
            width: parent.width
            text: root.track.trouble
            color: Theme.failure
            wrapMode: Text.WordWrap
        }
        BodyText {
            width: parent.width
            text: root.track.remedy
            wrapMode: Text.WordWrap
        }
        PushButton {
            objectName: "driven.makeField"
            visible: root.track.readable
            text: qsTr("Make a field from it")
            onClicked: root.fieldRequested()
        }
    }
    ErrorCourse {
        objectName: "driven.course"
        width: parent.width
        visible: root.track.ready
        course: root.track.course
        upper: root.track.courseTop
        onPlaceChosen: share => root.placeRequested(root.track.placeAt(share))
    }
    SmallButton {
        x: -6
        objectName: "driven.farthest"
        visible: root.track.ready
        text: qsTr("Go to the farthest place")
        onClicked: root.placeRequested(root.track.farthest())
    }
    Column {
        width: parent.width
        visible: root.track.ready

        Repeater {
            model: root.track.figures

            Item {
                id: figure

                required property var modelData
                required property int index

                objectName: "driven.figure." + index
                width: root.bodyWidth
                height: texts.implicitHeight + 12
                Accessible.role: Accessible.Row
                Accessible.name: qsTr("%1: %2").arg(modelData.label).arg(modelData.value)

                Rectangle {
                    width: parent.width
                    height: Theme.hairline
                    color: Theme.line
                }
                Column {
                    id: texts

                    y: 6
                    width: parent.width

                    Item {
                        width: parent.width
                        height: Math.max(label.implicitHeight, value.implicitHeight)

                        BodyText {
                            id: label

                            width: parent.width - value.implicitWidth - 8
                            text: figure.modelData.label
                            color: Theme.muted
                            wrapMode: Text.WordWrap
                        }
                        BodyText {
                            id: value

                            anchors.right: parent.right
                            text: figure.modelData.value
                            font.weight: Font.Medium
                        }
                    }
                    Caption {
                        width: parent.width
                        visible: text.length > 0
                        text: figure.modelData.hint
                        wrapMode: Text.WordWrap
                    }
                }
            }
        }
    }
    Column {
        width: parent.width
        visible: root.track.ready
        spacing: 4

        BodyText {
            text: qsTr("Distance from the plan")
            font.pixelSize: Theme.titleSize
            font.weight: Font.DemiBold
            bottomPadding: 2
        }
        Repeater {
            model: root.track.steps

            Item {
                id: step

                required property string modelData
                required property int index

                width: root.bodyWidth
                height: 22

                Rectangle {
                    anchors.verticalCenter: parent.verticalCenter
                    width: 28
                    height: 2 + step.index % 4 * 1.4
                    radius: height / 2
                    color: root.colors[step.index]
                }
                BodyText {
                    x: 40
                    anchors.verticalCenter: parent.verticalCenter
                    text: step.modelData
                }
            }
        }
    }
    Repeater {
        model: root.track.notes

        Caption {
            required property string modelData

            width: root.bodyWidth
            text: modelData
            wrapMode: Text.WordWrap
        }
    }
    PushButton {
        objectName: "driven.open"
        text: qsTr("Another track…")
        onClicked: root.openRequested()
    }
}
