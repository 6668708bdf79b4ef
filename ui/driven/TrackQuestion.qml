import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// What a recording is for that came without a word of it.
ThemedDialog {
    id: root

    required property FieldFromTrack source

    objectName: "trackQuestion"
    title: qsTr("“%1” is a recorded track").arg(root.source.name)
    closePolicy: T.Popup.CloseOnEscape
    onOpened: makeButton.forceActiveFocus()
    onClosed: {
        if (root.source.asking)
            root.source.close();
    }

    Caption {
        width: parent.width
        text: root.source.recording
        wrapMode: Text.WordWrap
    }
    BodyText {
        width: parent.width
        text: qsTr("It can become a field, or be laid over the plan to see how far beside it was driven.")
        wrapMode: Text.WordWrap
        lineHeight: 1.2
    }
    Flow {
        width: parent.width
        spacing: 8

        PushButton {
            id: makeButton

            objectName: "trackQuestion.make"
            primary: true
            text: qsTr("Make a field from it")
            onClicked: {
                root.source.make();
                root.close();
            }
        }
        PushButton {
            objectName: "trackQuestion.lay"
            text: qsTr("Lay it over the plan")
            onClicked: {
                root.source.layOver();
                root.close();
            }
        }
        PushButton {
            objectName: "trackQuestion.cancel"
            text: qsTr("Cancel")
            onClicked: root.close()
        }
    }

    Connections {
        target: root.source

        function onChanged(): void {
            if (root.source.asking && !root.opened)
                root.open();
        }
    }
}
