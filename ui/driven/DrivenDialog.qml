import QtQuick
import Furrow.Files

/// Asks for a recorded track, to be laid over the plan or to make a field from it.
FileChooser {
    id: root

    required property DrivenTrack track
    required property FieldFromTrack source
    /// What the track is for.
    property bool forField: false

    objectName: "drivenDialog"
    title: qsTr("Open a recorded track")
    fileMode: FileChooser.OpenFile
    nameFilters: [qsTr("Recorded tracks (%1)").arg("*.gpx *.csv *.txt *.log *.nmea *.json *.zip *.xml *.XML *.mcap *.db3"), qsTr("All files (*)")]
    onAccepted: root.forField ? root.source.open(selectedFile) : root.track.open(selectedFile)
}
