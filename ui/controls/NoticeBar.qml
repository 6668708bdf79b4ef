import QtQuick

/// A short message that the user should see, with a coloured edge.
Rectangle {
    id: root

    required property string text
    property string remedy: ""
    property bool failed: false
    /// It went well.
    property bool good: false

    implicitWidth: 240
    implicitHeight: column.implicitHeight + 20
    radius: Theme.radius
    color: failed ? Theme.failureGround : good ? Theme.softAccent : Theme.warningGround
    Accessible.role: Accessible.AlertMessage
    Accessible.name: root.text

    Rectangle {
        width: 3
        height: parent.height
        color: root.failed ? Theme.failure : root.good ? Theme.accent : Theme.warning
    }
    Column {
        id: column

        anchors { left: parent.left; right: parent.right; top: parent.top; leftMargin: 14; rightMargin: 12; topMargin: 10 }
        spacing: 4

        BodyText {
            width: parent.width
            text: root.text
            wrapMode: Text.WordWrap
            font.pixelSize: 13
            lineHeight: 1.2
        }
        BodyText {
            width: parent.width
            visible: text.length > 0
            text: root.remedy
            color: Theme.muted
            wrapMode: Text.WordWrap
            font.pixelSize: Theme.labelSize
            lineHeight: 1.2
        }
    }
}
