import QtQuick
import Furrow.Controls
import Furrow.Text

/// In which language and units this user reads and types. Holds at once.
ThemedDialog {
    id: root

    readonly property list<string> codes: [""].concat(Display.languages)

    objectName: "preferencesDialog"
    title: qsTr("Language and units")
    closePolicy: ThemedDialog.CloseOnEscape | ThemedDialog.CloseOnPressOutside

    Column {
        width: parent.width
        spacing: 5

        Caption { text: qsTr("Language") }
        ChoiceField {
            objectName: "preferences.language"
            width: parent.width
            name: qsTr("Language")
            model: root.codes.map(code => code === "" ? qsTr("Same as this computer") : Display.nameOf(code))
            chosen: root.codes.indexOf(Display.language)
            onActivated: index => Display.language = root.codes[index]
        }
    }
    Column {
        width: parent.width
        spacing: 5

        Caption { text: qsTr("Units") }
        ChoiceField {
            objectName: "preferences.units"
            width: parent.width
            name: qsTr("Units")
            model: [qsTr("Same as this computer"), qsTr("Metres, hectares, km/h"), qsTr("Feet, acres, mph")]
            chosen: Display.units
            onActivated: index => Display.units = index
        }
        Caption {
            width: parent.width
            text: qsTr("Fields take both: 7.3 m, 24 ft, 10'6\", 8 km/h, 5 mph. Files always hold metres.")
            wrapMode: Text.WordWrap
            lineHeight: 1.15
        }
    }
    PushButton {
        objectName: "preferences.close"
        anchors.right: parent.right
        text: qsTr("Close")
        primary: true
        onClicked: root.close()
    }
}
