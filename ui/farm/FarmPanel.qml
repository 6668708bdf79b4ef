pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// All fields of the farm as a list, and what can be done with several at once.
Rectangle {
    id: root

    required property FarmList fields
    required property FarmPlans plans
    signal closeRequested()
    signal fieldOpened()
    /// Name and season of a plan for each of the selected fields.
    signal addPlansRequested()
    signal printRequested()
    signal exportRequested()
    /// The row that the keys are on.
    property alias currentRow: list.currentIndex

    color: Theme.panel

    function begin(): void {
        list.currentIndex = root.fields.rowOfCurrent();
        list.positionViewAtIndex(Math.max(0, list.currentIndex), ListView.Contain);
        list.forceActiveFocus();
    }
    function open(row: int): void {
        root.fields.open(row);
        root.fieldOpened();
    }
    function show(row: int): void {
        list.currentIndex = row;
        list.positionViewAtIndex(row, ListView.Contain);
    }

    // Wherever the keys are: a button that has done its work cannot keep them.
    Shortcut {
        enabled: root.visible
        sequences: [StandardKey.Cancel]
        onActivated: root.closeRequested()
    }

    Rectangle {
        anchors { right: parent.right; top: parent.top; bottom: parent.bottom }
        width: Theme.hairline
        color: Theme.line
    }
    FarmColumns {
        id: place

        width: list.width - 10
    }
    BodyText {
        id: title

        x: 20
        y: 19
        text: qsTr("The farm")
        font.pixelSize: 18
        font.weight: Font.DemiBold
    }
    TextEntry {
        objectName: "farm.filter"
        anchors { left: title.right; right: close.left; leftMargin: 20; rightMargin: 8; verticalCenter: title.verticalCenter }
        name: qsTr("Find a field")
        placeholderText: qsTr("Find a field, season or machine")
        value: root.fields.filter
        onTextEdited: root.fields.filter = text
        Keys.onDownPressed: list.forceActiveFocus()
    }
    ToolIconButton {
        id: close

        objectName: "farm.close"
        anchors { right: parent.right; rightMargin: 14; verticalCenter: title.verticalCenter }
        iconName: "close"
        hint: qsTr("Back to the field (Esc)")
        hintBelow: true
        onClicked: root.closeRequested()
    }
    Item {
        id: head

        anchors { left: list.left; right: list.right; top: title.bottom; topMargin: 14 }
        height: Theme.controlHeight

        FarmHeader {
            objectName: "farm.sort.name"
            x: place.nameAt
            width: place.name - 8
            fields: root.fields
            column: FarmList.Name
            text: qsTr("Field")
        }
        FarmHeader {
            objectName: "farm.sort.machine"
            x: place.machineAt
            width: place.machine - 8
            visible: place.machine > 0
            fields: root.fields
            column: FarmList.Machine
            text: qsTr("Machine")
        }
        FarmHeader {
            objectName: "farm.sort.area"
            x: place.areaAt
            width: place.area - 8
            fields: root.fields
            column: FarmList.Area
            text: qsTr("Area")
        }
        FarmHeader {
            objectName: "farm.sort.time"
            x: place.timeAt
            width: place.time - 8
            fields: root.fields
            column: FarmList.Time
            text: qsTr("Time")
        }
        FarmHeader {
            objectName: "farm.sort.way"
            x: place.wayAt
            width: place.way - 8
            visible: place.way > 0
            fields: root.fields
            column: FarmList.Way
            text: qsTr("Path")
        }
        FarmHeader {
            objectName: "farm.sort.state"
            x: place.stateAt
            width: place.state - 8
            fields: root.fields
            column: FarmList.State
            text: qsTr("State")
        }
    }
    ListView {
        id: list

        objectName: "farm.list"
        anchors { left: parent.left; right: parent.right; top: head.bottom; bottom: foot.top; leftMargin: 12; rightMargin: 8; bottomMargin: 8 }
        clip: true
        activeFocusOnTab: true
        boundsBehavior: Flickable.StopAtBounds
        model: root.fields
        currentIndex: -1
        Accessible.role: Accessible.List
        Accessible.name: qsTr("Fields of the farm")
        Keys.onPressed: event => {
            const by = event.key === Qt.Key_Down ? 1 : event.key === Qt.Key_Up ? -1 : event.key === Qt.Key_PageDown ? 8 : event.key === Qt.Key_PageUp ? -8 : event.key === Qt.Key_Home ? -count : event.key === Qt.Key_End ? count : 0;
            event.accepted = true;
            if (by !== 0 && count > 0) {
                currentIndex = Math.max(0, Math.min(count - 1, currentIndex + by));
                if (event.modifiers & Qt.ShiftModifier)
                    root.fields.pick(currentIndex, FarmList.UpTo);
            } else if ((event.key === Qt.Key_Return || event.key === Qt.Key_Enter) && currentIndex >= 0)
                root.open(currentIndex);
            else if (event.key === Qt.Key_A && event.modifiers & Qt.ControlModifier)
                root.fields.selectAll();
            else
                event.accepted = false;
        }

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

        delegate: FarmRow {
            objectName: "farm.field." + index
            width: list.width - 10
            columns: place
            keyed: list.activeFocus && ListView.isCurrentItem
            onPicked: how => {
                list.currentIndex = index;
                list.forceActiveFocus();
                root.fields.pick(index, how);
            }
            onOpened: root.open(index)
        }
    }
    BodyText {
        anchors.centerIn: list
        visible: list.count === 0
        text: root.fields.filter.length > 0 ? qsTr("No field has these words.") : qsTr("There is no field yet.")
        color: Theme.muted
    }
    Column {
        id: foot

        anchors { left: parent.left; right: parent.right; bottom: parent.bottom; margins: 20 }
        spacing: 12

        Rectangle {
            width: parent.width
            height: Theme.hairline
            color: Theme.line
        }
        Item {
            width: parent.width
            height: Math.max(sum.implicitHeight, Theme.controlHeight)

            BodyText {
                id: sum

                objectName: "farm.totals"
                anchors { left: parent.left; right: none.left; verticalCenter: parent.verticalCenter }
                text: root.fields.totals
                font.weight: Font.Medium
                wrapMode: Text.WordWrap
            }
            SmallButton {
                id: none

                objectName: "farm.selection"
                anchors { right: parent.right; verticalCenter: parent.verticalCenter }
                text: root.fields.selectedCount > 0 ? qsTr("Select none") : qsTr("Select all")
                onClicked: root.fields.selectedCount > 0 ? root.fields.selectNone() : root.fields.selectAll()
            }
        }
        Item {
            width: parent.width
            height: 40
            visible: root.plans.busy || root.plans.status.length > 0

            BodyText {
                objectName: "farm.status"
                anchors { left: parent.left; right: stop.left; rightMargin: 8; top: parent.top }
                text: root.plans.status
                elide: Text.ElideRight
                Accessible.role: Accessible.StaticText
                Accessible.name: text
            }
            ProgressLine {
                anchors { left: parent.left; right: stop.left; rightMargin: 12; bottom: parent.bottom; bottomMargin: 8 }
                visible: root.plans.busy
                value: root.plans.progress
            }
            PushButton {
                id: stop

                objectName: "farm.stop"
                anchors { right: parent.right; verticalCenter: parent.verticalCenter }
                text: root.plans.busy ? qsTr("Stop") : qsTr("OK")
                onClicked: root.plans.busy ? root.plans.cancel() : root.plans.dismiss()
            }
        }
        Flow {
            width: parent.width
            spacing: 8

            PushButton {
                objectName: "farm.plan"
                primary: true
                enabled: root.fields.toPlan > 0
                text: root.fields.toPlan > 0 ? qsTr("Plan %n field(s)", "", root.fields.toPlan) : root.plans.busy ? qsTr("Planning …") : qsTr("All are planned")
                onClicked: root.fields.planSelected()
            }
            PushButton {
                objectName: "farm.alike"
                enabled: root.fields.selectedCount > 0
                text: qsTr("Machine and settings of this plan")
                onClicked: root.fields.planLikeCurrent()
            }
            PushButton {
                objectName: "farm.addPlans"
                enabled: root.fields.selectedCount > 0
                text: qsTr("Add a plan to each…")
                onClicked: root.addPlansRequested()
            }
            PushButton {
                objectName: "farm.print"
                enabled: root.fields.count > 0
                text: qsTr("Print…")
                onClicked: root.printRequested()
            }
            PushButton {
                objectName: "farm.export"
                enabled: root.fields.count > 0
                text: qsTr("Export…")
                onClicked: root.exportRequested()
            }
        }
    }
}
