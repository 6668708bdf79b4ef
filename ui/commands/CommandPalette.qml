pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// Every command, setting and machine by its name: type a part of it, arrows choose, Enter runs. Coordinates go
/// to their place.
T.Popup {
    id: root

    required property list<Command> commands
    /// Settings and what else may be gone to: name, group, keywords, and what `entryChosen` needs. Only found
    /// by what is typed.
    property var entries: []
    /// The entry for a text that names a place; null where it names none.
    property var placeEntry: text => null
    signal entryChosen(entry: var)
    /// As many as there is room for.
    readonly property int rows: Math.max(2, Math.min(9, Math.floor(((parent ? parent.height : 600) - y - 56 - 12 - 16) / 36)))
    readonly property var found: visible ? root.matching(field.text) : []
    /// Where the pointer was seen last since it was opened.
    property var pointer: undefined
    /// What to type, until it is closed; empty for the usual words.
    property string hint: ""

    objectName: "commandPalette"
    modal: true
    focus: true
    width: 520
    implicitHeight: 56 + Math.min(list.count, rows) * 36 + (list.count > 0 ? 12 : 44)
    padding: 0
    closePolicy: T.Popup.CloseOnEscape | T.Popup.CloseOnPressOutside
    onAboutToShow: {
        root.pointer = undefined;
        field.text = "";
        list.currentIndex = 0;
    }
    onOpened: field.forceActiveFocus()
    onClosed: hint = ""

    T.Overlay.modal: Rectangle { color: "#33000000" }
    background: Rectangle {
        radius: 14
        color: Theme.panel
        border.width: Theme.hairline
        border.color: Theme.line
    }
    contentItem: Item {
        Icon {
            x: 18
            y: 18
            name: "search"
            color: Theme.muted
        }
        T.TextField {
            id: field

            objectName: "palette.field"
            anchors { left: parent.left; right: parent.right; top: parent.top; leftMargin: 48; rightMargin: 16 }
            height: 56
            verticalAlignment: TextInput.AlignVCenter
            color: Theme.ink
            selectionColor: Theme.accent
            selectedTextColor: Theme.accentInk
            font { family: Theme.family; pixelSize: 15 }
            placeholderText: root.hint.length > 0 ? root.hint : qsTr("Search commands, settings, coordinates")
            placeholderTextColor: Theme.muted
            Accessible.name: placeholderText
            onTextChanged: list.currentIndex = 0
            onAccepted: root.run(list.currentIndex)
            Keys.onDownPressed: list.incrementCurrentIndex()
            Keys.onUpPressed: list.decrementCurrentIndex()
            Keys.onPressed: event => {
                if (event.key === Qt.Key_PageDown || event.key === Qt.Key_PageUp) {
                    const way = event.key === Qt.Key_PageDown ? 8 : -8;
                    list.currentIndex = Math.max(0, Math.min(list.count - 1, list.currentIndex + way));
                    event.accepted = true;
                }
            }

            BodyText {
                anchors.verticalCenter: parent.verticalCenter
                visible: field.text.length === 0
                text: field.placeholderText
                font.pixelSize: 15
                color: Theme.muted
            }
        }
        Rectangle {
            y: 56
            width: parent.width
            height: Theme.hairline
            color: Theme.line
        }
        ListView {
            id: list

            anchors { left: parent.left; right: parent.right; top: parent.top; bottom: parent.bottom; topMargin: 62; margins: 6 }
            clip: true
            model: root.found
            boundsBehavior: Flickable.StopAtBounds
            highlightMoveDuration: 0

            delegate: T.ItemDelegate {
                id: row

                required property int index
                /// A command, or an entry.
                required property var modelData
                readonly property bool runs: modelData.enabled ?? true
                readonly property string name: modelData.text ?? modelData.name
                readonly property string groupTitle: root.groupOf(modelData)

                objectName: "palette.row." + index
                width: list.width
                height: 36
                highlighted: ListView.isCurrentItem
                text: name
                opacity: runs ? 1 : 0.45
                Accessible.name: qsTr("%1: %2").arg(groupTitle).arg(name)
                onClicked: root.run(index)
                HoverHandler {
                    // A row that comes to lie under a pointer at rest is not chosen by that.
                    onPointChanged: {
                        const at = point.scenePosition;
                        if (root.pointer && (at.x !== root.pointer.x || at.y !== root.pointer.y))
                            list.currentIndex = row.index;
                        root.pointer = at;
                    }
                }

                background: Rectangle {
                    radius: 6
                    color: row.highlighted ? Theme.softAccent : "transparent"
                    border.width: row.highlighted && Theme.sunlight ? 2 : 0
                    border.color: Theme.accent
                }
                contentItem: Item {
                    BodyText {
                        anchors { left: parent.left; leftMargin: 12; right: keys.left; rightMargin: 12; verticalCenter: parent.verticalCenter }
                        text: row.name
                        elide: Text.ElideRight
                    }
                    Caption {
                        id: keys

                        anchors { right: parent.right; rightMargin: 12; verticalCenter: parent.verticalCenter }
                        text: row.modelData.keysText ? row.modelData.keysText : row.groupTitle
                    }
                }
            }
        }
        BodyText {
            anchors { left: parent.left; leftMargin: 48; top: parent.top; topMargin: 70 }
            visible: list.count === 0
            text: field.text.length > 0 ? qsTr("There is no command and no setting of that name") : qsTr("As maps, phones and receivers write them")
            color: Theme.muted
        }
    }

    /// In words.
    function groupOf(one: var): string {
        return one instanceof Command ? one.group.title : one.group;
    }
    function matching(text: string): var {
        if (text.length === 0 && root.hint.length > 0)
            return [];
        const plain = text => text.toLowerCase().replace(/…|\.\.\.|⋯/g, " ").replace(/\s+/g, " ").trim();
        const wanted = plain(text);
        const words = wanted.split(" ").filter(word => word.length > 0);
        const all = words.length > 0 ? [...root.commands, ...root.entries] : [...root.commands];
        const about = one => plain(one.name + " " + root.groupOf(one) + " " + one.keywords);
        const fits = all.filter(one => words.every(word => about(one).includes(word)));
        // What is called just so comes first. Then what can be run, commands before settings, by how near the name is.
        const nameRank = name => words.length === 0 || name === wanted ? 0 : name.startsWith(wanted) ? 1 : words.every(word => (" " + name.replace(/[\s:·.,()\/–—-]+/g, " ")).includes(" " + word)) ? 2 : words.every(word => name.includes(word)) ? 3 : 4;
        const rank = one => {
            const near = nameRank(plain(one.name));
            const isCommand = one instanceof Command;
            if (near === 0 && words.length > 0)
                return isCommand ? 0 : 1;
            return near + (isCommand ? 1 : 4) + ((one.enabled ?? true) ? 0 : 10);
        };
        const place = root.placeEntry(text);
        return [...fits.map((one, index) => [rank(one), index, one]).sort((a, b) => a[0] - b[0] || a[1] - b[1]).map(entry => entry[2]), ...(place ? [place] : [])];
    }
    function run(index: int): void {
        const chosen = root.found[index];
        if (!chosen || !(chosen.enabled ?? true))
            return;
        root.close();
        if (!(chosen instanceof Command)) {
            root.entryChosen(chosen);
            return;
        }
        if (chosen.checkable)
            chosen.toggle();
        chosen.trigger();
    }
}
