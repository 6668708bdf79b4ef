import QtQuick
import QtQuick.Templates as T

/// A text of several lines, as high as it needs. Enter takes it over, Shift and Enter begin a line.
T.TextArea {
    id: root

    /// What the text is, for screen readers.
    required property string name
    /// Undo is about the text.
    readonly property bool edited: root.text.length > 0

    signal accepted()

    implicitWidth: 128
    implicitHeight: Math.max(Theme.controlHeight, contentHeight + topPadding + bottomPadding)
    leftPadding: 12
    rightPadding: 12
    topPadding: 8
    bottomPadding: 8
    verticalAlignment: TextEdit.AlignVCenter
    wrapMode: TextEdit.Wrap
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
    }

    EntryHint {
        visible: root.text.length === 0 && root.preeditText.length === 0
        text: root.placeholderText
    }

    Keys.onPressed: event => {
        const isEnter = event.key === Qt.Key_Return || event.key === Qt.Key_Enter;
        if (isEnter && (event.modifiers & ~Qt.KeypadModifier) === Qt.NoModifier) {
            root.accepted();
        } else if (event.key === Qt.Key_Tab || event.key === Qt.Key_Backtab) {
            const ahead = event.key === Qt.Key_Tab;
            root.nextItemInFocusChain(ahead).forceActiveFocus(ahead ? Qt.TabFocusReason : Qt.BacktabFocusReason);
        } else if (event.key === Qt.Key_Escape) {
            root.focus = false;
        } else {
            return;
        }
        event.accepted = true;
    }
}
