import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// What is to become of changes that are not saved, before something else begins.
ThemedDialog {
    id: root

    required property string name
    signal saveChosen()
    signal discardChosen()

    objectName: "unsavedDialog"
    title: name.length > 0 ? qsTr("Save the changes of “%1”?").arg(name) : qsTr("Save your work?")
    onOpened: saveButton.forceActiveFocus()

    Row {
        anchors.right: parent.right
        topPadding: 8
        spacing: 8

        PushButton {
            objectName: "unsaved.cancel"
            text: qsTr("Cancel")
            onClicked: root.close()
        }
        PushButton {
            objectName: "unsaved.discard"
            text: qsTr("Do not save")
            onClicked: {
                root.close();
                root.discardChosen();
            }
        }
        PushButton {
            id: saveButton

            objectName: "unsaved.save"
            text: qsTr("Save")
            primary: true
            onClicked: {
                root.close();
                root.saveChosen();
            }
        }
    }
}
