import QtQuick
import QtQuick.Templates as T

/// A line of text that is taken over with Enter or on leaving, if it is acceptable.
T.TextField {
    id: root

    /// What the text is, for screen readers.
    required property string name
    property string value: ""
    /// Whether a text may be committed.
    property var accepts: entered => true
    readonly property bool wrong: !root.accepts(root.text)
    /// The text is not that of the value: undo is about the text.
    readonly property bool edited: root.text !== root.value

    signal committed(entered: string)

    implicitWidth: 128
    implicitHeight: Theme.controlHeight
    leftPadding: 12
    rightPadding: 12
    verticalAlignment: TextInput.AlignVCenter
    color: Theme.ink
    selectionColor: Theme.accent
    selectedTextColor: Theme.accentInk
    selectByMouse: true
    font {
        family: Theme.family
        pixelSize: Theme.bodySize
    }
    Accessible.name: root.name

    background: EntryFrame {
        focused: root.activeFocus
        wrong: root.wrong
    }

    EntryHint {
        visible: root.text.length === 0 && root.preeditText.length === 0
        text: root.placeholderText
    }

    onValueChanged: root.text = root.value
    onActiveFocusChanged: {
        if (activeFocus)
            selectAll();
        else
            commit();
    }
    onAccepted: commit()
    Keys.onEscapePressed: {
        root.text = root.value;
        root.focus = false;
    }
    Component.onCompleted: root.text = root.value

    function commit(): void {
        if (root.wrong)
            root.text = root.value;
        else if (root.text !== root.value)
            root.committed(root.text);
    }
}
