pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls
import Furrow.Edit
import Furrow.Plan

/// The figures of the plan and what was found in it.
Rectangle {
    id: root

    required property PlanSession session
    required property FieldEditor editor
    property int currentFinding: -1
    signal findingRequested(index: int)

    objectName: "resultsPanel"
    color: Theme.panel

    component Title: BodyText {
        font.pixelSize: Theme.titleSize
        font.weight: Font.DemiBold
        bottomPadding: 6
    }

    Rectangle {
        width: Theme.hairline
        height: parent.height
        color: Theme.line
        z: 1
    }
    Flickable {
        id: flick

        anchors.fill: parent
        contentHeight: column.height + 40
        boundsBehavior: Flickable.StopAtBounds
        clip: true

        T.ScrollBar.vertical: T.ScrollBar {
            id: bar

            width: 8
            padding: 2
            contentItem: Rectangle {
                radius: 2
                color: Theme.line
                visible: bar.size < 1
            }
        }

        Column {
            id: column

            x: 18
            y: 20
            width: flick.width - 36

            InspectorPanel {
                id: inspectorPanel

                width: parent.width
                inspector: Inspector { editor: root.editor }
            }
            Title { text: qsTr("Plan") }
            Repeater {
                model: root.session.figures

                Item {
                    id: figure

                    required property string label
                    required property string value
                    required property string hint

                    width: column.width
                    height: 29
                    Accessible.role: Accessible.StaticText
                    Accessible.name: qsTr("%1: %2").arg(label).arg(value)
                    Accessible.description: hint

                    BodyText {
                        anchors.verticalCenter: parent.verticalCenter
                        text: figure.label
                        color: Theme.muted
                    }
                    BodyText {
                        objectName: "figure." + figure.label
                        anchors { right: parent.right; verticalCenter: parent.verticalCenter }
                        text: figure.value
                    }
                    Rectangle {
                        anchors.bottom: parent.bottom
                        width: parent.width
                        height: Theme.hairline
                        color: Theme.line
                    }
                }
            }
            Item { width: 1; height: 24; visible: root.session.findings.count > 0 }
            Title {
                visible: root.session.findings.count > 0
                text: qsTr("%n finding(s)", "", root.session.findings.count)
            }
            Column {
                width: parent.width
                spacing: 8

                Repeater {
                    model: root.session.findings

                    FindingRow {
                        required property int index

                        objectName: "finding." + index
                        width: column.width
                        current: index === root.currentFinding
                        onClicked: root.findingRequested(index)
                    }
                }
            }
            SmallButton {
                objectName: "allFindings"
                visible: root.session.findings.count > root.session.findings.few
                text: root.session.findings.all ? qsTr("Show the first %1 only").arg(root.session.findings.few) : qsTr("Show all %1").arg(root.session.findings.count)
                height: 32
                onClicked: root.session.findings.all = !root.session.findings.all
            }
        }
    }

    function focusInspector(): void {
        inspectorPanel.focusFirst();
    }
}
