pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Shapes
import QtQuick.Templates as T
import Furrow.Controls

/// The time of every heading as a curve, or against what else it costs as points; one of them may be taken.
Column {
    id: root

    required property HeadingChoice headings
    readonly property var points: root.headings.points
    /// The point that is looked at; -1 for none.
    property int current: -1
    readonly property int shown: root.current >= 0 && root.current < root.points.length ? root.current : root.headings.chosen

    spacing: 6
    onPointsChanged: root.current = -1

    component Mark: Rectangle {
        required property int point
        readonly property bool isThere: point >= 0 && point < root.points.length

        visible: isThere
        x: isThere ? area.x + root.points[point].x * area.width - width / 2 : 0
        y: isThere ? area.y + (1 - root.points[point].y) * area.height - height / 2 : 0
        width: 11
        height: width
        radius: width / 2
        border.width: 2
        border.color: Theme.panel
    }
    component Scale: Caption {
        color: Theme.muted
        font.pixelSize: 11
    }

    Item {
        width: parent.width
        height: 20

        Caption {
            anchors { left: parent.left; verticalCenter: parent.verticalCenter }
            text: qsTr("Time by")
        }
        Row {
            anchors { right: parent.right; verticalCenter: parent.verticalCenter }
            spacing: 2

            Repeater {
                model: [
                    { across: HeadingChoice.Bearing, text: qsTr("direction"), name: "bearing" },
                    { across: HeadingChoice.Overlap, text: qsTr("overlap"), name: "overlap" },
                    { across: HeadingChoice.Missed, text: qsTr("missed"), name: "missed" },
                    { across: HeadingChoice.Turning, text: qsTr("turning"), name: "turning" }
                ]

                T.Button {
                    id: tab

                    required property var modelData
                    readonly property bool on: root.headings.across === modelData.across

                    objectName: "headings.across." + modelData.name
                    implicitWidth: label.implicitWidth + 12
                    implicitHeight: 22
                    focusPolicy: Qt.StrongFocus
                    // A finger needs more than the text.
                    containmentMask: Item {
                        y: (tab.height - height) / 2
                        width: tab.width
                        height: Theme.controlHeight
                    }
                    text: modelData.text
                    Accessible.name: qsTr("Time by %1").arg(modelData.text)
                    Accessible.checkable: true
                    Accessible.checked: on
                    onClicked: root.headings.across = modelData.across

                    background: Rectangle {
                        radius: 6
                        color: tab.on ? Theme.softAccent : tab.hovered ? Theme.hover : "transparent"
                        border.width: Theme.sunlight && tab.on ? 2 : 0
                        border.color: Theme.accent

                        Focusable { control: tab; gap: 0 }
                    }
                    contentItem: BodyText {
                        id: label

                        text: tab.text
                        font.pixelSize: 11
                        font.weight: tab.on ? Font.DemiBold : Font.Normal
                        color: tab.on ? Theme.accent : Theme.muted
                        horizontalAlignment: Text.AlignHCenter
                        verticalAlignment: Text.AlignVCenter
                    }
                }
            }
        }
    }
    T.Control {
        id: chart

        objectName: "headings.chart"
        width: parent.width
        height: 118
        focusPolicy: Qt.StrongFocus
        Accessible.role: Accessible.Chart
        Accessible.name: qsTr("Directions of swaths and their times")
        Accessible.description: root.headings.describe(root.shown)

        Keys.onLeftPressed: root.step(-1)
        Keys.onRightPressed: root.step(1)
        Keys.onReturnPressed: root.headings.take(root.shown)
        Keys.onEnterPressed: root.headings.take(root.shown)

        Rectangle {
            anchors.fill: parent
            radius: Theme.radius
            color: Theme.panel
            border.width: Theme.hairline
            border.color: Theme.line

            Focusable { control: chart }
        }
        Item {
            id: area

            anchors { fill: parent; leftMargin: 12; rightMargin: 12; topMargin: 26; bottomMargin: 26 }

            Shape {
                anchors.fill: parent
                visible: root.headings.across === HeadingChoice.Bearing
                preferredRendererType: Shape.CurveRenderer

                ShapePath {
                    strokeColor: Theme.muted
                    strokeWidth: Theme.sunlight ? 2 : 1.5
                    fillColor: "transparent"
                    joinStyle: ShapePath.RoundJoin

                    PathPolyline {
                        path: root.points.map(point => Qt.point(point.x * area.width, (1 - point.y) * area.height))
                    }
                }
            }
            Repeater {
                model: root.headings.across === HeadingChoice.Bearing ? [] : root.points

                Rectangle {
                    required property point modelData
                    required property int index
                    readonly property bool best: root.headings.tradeOffs.includes(index)

                    x: modelData.x * area.width - width / 2
                    y: (1 - modelData.y) * area.height - height / 2
                    // The best are told by their size and shape, too.
                    width: best ? 7 : 4
                    height: width
                    radius: best ? 1 : width / 2
                    rotation: best ? 45 : 0
                    color: best ? Theme.swath : Qt.alpha(Theme.muted, 0.55)
                }
            }
        }
        Mark {
            point: root.headings.longestEdge
            color: Theme.panel
            border.color: Theme.muted
            width: 9
        }
        Mark {
            point: root.current
            color: Theme.turn
        }
        Mark {
            objectName: "headings.chosen"
            point: root.headings.chosen
            color: Theme.accent
            width: 13
        }
        BodyText {
            readonly property real place: root.headings.chosen >= 0 && root.headings.chosen < root.points.length ? root.points[root.headings.chosen].x : 0

            x: Math.max(70, Math.min(chart.width - width - 8, area.x + place * area.width - width / 2))
            y: 5
            text: root.headings.points.length > 0 ? root.headings.bearingOf(root.headings.chosen) : ""
            color: Theme.accent
            font.pixelSize: 12
            font.weight: Font.DemiBold
        }
        Scale {
            x: 8
            y: 5
            text: root.headings.mostTime
        }
        Scale {
            x: 8
            anchors { bottom: parent.bottom; bottomMargin: 5 }
            text: root.headings.across === HeadingChoice.Bearing ? root.headings.leastAcross : qsTr("%1 · %2").arg(root.headings.leastTime).arg(root.headings.leastAcross)
        }
        Scale {
            anchors { horizontalCenter: parent.horizontalCenter; bottom: parent.bottom; bottomMargin: 5 }
            visible: root.headings.across === HeadingChoice.Bearing
            text: qsTr("%1 at least").arg(root.headings.leastTime)
        }
        Scale {
            anchors { right: parent.right; rightMargin: 8; bottom: parent.bottom; bottomMargin: 5 }
            text: root.headings.mostAcross
        }
        MouseArea {
            anchors.fill: parent
            hoverEnabled: true
            cursorShape: Qt.PointingHandCursor
            onPositionChanged: mouse => root.current = root.pointAt(mouse)
            onExited: root.current = -1
            onClicked: mouse => root.headings.take(root.pointAt(mouse))
        }
    }
    Caption {
        objectName: "headings.description"
        width: parent.width
        // Again when the figures, the language or the units are others.
        text: root.headings.points.length > 0 ? root.headings.describe(root.shown) : ""
        wrapMode: Text.WordWrap
        lineHeight: 1.15
        // Two lines are kept for it: nothing below moves with the pointer.
        height: Math.max(implicitHeight, 32)
    }
    Caption {
        width: parent.width
        text: qsTr("Estimates for the land inside the headland, to and fro. The plan adds headland, short passes and ways.")
        wrapMode: Text.WordWrap
        lineHeight: 1.15
    }
    PushButton {
        objectName: "headings.search"
        width: parent.width
        visible: root.headings.byHand
        text: qsTr("Let Furrow search the direction")
        onClicked: root.headings.search()
    }

    function pointAt(place: var): int {
        return root.headings.nearest((place.x - area.x) / area.width, 1 - (place.y - area.y) / area.height);
    }
    function step(by: int): void {
        const count = root.points.length;
        if (count > 0)
            root.current = (Math.max(0, root.shown) + by + count) % count;
    }
}
