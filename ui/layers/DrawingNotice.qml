import QtQuick
import Furrow.Controls

/// Where Qt draws without OpenGL, the map has neither fields nor plans.
NoticeCard {
    id: root

    property int api: GraphicsInfo.api
    /// Nobody looks at what is drawn off screen.
    readonly property bool isLookedAt: Qt.platform.pluginName !== "offscreen"
    property bool closed: false

    objectName: "drawingNotice"
    visible: api === GraphicsInfo.Software && isLookedAt && !closed
    failed: true
    text: qsTr("The map cannot show fields and plans: this window is drawn without OpenGL.")
    remedy: qsTr("Install a graphics driver with OpenGL; Mesa draws on any processor. The command line plans and exports all the same.")

    PushButton {
        objectName: "drawingNotice.close"
        text: qsTr("OK")
        onClicked: root.closed = true
    }
}
