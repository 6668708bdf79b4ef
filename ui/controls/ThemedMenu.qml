pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T

/// A menu in the window's look.
T.Menu {
    id: root

    implicitWidth: widest() + leftPadding + rightPadding
    implicitHeight: contentItem.implicitHeight + topPadding + bottomPadding
    padding: 4
    margins: 4
    overlap: 1
    enter: Transition {
        NumberAnimation { property: "opacity"; from: 0; to: 1; duration: Theme.motion }
    }
    delegate: ThemedMenuItem {}
    onAboutToShow: root.giveLetters()
    background: Rectangle {
        radius: Theme.radius
        color: Theme.panel
        border.width: Theme.hairline
        border.color: Theme.line

        SoftShadow { radius: Theme.radius }
    }
    contentItem: ListView {
        // The letters come here.
        focus: true
        implicitHeight: contentHeight
        model: root.contentModel
        interactive: contentHeight > height + 1
        Keys.onPressed: event => {
            const item = event.modifiers & (Qt.ControlModifier | Qt.MetaModifier) ? null : root.itemOfLetter(event.text);
            event.accepted = item !== null;
            if (item)
                Qt.callLater(() => item.click());
        }
        clip: true
        currentIndex: root.currentIndex

        T.ScrollBar.vertical: T.ScrollBar {
            id: bar

            width: 6
            contentItem: Rectangle {
                radius: 3
                color: Theme.line
                visible: bar.size < 1
            }
        }
    }

    /// Each entry that can be run by a letter gets the first of its text that none before it has.
    function giveLetters(): void {
        const taken = [];
        for (let i = 0; i < root.count; ++i) {
            const item = root.itemAt(i) as ThemedMenuItem;
            if (!item)
                continue;
            item.letter = [...item.text.toLowerCase()].find(letter => (letter !== letter.toUpperCase() || /[0-9]/.test(letter)) && !taken.includes(letter)) ?? "";
            taken.push(item.letter);
        }
    }
    function itemOfLetter(letter: string): ThemedMenuItem {
        for (let i = 0; letter.length > 0 && i < root.count; ++i) {
            const item = root.itemAt(i) as ThemedMenuItem;
            if (item && item.enabled && item.letter === letter.toLowerCase())
                return item;
        }
        return null;
    }
    function widest(): real {
        let width = 0;
        for (let i = 0; i < root.count; ++i)
            width = Math.max(width, root.itemAt(i)?.implicitWidth ?? 0);
        return Math.max(width, 272);
    }
}
