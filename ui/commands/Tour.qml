pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import QtCore
import Furrow.Controls

/// The first things to do, as a small list that ticks itself off as they are done. Nothing is locked, nothing is in
/// the way; it can be left at any moment.
Item {
    id: root

    /// What of the window each task is about; it gets a frame while the pointer or the keyboard is on the task.
    required property list<Item> places
    /// Done or not, by what is there and what was done since the start.
    required property bool hasField
    required property string machineName
    required property bool dragging
    /// A plan was written to files.
    required property bool exported
    property bool running: false
    /// It was shown before, to the end or not.
    property bool seen: false
    property list<bool> done: [false, false, false, false]
    readonly property bool finished: !done.includes(false)
    readonly property list<var> tasks: [
        [qsTr("Get a field"), qsTr("Open its boundary, draw it, or press here for a sample.")],
        [qsTr("Choose your machine"), qsTr("The second step: the one most like yours, then its width.")],
        [qsTr("Change the field"), qsTr("Drag a corner on the map. The plan follows; Ctrl+Z takes it back.")],
        [qsTr("Take it to the tractor"), qsTr("Export writes the plan to a stick or a folder and checks it.")]
    ]
    /// What it takes of the width at the right.
    readonly property real takenWidth: running ? card.width + 16 : 0
    /// On a small map only the next task is listed: the others would cover the field. An empty map has none.
    readonly property bool compact: height < 720 || (hasField && width < 1400)
    property string machineAtStart: ""
    property Item place: null
    /// A task was pressed: what it is about should open.
    signal taskRequested(task: int)

    objectName: "tour"
    visible: running
    Keys.onEscapePressed: root.leave()
    onHasFieldChanged: root.tick(0, root.hasField)
    onMachineNameChanged: if (root.machineName !== root.machineAtStart) root.tick(1, true)
    onDraggingChanged: if (root.dragging) root.tick(2, true)
    onExportedChanged: if (root.exported) root.tick(3, true)

    readonly property Settings stored: Settings {
        category: "tour"
        property alias seen: root.seen
    }

    // The frame.
    Rectangle {
        readonly property point corner: root.place && root.width > 0 && root.height > 0 ? root.place.mapToItem(root, 0, 0) : Qt.point(0, 0)

        visible: root.place !== null && root.place.visible
        x: corner.x + 2
        y: corner.y + 2
        width: root.place ? root.place.width - 4 : 0
        height: root.place ? root.place.height - 4 : 0
        radius: Theme.cardRadius
        color: "transparent"
        border.width: 3
        border.color: Theme.accent
    }
    Rectangle {
        id: card

        objectName: "tour.card"
        anchors { right: parent.right; bottom: parent.bottom; margins: 16 }
        width: Math.min(316, parent.width - 32)
        height: Math.min(column.height + 28, parent.height - 32)
        radius: Theme.cardRadius
        color: Theme.panel
        border.width: Theme.hairline
        border.color: Theme.line
        Accessible.role: Accessible.List
        Accessible.name: title.text

        SoftShadow { radius: card.radius }
        MouseArea { anchors.fill: parent }
        Column {
            id: column

            x: 14
            y: 14
            width: parent.width - 28
            spacing: 4

            Item {
                width: parent.width
                height: 30

                BodyText {
                    id: title

                    objectName: "tour.title"
                    anchors.verticalCenter: parent.verticalCenter
                    text: root.finished ? qsTr("That is all")
                        : root.compact ? `${qsTr("First things")} · ${root.done.indexOf(false) + 1}/${root.tasks.length}` : qsTr("First things")
                    font.pixelSize: Theme.titleSize
                    font.weight: Font.DemiBold
                }
                ToolIconButton {
                    objectName: "tour.leave"
                    anchors { right: parent.right; rightMargin: -6; verticalCenter: parent.verticalCenter }
                    iconName: "close"
                    hint: qsTr("Leave; it is in the Help menu")
                    onClicked: root.leave()
                }
            }
            Repeater {
                id: rows

                model: root.tasks

                T.Button {
                    id: row

                    required property int index
                    required property var modelData
                    readonly property bool isDone: root.done[index]
                    /// The next thing to do says how.
                    readonly property bool isNext: !isDone && !root.done.slice(0, index).includes(false)
                    readonly property bool pointed: hovered || visualFocus

                    objectName: "tour.task." + index
                    visible: !root.compact || isNext || root.finished
                    width: column.width
                    height: Math.max(34, texts.implicitHeight + 14)
                    focusPolicy: Qt.StrongFocus
                    Accessible.name: isDone ? qsTr("%1: done").arg(modelData[0]) : modelData[0] + ". " + modelData[1]
                    onPointedChanged: root.place = pointed ? root.places[index] : null
                    onClicked: root.taskRequested(index)

                    background: Rectangle {
                        radius: Theme.radius
                        color: row.hovered ? Theme.hover : row.isNext ? Theme.sunken : "transparent"

                        Focusable { control: row }
                    }
                    contentItem: Item {
                        Rectangle {
                            x: 8
                            y: 8
                            width: 18
                            height: 18
                            radius: 9
                            color: row.isDone ? Theme.accent : "transparent"
                            border.width: 1.5
                            border.color: row.isDone ? Theme.accent : Theme.muted

                            Icon {
                                anchors.centerIn: parent
                                width: 14
                                height: 14
                                visible: row.isDone
                                name: "check"
                                color: Theme.accentInk
                            }
                        }
                        Column {
                            id: texts

                            x: 36
                            y: 7
                            width: parent.width - 44
                            spacing: 2

                            BodyText {
                                width: parent.width
                                text: row.modelData[0]
                                color: row.isDone ? Theme.muted : Theme.ink
                                font.weight: row.isNext ? Font.DemiBold : Font.Normal
                                wrapMode: Text.WordWrap
                            }
                            Caption {
                                width: parent.width
                                visible: row.isNext
                                text: row.modelData[1]
                                wrapMode: Text.WordWrap
                                lineHeight: 1.15
                            }
                        }
                    }
                }
            }
            Caption {
                width: parent.width
                visible: root.finished
                text: qsTr("Ctrl+S saves the project, F1 opens the guide.")
                wrapMode: Text.WordWrap
            }
        }
    }

    function start(): void {
        root.machineAtStart = root.machineName;
        root.done = [root.hasField, false, false, false];
        root.running = true;
        rows.itemAt(root.hasField ? 1 : 0)?.forceActiveFocus(Qt.OtherFocusReason);
    }
    function tick(task: int, isDone: bool): void {
        if (!root.running || root.done[task] === isDone)
            return;
        const done = [...root.done];
        done[task] = isDone;
        root.done = done;
    }
    function leave(): void {
        root.running = false;
        root.place = null;
        root.seen = true;
    }
}
