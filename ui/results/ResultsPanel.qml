pragma ComponentBehavior: Bound
import QtQuick
import Furrow.Controls
import Furrow.Edit
import Furrow.Map
import Furrow.Plan
import Furrow.Review

/// The figures of the plan and what was found in it.
Rectangle {
    id: root

    required property ShownPlan shown
    required property Planning planning
    required property FiguresModel figures
    required property FindingsModel findings
    required property PlanChange lastChange
    required property ReviewModel review
    readonly property alias reviewSection: reviewSection
    required property FieldEditor editor
    property int currentFinding: -1
    /// The list of findings was asked for.
    property bool checked: false
    readonly property bool outOfDate: planning.state === PlanState.OutOfDate
    /// The figures are not those of the finished plan of what the panels show.
    readonly property bool preliminary: planning.state === PlanState.Planning && (shown.draft || planning.slow)
    signal findingRequested(index: int)
    signal driveRequested(segment: int)

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
    ScrollArea {
        id: flick

        anchors.fill: parent
        contentHeight: column.height + 40

        Column {
            id: column

            x: 18
            y: 20
            width: flick.width - 36

            InspectorPanel {
                id: inspectorPanel

                width: parent.width
                inspector: Inspector { editor: root.editor }
                onDriveRequested: segment => root.driveRequested(segment)
            }
            Item {
                width: parent.width
                height: planTitle.height

                Title {
                    id: planTitle

                    text: qsTr("Plan")
                }
                Caption {
                    objectName: "results.preliminary"
                    anchors { left: planTitle.right; right: parent.right; leftMargin: 12; baseline: planTitle.baseline }
                    visible: root.preliminary
                    horizontalAlignment: Text.AlignRight
                    text: root.shown.draft ? qsTr("first plan: preliminary figures") : qsTr("of the plan before")
                    elide: Text.ElideRight
                }
            }
            Column {
                width: parent.width
                visible: root.outOfDate
                bottomPadding: 8

                NoticeBar {
                    objectName: "results.outOfDate"
                    width: parent.width
                    text: qsTr("Out of date: figures and findings are those of the plan before the change.")
                }
            }
            Repeater {
                model: root.figures

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
                        opacity: root.outOfDate || root.preliminary ? 0.6 : 1
                    }
                    Rectangle {
                        anchors.bottom: parent.bottom
                        width: parent.width
                        height: Theme.hairline
                        color: Theme.line
                    }
                }
            }
            Caption {
                objectName: "results.lastChange"
                width: parent.width
                visible: text.length > 0 && !root.outOfDate && !root.preliminary
                topPadding: 8
                text: root.lastChange.text
                wrapMode: Text.WordWrap
                lineHeight: 1.15
            }
            Item { width: 1; height: 24; visible: root.findings.count > 0 || root.findings.outcome.length > 0 }
            Column {
                width: parent.width
                visible: root.findings.outcome.length > 0
                bottomPadding: 12

                Rectangle {
                    width: parent.width
                    height: outcome.implicitHeight + 20
                    radius: Theme.radius
                    color: Theme.softAccent
                    border.width: Theme.sunlight ? 1 : 0
                    border.color: Theme.accent
                    Accessible.role: Accessible.AlertMessage
                    Accessible.name: outcome.text

                    BodyText {
                        id: outcome

                        objectName: "findings.outcome"
                        anchors { left: parent.left; right: close.left; verticalCenter: parent.verticalCenter; leftMargin: 12; rightMargin: 4 }
                        text: root.findings.outcome
                        wrapMode: Text.WordWrap
                        lineHeight: 1.15
                    }
                    SmallButton {
                        id: close

                        objectName: "findings.outcome.close"
                        anchors { right: parent.right; top: parent.top; margins: 6 }
                        text: qsTr("Close")
                        onClicked: root.findings.forgetOutcome()
                    }
                }
            }
            Title {
                id: findingsTitle

                readonly property int others: root.findings.toLookAt - root.findings.blocking

                objectName: "findings.title"
                visible: root.findings.toLookAt > 0
                text: root.findings.blocking === 0 ? qsTr("%n finding(s)", "", others) : [qsTr("%n problem(s)", "", root.findings.blocking), others > 0 ? qsTr("%n to look at", "", others) : ""].filter(part => part.length > 0).join(" · ")
            }
            BodyText {
                objectName: "noFindings"
                width: parent.width
                visible: root.checked && root.findings.toLookAt === 0
                topPadding: 24
                text: qsTr("Nothing was found in this plan: all of it can be driven.")
                wrapMode: Text.WordWrap
                lineHeight: 1.15
            }
            Column {
                width: parent.width
                spacing: 8

                Repeater {
                    id: findingRows

                    model: root.findings

                    FindingRow {
                        required property int findingIndex

                        objectName: "finding." + findingIndex
                        width: column.width
                        current: findingIndex === root.currentFinding
                        onClicked: root.findingRequested(findingIndex)
                        onApplied: root.findings.apply(findingIndex)
                        onStepped: by => {
                            const next = root.findings.nextOfKind(findingIndex, by);
                            root.findings.bringForward(next);
                            root.findingRequested(next);
                        }
                    }
                }
            }
            SmallButton {
                objectName: "allFindings"
                visible: root.findings.rows > root.findings.few
                text: root.findings.all ? qsTr("Show the first %1 only").arg(root.findings.few) : qsTr("Show all %1").arg(root.findings.rows)
                height: 32
                onClicked: root.findings.all = !root.findings.all
            }
            Item { width: 1; height: 24 }
            ReviewSection {
                id: reviewSection

                objectName: "reviewSection"
                width: parent.width
                review: root.review
                onTold: where => {
                    column.forceLayout();
                    flick.bringIntoView(where);
                }
            }
        }
    }

    function showFindings(): void {
        root.checked = true;
        // Once it is laid out, where it was hidden before.
        Qt.callLater(() => {
            flick.contentY = Math.max(0, Math.min(findingsTitle.y + column.y - 12, flick.contentHeight - flick.height));
            (root.findings.count > 0 ? findingRows.itemAt(0) : root).forceActiveFocus(Qt.TabFocusReason);
        });
    }
    /// Brings a row into view, once it is laid out.
    function showFinding(index: int): void {
        root.findings.bringForward(index);
        const at = root.findings.rowOf(index);
        if (at >= root.findings.few)
            root.findings.all = true;
        Qt.callLater(() => {
            const row = findingRows.itemAt(at);
            if (row)
                flick.bringIntoView(row);
        });
    }
    Keys.onEscapePressed: event => event.accepted = root.editor.escape()
    function showReview(): void {
        Qt.callLater(flick.bringIntoView, reviewSection);
    }
    function focusInspector(): void {
        inspectorPanel.focusFirst();
    }
}
