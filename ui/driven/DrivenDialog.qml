import QtQuick
import QtQuick.Dialogs

/// Asks for a recorded track.
FileDialog {
    id: root

    required property DrivenTrack track

    objectName: "drivenDialog"
    title: qsTr("Open a recorded track")
    fileMode: FileDialog.OpenFile
    nameFilters: [qsTr("Recorded tracks (%1)").arg("*.gpx *.csv *.txt *.log *.nmea *.json *.zip *.xml *.XML *.mcap *.db3"), qsTr("All files (*)")]
    onAccepted: root.track.open(selectedFile)
}
