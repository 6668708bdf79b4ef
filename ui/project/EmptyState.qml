pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// What to do when there is no field yet. What does not fit scrolls.
Rectangle {
    id: root

    required property FieldOpener opener
    required property RecentFiles recent
    signal openRequested()
    signal drawRequested()
    signal projectRequested(path: string)

    objectName: "emptyState"
    implicitWidth: 420
    implicitHeight: column.height + 56
    radius: 14
    color: Theme.panel
    border.width: Theme.hairline
    border.color: Theme.line

    SoftShadow { radius: root.radius }
    ScrollArea {
        anchors { fill: parent; topMargin: 1; bottomMargin: 1 }
        contentHeight: column.height + 54

        Column {
            id: column

            x: 28
            y: 27
            width: root.width - 56
            spacing: 14

            BodyText {
                text: qsTr("Which field?")
                font.pixelSize: 22
                font.weight: Font.DemiBold
            }
            BodyText {
                width: parent.width
                text: qsTr("Open its boundary, or drop the file anywhere on this window. Shapefile, GeoJSON, KML, GeoPackage, GML and others are understood, zipped or not.")
                color: Theme.muted
                wrapMode: Text.WordWrap
                lineHeight: 1.25
            }
            Row {
                width: parent.width
                topPadding: 4
                spacing: 12

                PushButton {
                    objectName: "empty.open"
                    width: (parent.width - 12) / 2
                    height: 40
                    primary: true
                    iconName: "open"
                    text: qsTr("Open a file…")
                    onClicked: root.openRequested()
                }
                PushButton {
                    objectName: "empty.draw"
                    width: (parent.width - 12) / 2
                    height: 40
                    iconName: "draw"
                    text: qsTr("Draw it")
                    onClicked: root.drawRequested()
                }
            }
            RecentProjects {
                width: parent.width
                recent: root.recent
                onChosen: path => root.projectRequested(path)
            }
            Column {
                width: parent.width
                topPadding: 8
                spacing: 2
                visible: root.opener.sampleNames.length > 0

                Caption {
                    text: qsTr("Or try one of these")
                    bottomPadding: 4
                }
                Repeater {
                    model: root.opener.sampleNames

                    T.Button {
                        id: sample

                        required property int index
                        required property string modelData

                        objectName: "empty.sample." + index
                        width: column.width
                        height: 34
                        focusPolicy: Qt.StrongFocus
                        Accessible.name: qsTr("Sample field %1").arg(modelData)
                        onClicked: root.opener.openSample(index)

                        background: Rectangle {
                            anchors.fill: parent
                            anchors.leftMargin: -8
                            anchors.rightMargin: -8
                            radius: Theme.radius
                            color: sample.hovered ? Theme.softAccent : "transparent"

                            Focusable { control: sample; gap: 0 }
                        }
                        contentItem: Item {
                            Icon {
                                id: icon

                                anchors.verticalCenter: parent.verticalCenter
                                name: "sample"
                                color: Theme.accent
                            }
                            BodyText {
                                anchors { left: icon.right; leftMargin: 10; verticalCenter: parent.verticalCenter }
                                text: sample.modelData
                            }
                            Icon {
                                anchors { right: parent.right; verticalCenter: parent.verticalCenter }
                                width: 16
                                height: 16
                                name: "chevron-right"
                                color: Theme.muted
                            }
                        }
                    }
                }
            }
        }
    }
}
