import QtQuick
import QtQuick.Templates as T

/// A number with its unit. Point and comma are both understood; arrow keys and the wheel step; Enter commits.
T.TextField {
    id: root

    /// What the number is, for screen readers.
    required property string name
    property double value: 0
    property double from: 0
    property double to: 1000000
    property double step: 1
    property int decimals: 1
    property string unitText: ""
    /// Shown instead of a number where the planner chooses it; empty where the value counts.
    property string autoText: ""
    readonly property bool wrong: text.length > 0 && (!NumberText.isNumber(text) || NumberText.number(text) < from || NumberText.number(text) > to)

    signal committed(newValue: double)
    signal cleared()

    implicitWidth: 128
    implicitHeight: Theme.controlHeight
    leftPadding: 12
    rightPadding: unitLabel.implicitWidth + 20
    verticalAlignment: TextInput.AlignVCenter
    color: Theme.ink
    selectionColor: Theme.accent
    selectedTextColor: Theme.accentInk
    placeholderTextColor: Theme.muted
    selectByMouse: true
    inputMethodHints: Qt.ImhFormattedNumbersOnly
    font {
        family: Theme.family
        pixelSize: Theme.bodySize
        features: ({ "tnum": 1 })
    }
    Accessible.name: root.name
    Accessible.description: root.unitText

    background: Rectangle {
        radius: Theme.radius
        color: Theme.panel
        border.width: root.activeFocus ? 2 : Theme.hairline
        border.color: root.wrong ? Theme.failure : root.activeFocus ? Theme.accent : Theme.line

        BodyText {
            anchors { left: parent.left; leftMargin: 12; verticalCenter: parent.verticalCenter }
            text: root.autoText
            color: Theme.muted
            visible: root.text.length === 0 && !root.activeFocus
        }
        BodyText {
            id: unitLabel

            anchors { right: parent.right; rightMargin: 12; verticalCenter: parent.verticalCenter }
            text: root.unitText
            color: Theme.muted
        }
    }

    onValueChanged: root.showValue()
    onAutoTextChanged: root.showValue()
    onDecimalsChanged: root.showValue()
    onActiveFocusChanged: {
        if (activeFocus)
            selectAll();
        else
            commit();
    }
    onAccepted: {
        commit();
        selectAll();
    }
    Keys.onUpPressed: root.stepBy(1)
    Keys.onDownPressed: root.stepBy(-1)
    Keys.onEscapePressed: {
        root.showValue();
        root.focus = false;
    }
    Component.onCompleted: showValue()

    WheelHandler {
        enabled: root.activeFocus
        acceptedDevices: PointerDevice.Mouse | PointerDevice.TouchPad
        onWheel: event => root.stepBy(event.angleDelta.y > 0 ? 1 : -1)
    }

    function showValue(): void {
        root.text = root.autoText.length > 0 ? "" : NumberText.text(root.value, root.decimals);
    }
    function stepBy(direction: int): void {
        const shown = NumberText.isNumber(root.text) ? NumberText.number(root.text) : root.value;
        const next = Math.round((shown + direction * root.step) / root.step) * root.step;
        root.committed(Math.min(root.to, Math.max(root.from, next)));
    }
    function commit(): void {
        if (root.text.length === 0) {
            if (root.autoText.length === 0)
                root.cleared();
            root.showValue();
            return;
        }
        if (root.wrong) {
            root.showValue();
            return;
        }
        const typed = NumberText.number(root.text);
        if (root.autoText.length > 0 || NumberText.text(typed, root.decimals) !== NumberText.text(root.value, root.decimals))
            root.committed(typed);
        root.showValue();
    }
}
