pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// The projects that were open last, each with the outline of its field.
Column {
    id: root

    required property RecentFiles recent
    readonly property int most: 4
    signal chosen(path: string)

    topPadding: 8
    spacing: 2
    visible: recent.count > 0

    Caption {
        text: qsTr("Go on with")
        bottomPadding: 4
    }
    Repeater {
        model: root.recent

        T.Button {
            id: row

            required property int index
            required property string path
            required property string name
            required property string folder
            required property string fields
            required property list<point> outline

            objectName: "empty.recent." + index
            visible: index < root.most
            width: root.width
            height: visible ? 46 : 0
            focusPolicy: Qt.StrongFocus
            Accessible.name: qsTr("Project %1 in %2, %3").arg(name).arg(folder).arg(fields)
            onClicked: root.chosen(path)

            background: Rectangle {
                anchors.fill: parent
                anchors.leftMargin: -8
                anchors.rightMargin: -8
                radius: Theme.radius
                color: row.hovered ? Theme.softAccent : "transparent"

                Focusable { control: row; gap: 0 }
            }
            contentItem: Item {
                FieldThumbnail {
                    y: 6
                    width: 34
                    height: 34
                    outline: row.outline
                }
                Column {
                    anchors { left: parent.left; leftMargin: 48; right: parent.right; verticalCenter: parent.verticalCenter }

                    BodyText {
                        width: parent.width
                        text: row.name
                        elide: Text.ElideRight
                        font.weight: Font.Medium
                    }
                    Caption {
                        width: parent.width
                        text: qsTr("%1 · %2").arg(row.fields).arg(row.folder)
                        elide: Text.ElideMiddle
                    }
                }
            }
        }
    }
}
