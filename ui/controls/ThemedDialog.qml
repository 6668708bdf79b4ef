import QtQuick
import QtQuick.Templates as T

/// A card over the window that asks something; Esc closes it. What does not fit the window scrolls.
T.Popup {
    id: root

    property string title: ""
    default property alias body: column.data
    /// The window's, whatever the dialog stands in.
    readonly property real windowWidth: T.Overlay.overlay ? T.Overlay.overlay.width : 1280
    readonly property real windowHeight: T.Overlay.overlay ? T.Overlay.overlay.height : 0

    modal: true
    focus: true
    width: 440
    implicitHeight: contentItem.implicitHeight + 2 * padding
    height: windowHeight > 0 ? Math.min(implicitHeight, windowHeight - 16) : implicitHeight
    padding: 24
    closePolicy: T.Popup.CloseOnEscape

    T.Overlay.modal: Rectangle { color: "#66000000" }
    enter: Transition {
        NumberAnimation { property: "opacity"; from: 0; to: 1; duration: Theme.motion }
    }
    background: Rectangle {
        radius: 14
        color: Theme.panel
        border.width: Theme.hairline
        border.color: Theme.line
    }
    contentItem: FocusScope {
        implicitHeight: column.implicitHeight
        focus: true
        Accessible.role: Accessible.Dialog
        Accessible.name: root.title
        Keys.onPressed: event => {
            const way = event.key === Qt.Key_Down ? 40 : event.key === Qt.Key_Up ? -40 : event.key === Qt.Key_PageDown ? scroller.height - 40 : event.key === Qt.Key_PageUp ? 40 - scroller.height : 0;
            if (way !== 0 && scroller.interactive) {
                scroller.scrollBy(way);
                event.accepted = true;
            }
        }

        ScrollArea {
            id: scroller

            // The bar has its place in the padding; frames of what has the keys are not cut off.
            anchors { fill: parent; leftMargin: -4; rightMargin: -16; topMargin: -4; bottomMargin: -4 }
            contentHeight: column.implicitHeight + 8

            Column {
                id: column

                x: 4
                y: 4
                width: scroller.width - 20
                spacing: 14

                BodyText {
                    width: parent.width
                    text: root.title
                    font.pixelSize: 18
                    font.weight: Font.DemiBold
                    wrapMode: Text.WordWrap
                }
            }
        }
    }
}
