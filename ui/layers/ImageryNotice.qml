import QtQuick
import Furrow.Controls

/// Why imagery could not be added.
NoticeCard {
    id: root

    required property ImageryModel imagery

    objectName: "imageryNotice"
    visible: imagery.message.length > 0
    failed: true
    text: imagery.message
    remedy: imagery.remedy

    PushButton {
        objectName: "imageryNotice.close"
        text: qsTr("OK")
        onClicked: root.imagery.dismiss()
    }
}
