import QtQuick
import QtQuick.Controls
import Furrow.Commands
import Furrow.Controls
import Furrow.Guide
import Furrow.Settings
import Furrow.Trouble

/// The dialogs about the program itself: its keys, language and size, a report, about.
Item {
    id: root

    required property AppCommands commands
    required property TroubleReport report
    readonly property alias keys: keysDialog
    readonly property alias preferences: preferencesDialog
    readonly property alias trouble: troubleDialog
    readonly property alias about: aboutDialog
    readonly property alias scaleSetting: scaleSetting

    KeysDialog {
        id: keysDialog

        anchors.centerIn: Overlay.overlay
        commands: root.commands
    }
    TroubleDialog {
        id: troubleDialog

        anchors.centerIn: Overlay.overlay
        report: root.report
    }
    AboutDialog {
        id: aboutDialog

        anchors.centerIn: Overlay.overlay
        version: Application.version
    }
    PreferencesDialog {
        id: preferencesDialog

        anchors.centerIn: Overlay.overlay
    }
    ScaleSetting {
        id: scaleSetting

        onChanged: scaleDialog.open()
    }
    ThemedDialog {
        id: scaleDialog

        objectName: "scaleDialog"
        anchors.centerIn: Overlay.overlay
        title: qsTr("Everything at %1 %").arg(scaleSetting.percent)
        closePolicy: ThemedDialog.CloseOnEscape | ThemedDialog.CloseOnPressOutside

        BodyText {
            width: parent.width
            text: qsTr("This holds from the next start of Furrow.")
            wrapMode: Text.WordWrap
        }
        PushButton {
            objectName: "scaleDialog.close"
            focus: true
            text: qsTr("OK")
            onClicked: scaleDialog.close()
        }
    }
}
