import QtQuick
import QtQuick.Layouts
import Furrow.Controls
import Furrow.Plan

Rectangle {
    id: root

    required property PlanSession session
    property bool panelOffered: false
    property bool panelOpen: true
    signal openRequested()
    signal exportRequested()
    signal panelToggled()

    objectName: "topBar"
    implicitHeight: 52
    color: Theme.panel

    Rectangle {
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        height: Theme.hairline
        color: Theme.line
    }
    RowLayout {
        anchors { fill: parent; leftMargin: 16; rightMargin: 12 }
        spacing: 8

        BodyText {
            text: "Furrow"
            color: Theme.accent
            font.pixelSize: 17
            font.weight: Font.Bold
        }
        BodyText {
            Layout.leftMargin: 6
            Layout.maximumWidth: root.width * 0.25
            visible: text.length > 0
            text: root.session.fileName
            color: Theme.muted
            elide: Text.ElideMiddle
        }
        BodyText {
            visible: root.session.fileName.length > 0 && root.session.hasField
            text: "/"
            color: Theme.muted
        }
        BodyText {
            Layout.fillWidth: true
            objectName: "fieldName"
            text: root.session.fieldName
            font.weight: Font.DemiBold
            elide: Text.ElideRight
        }
        ThemeSwitch {}
        ToolIconButton {
            objectName: "panelSwitch"
            visible: root.panelOffered
            iconName: "panel"
            hint: root.panelOpen ? qsTr("Hide the results") : qsTr("Show the results")
            checked: root.panelOpen
            onClicked: root.panelToggled()
        }
        PushButton {
            objectName: "openButton"
            text: qsTr("Open")
            iconName: "open"
            onClicked: root.openRequested()
        }
        PushButton {
            objectName: "exportButton"
            text: qsTr("Export")
            primary: true
            enabled: root.session.hasPlan
            onClicked: root.exportRequested()
        }
    }
}
