import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// Asks for a name, and for a season where that belongs to it.
ThemedDialog {
    id: root

    property bool asksSeason: false
    signal named(name: string, season: string)

    objectName: "nameDialog"

    Column {
        width: parent.width
        spacing: 5

        Caption { text: qsTr("Name") }
        TextEntry {
            id: nameEntry

            objectName: "nameDialog.name"
            width: parent.width
            focus: true
            name: qsTr("Name")
            onAccepted: root.finish()
        }
    }
    Column {
        width: parent.width
        spacing: 5
        visible: root.asksSeason

        Caption { text: qsTr("Season") }
        TextEntry {
            id: seasonEntry

            objectName: "nameDialog.season"
            width: parent.width
            name: qsTr("Season")
            onAccepted: root.finish()
        }
    }
    Row {
        anchors.right: parent.right
        spacing: 8

        PushButton {
            text: qsTr("Cancel")
            onClicked: root.close()
        }
        PushButton {
            objectName: "nameDialog.ok"
            text: qsTr("OK")
            primary: true
            enabled: nameEntry.text.trim().length > 0
            onClicked: root.finish()
        }
    }

    function ask(title: string, name: string, season: string, withSeason: bool): void {
        root.title = title;
        root.asksSeason = withSeason;
        root.open();
        nameEntry.text = name;
        seasonEntry.text = season;
        nameEntry.forceActiveFocus();
        nameEntry.selectAll();
    }
    function finish(): void {
        if (nameEntry.text.trim().length === 0)
            return;
        root.close();
        root.named(nameEntry.text, seasonEntry.text);
    }
}
