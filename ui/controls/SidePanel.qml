import QtQuick

/// A panel in the place of the results: a title, what it holds, a cross; Esc closes it wherever the keys are.
Rectangle {
    id: root

    required property string title
    /// Of the cross.
    property string closeName: ""
    readonly property real bodyWidth: width - 40
    default property alias body: column.data
    signal closeRequested()

    implicitWidth: 340
    color: Theme.panel

    Shortcut {
        enabled: root.visible
        sequences: [StandardKey.Cancel]
        onActivated: root.closeRequested()
    }
    Rectangle {
        anchors { left: parent.left; top: parent.top; bottom: parent.bottom }
        width: Theme.hairline
        color: Theme.line
    }
    ScrollArea {
        anchors { fill: parent; leftMargin: 20; topMargin: 12; bottomMargin: 12 }
        contentHeight: column.implicitHeight

        Column {
            id: column

            width: root.bodyWidth
            spacing: 12

            Item {
                width: parent.width
                height: 38

                BodyText {
                    anchors.verticalCenter: parent.verticalCenter
                    text: root.title
                    font.pixelSize: 18
                    font.weight: Font.DemiBold
                }
                ToolIconButton {
                    objectName: root.closeName
                    anchors { right: parent.right; verticalCenter: parent.verticalCenter }
                    iconName: "close"
                    hint: qsTr("Back to the plan (Esc)")
                    hintBelow: true
                    onClicked: root.closeRequested()
                }
            }
        }
    }
}
