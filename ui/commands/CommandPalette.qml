pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// Every command by its name: type a part of it, arrows choose, Enter runs.
T.Popup {
    id: root

    required property list<Command> commands
    /// As many as there is room for.
    readonly property int rows: Math.max(2, Math.min(9, Math.floor(((parent ? parent.height : 600) - y - 56 - 12 - 16) / 36)))
    readonly property var found: root.matching(field.text)

    objectName: "commandPalette"
    modal: true
    focus: true
    width: 520
    implicitHeight: 56 + Math.min(list.count, rows) * 36 + (list.count > 0 ? 12 : 44)
    padding: 0
    closePolicy: T.Popup.CloseOnEscape | T.Popup.CloseOnPressOutside
    onAboutToShow: {
        field.text = "";
        list.currentIndex = 0;
    }
    onOpened: field.forceActiveFocus()

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
            placeholderText: qsTr("Search commands")
            placeholderTextColor: Theme.muted
            Accessible.name: qsTr("Search commands")
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
                required property Command modelData

                objectName: "palette.row." + index
                width: list.width
                height: 36
                highlighted: ListView.isCurrentItem
                text: modelData.text
                opacity: modelData.enabled ? 1 : 0.45
                Accessible.name: qsTr("%1: %2").arg(modelData.group).arg(modelData.text)
                onClicked: root.run(index)
                onHoveredChanged: {
                    if (hovered)
                        list.currentIndex = index;
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
                        text: row.modelData.text
                        elide: Text.ElideRight
                    }
                    Caption {
                        id: keys

                        anchors { right: parent.right; rightMargin: 12; verticalCenter: parent.verticalCenter }
                        text: row.modelData.keysText.length > 0 ? row.modelData.keysText : row.modelData.group
                    }
                }
            }
        }
        BodyText {
            anchors { left: parent.left; leftMargin: 48; top: parent.top; topMargin: 70 }
            visible: list.count === 0
            text: qsTr("There is no such command")
            color: Theme.muted
        }
    }

    function matching(text: string): var {
        const words = text.toLowerCase().split(/\s+/).filter(word => word.length > 0);
        const about = command => (command.name + " " + command.group + " " + command.keywords).toLowerCase();
        const fits = root.commands.filter(command => words.every(word => about(command).includes(word)));
        // Those whose name begins so, and those that can be run, come first.
        const rank = command => (command.enabled ? 0 : 2) + (words.length > 0 && command.name.toLowerCase().startsWith(words[0]) ? 0 : 1);
        return fits.map((command, index) => [rank(command), index, command]).sort((a, b) => a[0] - b[0] || a[1] - b[1]).map(entry => entry[2]);
    }
    function run(index: int): void {
        const command = root.found[index];
        if (!command || !command.enabled)
            return;
        root.close();
        if (command.checkable)
            command.toggle();
        command.trigger();
    }
}
