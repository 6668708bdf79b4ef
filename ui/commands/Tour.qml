pragma ComponentBehavior: Bound
import QtQuick
import QtCore
import Furrow.Controls
import Furrow.Project

/// Shows where things are: a card with a few sentences for each part of the window, which gets a frame meanwhile.
/// Nothing is locked; it can be left at any step.
Item {
    id: root

    required property FarmModel farm
    required property FieldOpener opener
    /// What each page is about; null for the window as a whole.
    required property list<Item> places
    property int page: -1
    /// It was shown before, to the end or not.
    property bool seen: false
    readonly property bool running: page >= 0
    readonly property Item place: running ? places[page] : null
    readonly property list<var> pages: [
        [qsTr("Welcome to Furrow"), qsTr("In three minutes from a field to a plan that can be driven. A sample field is opened for you; Ctrl+Z takes everything back. Leave whenever you like: the tour is in the Help menu.")],
        [qsTr("The steps"), qsTr("From top to bottom: the field, the machine, and how it works. Each step says what is chosen and what came of it; press one to change it. Every change plans anew at once.")],
        [qsTr("The map"), qsTr("Drag a corner of the field and watch the plan follow. The wheel zooms, dragging the ground moves the map. The dot in the middle of an edge makes another corner; Alt lets go of what catches.")],
        [qsTr("The tools"), qsTr("Draw a field, a hole, an obstacle, an AB line or a gate. The lowest button shows the layers: what is drawn of the plan, and your own aerial photos or heights beneath it.")],
        [qsTr("What came out"), qsTr("Area, way and time, and what was found: press a finding and the map goes there. Findings in the way of driving come first, with what would help.")],
        [qsTr("To the terminal"), qsTr("Export writes the plan to a folder or a USB stick, for many terminals, reads it back and compares it. Then save the project: Ctrl+S. Ctrl+K finds every command by name.")]
    ]

    objectName: "tour"
    visible: running
    Keys.onEscapePressed: root.leave()

    readonly property Settings stored: Settings {
        category: "tour"
        property alias seen: root.seen
    }

    // The frame.
    Rectangle {
        readonly property point corner: root.place && root.width > 0 && root.height > 0 ? root.place.mapToItem(root, 0, 0) : Qt.point(0, 0)

        visible: root.place !== null && root.place.visible
        x: corner.x + 3
        y: corner.y + 3
        width: root.place ? root.place.width - 6 : 0
        height: root.place ? root.place.height - 6 : 0
        radius: Theme.cardRadius
        color: "transparent"
        border.width: 3
        border.color: Theme.accent
    }
    Rectangle {
        id: card

        objectName: "tour.card"
        // Beside what it speaks about where that is narrow and on the left, otherwise in the middle.
        readonly property real beside: root.place && root.place.width < 400 && root.width > 0 && root.place.mapToItem(root, 0, 0).x < root.width / 2 ? root.place.mapToItem(root, root.place.width, 0).x + 16 : 0

        x: Math.min(Math.max((parent.width - width) / 2, beside), parent.width - width - 16)
        anchors { bottom: parent.bottom; bottomMargin: 28 }
        width: Math.min(480, parent.width - 32)
        height: column.height + 40
        radius: 14
        color: Theme.panel
        border.width: Theme.hairline
        border.color: Theme.line
        Accessible.role: Accessible.Dialog
        Accessible.name: title.text
        Accessible.description: text.text

        SoftShadow { radius: card.radius }
        MouseArea { anchors.fill: parent }
        Column {
            id: column

            x: 24
            y: 20
            width: parent.width - 48
            spacing: 10

            BodyText {
                id: title

                objectName: "tour.title"
                width: parent.width
                text: root.running ? root.pages[root.page][0] : ""
                font.pixelSize: 18
                font.weight: Font.DemiBold
            }
            BodyText {
                id: text

                width: parent.width
                text: root.running ? root.pages[root.page][1] : ""
                wrapMode: Text.WordWrap
                lineHeight: 1.25
            }
            Item {
                width: parent.width
                height: Theme.controlHeight

                Caption {
                    anchors.verticalCenter: parent.verticalCenter
                    text: qsTr("%1 of %2").arg(root.page + 1).arg(root.pages.length)
                }
                Row {
                    anchors.right: parent.right
                    spacing: 8

                    PushButton {
                        objectName: "tour.leave"
                        text: qsTr("Leave")
                        visible: root.page + 1 < root.pages.length
                        onClicked: root.leave()
                    }
                    PushButton {
                        objectName: "tour.back"
                        text: qsTr("Back")
                        visible: root.page > 0
                        onClicked: root.page -= 1
                    }
                    PushButton {
                        id: next

                        objectName: "tour.next"
                        text: root.page + 1 < root.pages.length ? qsTr("Next") : qsTr("Done")
                        primary: true
                        onClicked: root.goOn()
                    }
                }
            }
        }
    }

    function start(): void {
        root.page = 0;
        next.forceActiveFocus();
    }
    function leave(): void {
        root.page = -1;
        root.seen = true;
    }
    function goOn(): void {
        if (root.page === 0 && !root.farm.hasField)
            root.opener.openSample(Math.max(0, root.opener.sampleNames.indexOf("Home Field")));
        if (root.page + 1 < root.pages.length)
            root.page += 1;
        else
            root.leave();
    }
}
