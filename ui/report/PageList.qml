pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// The pages as they will be printed, one below the other.
EntryFrame {
    id: root

    required property Printing printing
    readonly property alias list: list

    color: Theme.mapGround
    focused: list.activeFocus

    ListView {
        id: list

        objectName: "print.pages"
        anchors { fill: parent; margins: 12 }
        clip: true
        activeFocusOnTab: true
        boundsBehavior: Flickable.StopAtBounds
        spacing: 12
        model: root.printing.pageCount
        keyNavigationEnabled: false
        Accessible.role: Accessible.List
        Accessible.name: qsTr("Pages")
        Keys.onPressed: event => {
            const way = event.key === Qt.Key_Down ? 60 : event.key === Qt.Key_Up ? -60 : event.key === Qt.Key_PageDown ? height - 40 : event.key === Qt.Key_PageUp ? 40 - height : 0;
            if (way !== 0) {
                contentY = Math.max(originY, Math.min(originY + Math.max(0, contentHeight - height), contentY + way));
                event.accepted = true;
            }
        }
        delegate: PagePreview {
            required property int index

            objectName: "print.page." + index
            width: list.width - 12
            height: width * root.printing.pageRatio
            printing: root.printing
            page: index
            Accessible.role: Accessible.Graphic
            Accessible.name: qsTr("Page %1 of %2").arg(index + 1).arg(root.printing.pageCount)
        }
        T.ScrollBar.vertical: T.ScrollBar {
            id: bar

            width: 8
            padding: 1
            contentItem: Rectangle {
                radius: 3
                color: bar.pressed ? Theme.ink : Theme.muted
                visible: list.contentHeight > list.height + 1
            }
        }
    }
    Column {
        anchors.centerIn: parent
        width: parent.width - 48
        visible: root.printing.pageCount === 0 && root.printing.state !== Printing.Idle
        spacing: 12

        BodyText {
            width: parent.width
            text: root.printing.state === Printing.Making ? qsTr("Planning for the pages …") : root.printing.state === Printing.Stopped ? qsTr("Stopped before there were pages.") : ""
            horizontalAlignment: Text.AlignHCenter
            wrapMode: Text.WordWrap
        }
        PushButton {
            objectName: "print.again"
            anchors.horizontalCenter: parent.horizontalCenter
            visible: root.printing.state === Printing.Stopped || root.printing.state === Printing.Failed
            text: qsTr("Try again")
            onClicked: root.printing.again()
        }
    }
}
