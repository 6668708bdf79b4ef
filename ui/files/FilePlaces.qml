pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// Where to go from here: home, documents, what is plugged in, folders that were used.
ListView {
    id: root

    required property FileBrowser browser
    readonly property var icons: ({ home: "home", folder: "open", stick: "stick", computer: "computer", recent: "recent" })

    objectName: "files.places"
    clip: true
    boundsBehavior: Flickable.StopAtBounds
    interactive: contentHeight > height
    model: root.browser.places

    delegate: T.Button {
        id: place

        required property int index
        required property var modelData
        readonly property bool here: root.browser.folder === modelData.path

        objectName: "files.place." + modelData.path
        width: root.width
        height: Theme.controlHeight
        focusPolicy: Qt.TabFocus
        Accessible.name: modelData.name
        Accessible.description: modelData.path
        onClicked: root.browser.show(modelData.path)

        background: Rectangle {
            radius: Theme.radius
            color: place.here ? Theme.softAccent : place.hovered ? Theme.hover : "transparent"
            border.width: Theme.sunlight && place.here ? 2 : 0
            border.color: Theme.accent

            Focusable { control: place; gap: 0 }
        }
        contentItem: Item {
            Icon {
                id: icon

                x: 10
                anchors.verticalCenter: parent.verticalCenter
                width: 18
                height: 18
                name: root.icons[place.modelData.kind] ?? "open"
                color: place.here ? Theme.accent : Theme.muted
            }
            BodyText {
                anchors { left: icon.right; right: parent.right; leftMargin: 9; rightMargin: 6; verticalCenter: parent.verticalCenter }
                text: place.modelData.name
                elide: Text.ElideMiddle
            }
        }
    }
}
