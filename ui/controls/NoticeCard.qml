import QtQuick

/// Something that happened, on a card over the map: what, what helps, and buttons.
Rectangle {
    id: root

    required property string text
    property string remedy: ""
    property bool failed: false
    /// The buttons.
    default property alias buttons: row.data

    width: 400
    height: column.height + 28
    radius: Theme.cardRadius
    color: Theme.panel
    border.width: Theme.hairline
    border.color: failed ? Theme.failure : Theme.line
    Accessible.role: Accessible.AlertMessage
    Accessible.name: root.text

    SoftShadow { radius: root.radius }
    Column {
        id: column

        x: 16
        y: 14
        width: parent.width - 32
        spacing: 8

        BodyText {
            objectName: root.objectName + ".text"
            width: parent.width
            text: root.text
            font.weight: Font.DemiBold
            wrapMode: Text.Wrap
            lineHeight: 1.15
        }
        BodyText {
            width: parent.width
            visible: text.length > 0
            text: root.remedy
            wrapMode: Text.WordWrap
            lineHeight: 1.15
        }
        Flow {
            id: row

            width: parent.width
            spacing: 8
            topPadding: 2
        }
    }
}
