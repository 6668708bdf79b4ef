pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T

/// A choice among a few names.
T.ComboBox {
    id: root

    /// What is chosen here, for screen readers.
    required property string name
    /// Which of them it is; holds when the names become others, as in another language.
    property int chosen: 0

    implicitWidth: 200
    implicitHeight: Theme.controlHeight
    leftPadding: 12
    rightPadding: 32
    focusPolicy: Qt.StrongFocus
    font.family: Theme.family
    font.pixelSize: Theme.bodySize
    wheelEnabled: false
    currentIndex: root.chosen
    onModelChanged: root.currentIndex = Qt.binding(() => root.chosen)
    Accessible.name: root.name

    background: Rectangle {
        radius: Theme.radius
        color: root.hovered || root.popup.visible ? Theme.hover : Theme.panel
        border.width: Theme.hairline
        border.color: root.popup.visible ? Theme.accent : Theme.line

        Focusable { control: root }
    }
    contentItem: BodyText {
        text: root.displayText
        verticalAlignment: Text.AlignVCenter
        elide: Text.ElideRight
    }
    indicator: Icon {
        x: root.width - width - 10
        y: (root.height - height) / 2
        width: 16
        height: 16
        name: "chevron-down"
        color: Theme.muted
    }
    delegate: T.ItemDelegate {
        id: option

        required property int index

        width: root.popup.width - 8
        implicitHeight: 32
        highlighted: root.highlightedIndex === index
        text: root.textAt(index)
        background: Rectangle {
            radius: 6
            color: option.highlighted ? Theme.softAccent : "transparent"
        }
        contentItem: Item {
            BodyText {
                anchors { left: parent.left; right: mark.left; verticalCenter: parent.verticalCenter; leftMargin: 8 }
                text: option.text
                elide: Text.ElideRight
            }
            Icon {
                id: mark

                anchors { right: parent.right; verticalCenter: parent.verticalCenter; rightMargin: 6 }
                width: 16
                height: 16
                name: "check"
                color: Theme.accent
                visible: root.currentIndex === option.index
            }
        }
    }
    popup: T.Popup {
        y: root.height + 4
        width: root.width
        implicitHeight: Math.min(contentItem.implicitHeight + 8, 320)
        padding: 4
        enter: Transition {
            NumberAnimation { property: "opacity"; from: 0; to: 1; duration: Theme.motion }
        }
        background: Rectangle {
            radius: Theme.radius
            color: Theme.panel
            border.width: Theme.hairline
            border.color: Theme.line
        }
        contentItem: ListView {
            clip: true
            implicitHeight: contentHeight
            model: root.delegateModel
            currentIndex: root.highlightedIndex
            boundsBehavior: Flickable.StopAtBounds
        }
    }
}
