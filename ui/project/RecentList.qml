pragma ComponentBehavior: Bound
import QtQuick
import Furrow.Controls

/// The menu of projects that were open last.
ThemedMenu {
    id: root

    required property RecentFiles recent
    signal chosen(path: string)

    objectName: "menu.recent"
    title: qsTr("Open recent")
    enabled: recent.count > 0

    Instantiator {
        model: root.recent
        delegate: ThemedMenuItem {
            required property int index
            required property string path
            required property string name
            required property string folder

            objectName: "recent." + index
            text: qsTr("%1 — %2").arg(name).arg(folder)
            onTriggered: root.chosen(path)
        }
        onObjectAdded: (index, object) => root.insertItem(index, object as ThemedMenuItem)
        onObjectRemoved: (index, object) => root.removeItem(object as ThemedMenuItem)
    }
}
