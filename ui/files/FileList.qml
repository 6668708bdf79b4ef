pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// The files of a folder by name, date or size. Arrows move, Space and Ctrl choose several, Return takes what is
/// chosen, Backspace goes up, letters go to names that begin so.
Item {
    id: root

    required property FileBrowser browser
    /// More than one may be chosen.
    property bool several: false
    /// Of what is chosen.
    property list<string> chosen
    readonly property string current: root.browser.pathAt(list.currentIndex)
    readonly property bool wide: width > 520
    /// Where a range began.
    property int anchor: 0
    property string typed: ""
    /// Of the folder that was left upwards.
    property string cameFrom: ""
    signal taken()
    /// The user begins to type a path.
    signal pathBegun(text: string)

    component Title: T.Button {
        id: button

        required property int by
        readonly property bool sorted: root.browser.order === by

        height: Theme.controlHeight
        focusPolicy: Qt.TabFocus
        Accessible.name: sorted ? (root.browser.descending ? qsTr("%1, falling").arg(text) : qsTr("%1, rising").arg(text)) : text
        onClicked: root.browser.sortBy(by)

        background: Rectangle {
            radius: 6
            color: button.hovered ? Theme.hover : "transparent"

            Focusable { control: button; gap: 0 }
        }
        contentItem: Row {
            leftPadding: 10
            spacing: 4

            Caption {
                anchors.verticalCenter: parent.verticalCenter
                text: button.text
                color: button.sorted ? Theme.ink : Theme.muted
            }
            Icon {
                anchors.verticalCenter: parent.verticalCenter
                visible: button.sorted
                width: 14
                height: 14
                name: root.browser.descending ? "chevron-down" : "chevron-up"
                color: Theme.ink
            }
        }
    }

    Row {
        id: titles

        width: parent.width

        Title {
            objectName: "files.byName"
            width: parent.width - (root.wide ? 250 : 0)
            by: FileBrowser.ByName
            text: qsTr("Name")
        }
        Title {
            objectName: "files.byDate"
            visible: root.wide
            width: 150
            by: FileBrowser.ByDate
            text: qsTr("Changed")
        }
        Title {
            objectName: "files.bySize"
            visible: root.wide
            width: 100
            by: FileBrowser.BySize
            text: qsTr("Size")
        }
    }
    Rectangle {
        y: titles.height
        width: parent.width
        height: Theme.hairline
        color: Theme.line
    }
    ListView {
        id: list

        objectName: "files.list"
        anchors { left: parent.left; right: parent.right; top: titles.bottom; bottom: parent.bottom; topMargin: 3 }
        clip: true
        activeFocusOnTab: true
        boundsBehavior: Flickable.StopAtBounds
        model: root.browser
        currentIndex: -1
        highlightMoveDuration: 0
        Accessible.role: Accessible.List
        Accessible.name: qsTr("Files of %1").arg(root.browser.folder)
        Keys.onPressed: event => root.press(event)
        onActiveFocusChanged: {
            if (activeFocus && currentIndex < 0 && count > 0)
                currentIndex = 0;
        }

        T.ScrollBar.vertical: T.ScrollBar {
            id: bar

            width: 8
            padding: 2
            contentItem: Rectangle {
                radius: 2
                color: bar.pressed ? Theme.muted : Theme.line
                visible: bar.size < 1
            }
        }
        delegate: Item {
            id: row

            required property int index
            required property string name
            required property string path
            required property bool isFolder
            required property string changed
            required property string size
            readonly property bool isChosen: root.chosen.includes(path)

            objectName: "files.entry." + name
            width: list.width
            height: Theme.controlHeight
            Accessible.role: Accessible.ListItem
            Accessible.name: isFolder ? qsTr("Folder %1").arg(name) : qsTr("%1, %2, %3").arg(name).arg(changed).arg(size)
            Accessible.selected: isChosen

            Rectangle {
                anchors { fill: parent; leftMargin: 2; rightMargin: 10; topMargin: 1; bottomMargin: 1 }
                radius: 6
                color: row.isChosen ? Theme.softAccent : mouse.containsMouse ? Theme.hover : "transparent"
                border.width: row.ListView.isCurrentItem && list.activeFocus ? 2 : row.isChosen && Theme.sunlight ? 2 : 0
                border.color: Theme.accent
            }
            Icon {
                id: icon

                x: 12
                anchors.verticalCenter: parent.verticalCenter
                width: 18
                height: 18
                name: row.isFolder ? "open" : "file"
                color: row.isFolder ? Theme.accent : Theme.muted
            }
            BodyText {
                anchors { left: icon.right; leftMargin: 9; verticalCenter: parent.verticalCenter }
                width: row.width - x - (root.wide ? 256 : 12)
                text: row.name
                elide: Text.ElideMiddle
            }
            BodyText {
                x: row.width - 240
                width: 146
                anchors.verticalCenter: parent.verticalCenter
                visible: root.wide
                text: row.changed
                color: Theme.muted
                elide: Text.ElideRight
            }
            BodyText {
                x: row.width - 90
                width: 76
                anchors.verticalCenter: parent.verticalCenter
                visible: root.wide
                text: row.size
                color: Theme.muted
            }
            MouseArea {
                id: mouse

                anchors.fill: parent
                hoverEnabled: true
                onClicked: event => {
                    list.forceActiveFocus(Qt.MouseFocusReason);
                    root.choose(row.index, event.modifiers);
                }
                onDoubleClicked: root.taken()
            }
        }
    }
    BodyText {
        anchors.centerIn: list
        width: list.width - 48
        visible: text.length > 0
        text: root.browser.trouble.length > 0 ? root.browser.trouble : root.browser.reading ? qsTr("Reading the folder …") : root.browser.count === 0 ? qsTr("Nothing to choose here.") : ""
        color: Theme.muted
        horizontalAlignment: Text.AlignHCenter
        wrapMode: Text.WordWrap
    }
    Timer {
        id: pause

        interval: 900
        onTriggered: root.typed = ""
    }
    Connections {
        target: root.browser

        function onFolderChanged(): void {
            root.chosen = [];
        }
        function onListed(): void {
            const kept = root.chosen.length > 0 ? root.browser.rowOf(root.browser.nameOf(root.chosen[0])) : -1;
            const from = root.cameFrom.length > 0 ? root.browser.rowOf(root.cameFrom) : -1;
            root.cameFrom = "";
            root.typed = "";
            list.currentIndex = from >= 0 ? from : kept >= 0 ? kept : root.browser.count > 0 ? 0 : -1;
            root.anchor = Math.max(0, list.currentIndex);
            if (list.currentIndex >= 0)
                list.positionViewAtIndex(list.currentIndex, ListView.Contain);
        }
    }

    function focusList(): void {
        list.forceActiveFocus(Qt.TabFocusReason);
    }
    function goUp(): void {
        root.cameFrom = root.browser.nameOf(root.browser.folder);
        root.browser.goUp();
    }
    /// As a click with these keys held does.
    function choose(index: int, modifiers: int): void {
        if (index < 0 || index >= root.browser.count)
            return;
        const path = root.browser.pathAt(index);
        list.currentIndex = index;
        list.positionViewAtIndex(index, ListView.Contain);
        if (root.several && modifiers & Qt.ShiftModifier) {
            const range = [];
            for (let i = Math.min(root.anchor, index); i <= Math.max(root.anchor, index); ++i)
                range.push(root.browser.pathAt(i));
            root.chosen = range;
            return;
        }
        root.anchor = index;
        if (root.several && modifiers & Qt.ControlModifier)
            root.chosen = root.chosen.includes(path) ? root.chosen.filter(each => each !== path) : [...root.chosen, path];
        else
            root.chosen = [path];
    }
    function press(event: var): void {
        const page = Math.max(1, Math.floor(list.height / Theme.controlHeight) - 1);
        const last = root.browser.count - 1;
        const at = Math.max(0, list.currentIndex);
        const steps = { [Qt.Key_Up]: at - 1, [Qt.Key_Down]: root.chosen.length === 0 && at === 0 ? 0 : at + 1, [Qt.Key_PageUp]: at - page, [Qt.Key_PageDown]: at + page, [Qt.Key_Home]: 0, [Qt.Key_End]: last };
        event.accepted = true;
        if (event.key in steps) {
            root.choose(Math.max(0, Math.min(last, steps[event.key])), event.modifiers & Qt.ShiftModifier);
        } else if (event.key === Qt.Key_Return || event.key === Qt.Key_Enter) {
            if (root.chosen.length === 0)
                root.choose(list.currentIndex, 0);
            root.taken();
        } else if (event.key === Qt.Key_Backspace) {
            root.goUp();
        } else if (event.text === "/" || event.text === "~" || event.key === Qt.Key_L && event.modifiers & Qt.ControlModifier) {
            root.pathBegun(event.key === Qt.Key_L ? "" : event.text);
        } else if (event.key === Qt.Key_A && event.modifiers & Qt.ControlModifier) {
            if (root.several)
                root.chosen = Array.from({ length: root.browser.count }, (none, i) => i).filter(i => !root.browser.isFolderAt(i)).map(i => root.browser.pathAt(i));
        } else if (event.key === Qt.Key_Space && root.typed.length === 0) {
            root.choose(list.currentIndex, root.several ? Qt.ControlModifier : 0);
        } else if (event.text.length === 1 && event.text >= " " && !(event.modifiers & (Qt.ControlModifier | Qt.AltModifier))) {
            root.typed += event.text;
            pause.restart();
            const found = root.browser.rowBeginning(root.typed, at);
            if (found >= 0)
                root.choose(found, 0);
        } else {
            event.accepted = false;
        }
    }
}
