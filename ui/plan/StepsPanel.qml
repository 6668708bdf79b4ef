pragma ComponentBehavior: Bound
import QtQuick
import Furrow.Controls
import Furrow.Project

/// The steps from field to export, one of them open.
Rectangle {
    id: root

    required property Planning planning
    required property FieldOpener opener
    property string openStep: "field"
    signal openRequested()
    signal drawRequested()
    signal checkRequested()
    signal exportRequested()
    signal bestPlanRequested()
    signal swathChosen(segment: int)

    /// To be looked for in the step that opens; empty for none.
    property string wantedKey: ""

    objectName: "stepsPanel"
    color: Theme.panel

    ScrollArea {
        id: flick

        anchors { left: parent.left; right: parent.right; top: parent.top; bottom: foot.top }
        contentHeight: column.height + 24

        Column {
            id: column

            x: 12
            y: 12
            width: flick.width - 24
            spacing: 2

            Repeater {
                id: stepItems

                model: root.planning.steps

                StepItem {
                    id: step

                    width: column.width
                    planning: root.planning
                    opener: root.opener
                    open: !leadsOn && root.openStep === stepId
                    onToggled: root.openStep = open ? "" : stepId
                    onOpened: {
                        flick.bringIntoView(step);
                        root.focusWanted(step);
                    }
                    onGrown: part => Qt.callLater(flick.bringIntoView, part)
                    onOpenRequested: root.openRequested()
                    onDrawRequested: root.drawRequested()
                    onCheckRequested: root.checkRequested()
                    onExportRequested: root.exportRequested()
                    onSwathChosen: segment => root.swathChosen(segment)
                }
            }
        }
    }
    Rectangle {
        id: foot

        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        height: visible ? best.height + 20 : 0
        visible: root.planning.state !== PlanState.Empty && root.planning.state !== PlanState.Choosing
        color: Theme.panel

        Rectangle {
            width: parent.width
            height: Theme.hairline
            color: Theme.line
        }
        PushButton {
            id: best

            objectName: "steps.bestPlan"
            anchors { left: parent.left; right: parent.right; verticalCenter: parent.verticalCenter; margins: 12 }
            text: qsTr("Find the best plan…")
            onClicked: root.bestPlanRequested()
        }
    }
    /// Opens a step at one of its settings; where that is not shown as things are, at the first.
    function openSetting(stepId: string, key: string): void {
        root.wantedKey = key;
        for (let i = 0; i < stepItems.count; ++i) {
            const step = stepItems.itemAt(i) as StepItem;
            if (step.stepId !== stepId)
                continue;
            if (root.openStep === stepId)
                root.focusWanted(step);
            else
                root.openStep = stepId;
        }
    }
    /// Opens the list of swaths.
    function changeOrder(): void {
        root.openSetting("route", "order.begin");
        root.planning.order.pointing = true;
    }
    function focusWanted(step: Item): void {
        if (root.wantedKey.length === 0)
            return;
        // What is picked on the map has a button instead of a field.
        const field = root.below(step, root.wantedKey) ?? root.below(step, root.wantedKey + ".pick");
        root.wantedKey = "";
        if (field)
            field.forceActiveFocus(Qt.TabFocusReason);
    }
    function below(item: Item, name: string): Item {
        if (item.objectName === name)
            return item;
        for (const child of item.children) {
            const found = root.below(child, name);
            if (found)
                return found;
        }
        return null;
    }

    Rectangle {
        anchors { top: parent.top; bottom: parent.bottom; right: parent.right }
        width: Theme.hairline
        color: Theme.line
    }
}
