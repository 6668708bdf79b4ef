pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// The fields of a file, to pick one.
Rectangle {
    id: root

    required property FieldOpener opener

    objectName: "fieldChooser"
    implicitWidth: 440
    radius: 14
    color: Theme.panel
    border.width: Theme.hairline
    border.color: Theme.line

    SoftShadow { radius: root.radius }
    BodyText {
        id: title

        x: 24
        y: 22
        text: qsTr("Which of the %n field(s)?", "", root.opener.choices.count)
        font.pixelSize: 18
        font.weight: Font.DemiBold
    }
    ToolIconButton {
        anchors { right: parent.right; top: parent.top; margins: 14 }
        objectName: "chooser.close"
        iconName: "close"
        hint: qsTr("Open none of them")
        onClicked: root.opener.dropChoices()
    }
    PushButton {
        objectName: "chooser.all"
        anchors { right: parent.right; bottom: parent.bottom; margins: 16 }
        text: qsTr("Open all of them")
        onClicked: root.opener.chooseAll()
    }
    ListView {
        id: list

        anchors { left: parent.left; right: parent.right; top: title.bottom; bottom: parent.bottom; margins: 12; topMargin: 14; bottomMargin: 62 }
        clip: true
        focus: true
        activeFocusOnTab: true
        boundsBehavior: Flickable.StopAtBounds
        model: root.opener.choices
        keyNavigationEnabled: true
        Keys.onReturnPressed: root.opener.chooseField(currentIndex)
        Keys.onEscapePressed: root.opener.dropChoices()

        T.ScrollBar.vertical: T.ScrollBar {
            id: bar

            width: 8
            padding: 2
            contentItem: Rectangle {
                radius: 2
                color: Theme.line
                visible: bar.size < 1
            }
        }

        delegate: T.Button {
            id: row

            required property int index
            required property string name
            required property string area
            required property list<point> outline

            objectName: "chooser.field." + index
            width: list.width
            height: 52
            focusPolicy: Qt.NoFocus
            Accessible.name: qsTr("%1, %2").arg(name).arg(area)
            onClicked: root.opener.chooseField(index)

            background: Rectangle {
                radius: Theme.radius
                color: row.hovered || row.ListView.isCurrentItem && list.activeFocus ? Theme.softAccent : "transparent"
            }
            contentItem: Item {
                FieldThumbnail {
                    x: 12
                    y: 8
                    width: 36
                    height: 36
                    outline: row.outline
                }
                BodyText {
                    anchors { left: parent.left; right: size.left; leftMargin: 62; rightMargin: 12; verticalCenter: parent.verticalCenter }
                    text: row.name
                    elide: Text.ElideRight
                    font.weight: Font.Medium
                }
                BodyText {
                    id: size

                    anchors { right: parent.right; rightMargin: 16; verticalCenter: parent.verticalCenter }
                    text: row.area
                    color: Theme.muted
                }
            }
        }
    }
}
