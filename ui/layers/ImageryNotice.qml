import QtQuick
import Furrow.Controls

/// Why imagery could not be added.
Rectangle {
    id: root

    required property ImageryModel imagery

    objectName: "imageryNotice"
    visible: imagery.message.length > 0
    width: 420
    height: column.height + 28
    radius: Theme.cardRadius
    color: Theme.panel
    border.width: Theme.hairline
    border.color: Theme.failure
    Accessible.role: Accessible.AlertMessage
    Accessible.name: root.imagery.message

    SoftShadow { radius: root.radius }
    Column {
        id: column

        x: 16
        y: 14
        width: parent.width - 32
        spacing: 8

        BodyText {
            objectName: "imageryNotice.text"
            width: parent.width
            text: root.imagery.message
            font.weight: Font.DemiBold
            wrapMode: Text.Wrap
            lineHeight: 1.15
        }
        BodyText {
            width: parent.width
            visible: text.length > 0
            text: root.imagery.remedy
            wrapMode: Text.WordWrap
            lineHeight: 1.15
        }
        PushButton {
            objectName: "imageryNotice.close"
            text: qsTr("OK")
            onClicked: root.imagery.dismiss()
        }
    }
}
