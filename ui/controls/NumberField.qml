import QtQuick
import QtQuick.Templates as T
import Furrow.Text

/// A quantity in the user's unit, in SI units for the one who uses the field. Units of either system, point and comma
/// are understood; arrow keys and the wheel step; Enter commits; Esc and undo take what is typed back. What is refused
/// is said beside the field.
T.TextField {
    id: root

    /// What the number is, for screen readers.
    required property string name
    property double value: 0
    property double from: 0
    property double to: 1000000
    property double step: 1
    property int decimals: 1
    property int kind: QuantityText.Number
    readonly property string unitText: Display.quantities.unit(kind)
    /// Why the text is refused.
    readonly property string complaint: text.length > 0 ? Display.quantities.complaint(text, kind, from, to, decimals) : ""
    /// Shown instead of a number where the planner chooses it; empty where the value counts.
    property string autoText: ""
    readonly property bool wrong: complaint.length > 0
    /// The text is not that of the value: undo is about the text.
    readonly property bool edited: text !== textOf(value, autoText, kind, decimals)

    signal committed(newValue: double)
    signal cleared()
    /// What was typed is given up.
    signal takenBack()

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
    inputMethodHints: Qt.ImhPreferNumbers
    font {
        family: Theme.family
        pixelSize: Theme.bodySize
        features: ({ "tnum": 1 })
    }
    Accessible.name: root.name
    Accessible.description: root.wrong ? root.complaint : root.unitText

    background: EntryFrame {
        focused: root.activeFocus
        wrong: root.wrong

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

    onValueChanged: {
        const whole = activeFocus && selectedText.length > 0 && selectedText === text;
        root.showValue();
        if (whole)
            selectAll();
    }
    onAutoTextChanged: root.showValue()
    onDecimalsChanged: root.showValue()
    onKindChanged: root.showValue()
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
        root.takeBack();
        root.focus = false;
    }
    Keys.onPressed: event => {
        // The field's own undo would go on to texts that were values before.
        if (root.edited && event.matches(StandardKey.Undo)) {
            root.takeBack();
            selectAll();
            event.accepted = true;
        }
    }
    Component.onCompleted: showValue()

    Connections {
        target: Display
        function onChanged(): void {
            root.showValue();
        }
    }
    // Over all that stands around the field, and inside of the window.
    T.Popup {
        id: bubble

        readonly property real windowHeight: T.Overlay.overlay ? T.Overlay.overlay.height : 0

        width: Math.max(root.width, 200)
        implicitHeight: told.implicitHeight + 12
        margins: 8
        closePolicy: T.Popup.NoAutoClose
        visible: root.activeFocus && root.wrong && root.visible
        onAboutToShow: y = root.mapToItem(null, 0, root.height).y + 4 + height + margins > windowHeight ? -height - 4 : root.height + 4
        background: Rectangle {
            objectName: root.objectName + ".complaint"
            radius: Theme.radius
            color: Theme.failureGround
            border.width: Theme.hairline
            border.color: Theme.failure
        }
        contentItem: Item {
            BodyText {
                id: told

                anchors { left: parent.left; right: parent.right; margins: 8; verticalCenter: parent.verticalCenter }
                text: root.complaint
                color: Theme.failure
                font.pixelSize: Theme.labelSize
                wrapMode: Text.WordWrap
            }
        }
    }
    WheelHandler {
        enabled: root.activeFocus
        acceptedDevices: PointerDevice.Mouse | PointerDevice.TouchPad
        onWheel: event => root.stepBy(event.angleDelta.y > 0 ? 1 : -1)
    }

    function textOf(value: double, autoText: string, kind: int, decimals: int): string {
        return autoText.length > 0 ? "" : Display.quantities.text(value, kind, decimals);
    }
    function showValue(): void {
        root.text = root.textOf(root.value, root.autoText, root.kind, root.decimals);
    }
    function takeBack(): void {
        root.showValue();
        root.takenBack();
    }
    function stepBy(direction: int): void {
        const shown = Display.quantities.isValue(root.text, root.kind) ? Display.quantities.value(root.text, root.kind) : root.value;
        const by = Display.quantities.roundStep(root.step, root.kind);
        const next = Math.round((shown + direction * by) / by) * by;
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
            root.takeBack();
            return;
        }
        // A value that only looks as before stays as exact as it is.
        if (root.autoText.length > 0 || root.text !== Display.quantities.text(root.value, root.kind, root.decimals))
            root.committed(Math.min(root.to, Math.max(root.from, Display.quantities.value(root.text, root.kind))));
        root.showValue();
    }
}
