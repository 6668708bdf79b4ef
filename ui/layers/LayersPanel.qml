pragma ComponentBehavior: Bound
import QtQuick
import Furrow.Controls

/// What the map shows: layers of the plan, the user's imagery, the map from the network.
Rectangle {
    id: root

    required property ImageryModel imagery
    property real zoomLevel: 3
    property real room: 600
    property bool open: false
    /// Esc is for something else that is open.
    property bool escapeTaken: false
    readonly property alias layers: layers
    signal areaRequested(row: int)
    signal fileRequested()
    signal folderRequested()

    objectName: "layersPanel"
    visible: open
    width: Math.max(340, layers.wanted + 36)
    height: Math.min(room, column.height + 32)
    radius: Theme.cardRadius
    color: Theme.panel
    border.width: Theme.hairline
    border.color: Theme.line
    Accessible.role: Accessible.Pane
    Accessible.name: qsTr("Layers")

    Shortcut {
        enabled: root.open && !root.escapeTaken
        sequences: [StandardKey.Cancel]
        onActivated: root.open = false
    }

    component Title: BodyText {
        font.pixelSize: Theme.titleSize
        font.weight: Font.DemiBold
        topPadding: 14
        bottomPadding: 6
    }

    SoftShadow { radius: root.radius }
    // What is clicked here is not for the map.
    MouseArea {
        anchors.fill: parent
        onWheel: wheel => wheel.accepted = true
    }
    ScrollArea {
        id: flick

        anchors { fill: parent; topMargin: 16; bottomMargin: 16 }
        contentHeight: column.height

        Column {
            id: column

            x: 18
            width: flick.width - 36

            Item {
                width: parent.width
                height: 28

                Title {
                    topPadding: 0
                    text: qsTr("Layers")
                }
                ToolIconButton {
                    objectName: "layersPanel.close"
                    anchors { right: parent.right; rightMargin: -8; top: parent.top; topMargin: -8 }
                    iconName: "close"
                    hint: qsTr("Close the layers")
                    hintBelow: true
                    onClicked: root.open = false
                }
            }
            LayerSwitches {
                id: layers

                width: parent.width
            }
            Title { text: qsTr("Imagery") }
            ImageryList {
                width: parent.width
                imagery: root.imagery
                zoomLevel: root.zoomLevel
                onAreaRequested: row => root.areaRequested(row)
                onFileRequested: root.fileRequested()
                onFolderRequested: root.folderRequested()
            }
            Title { text: qsTr("From the network") }
            CheckRow {
                objectName: "layer.online"
                width: parent.width
                text: qsTr("OpenStreetMap")
                checked: layers.online
                onToggled: layers.online = checked
            }
            Caption {
                x: 26
                width: parent.width - 26
                text: qsTr("Asks openstreetmap.org for what is in view. Off, nothing leaves this computer.")
                wrapMode: Text.WordWrap
                lineHeight: 1.15
            }
        }
    }
}
