import QtQuick
import Furrow.Edit
import Furrow.Files
import Furrow.Map
import Furrow.Plan
import Furrow.Project

/// Gets the value of a setting without typing it: a place that is clicked, a line that is drawn, a file.
Item {
    id: root

    required property Planning planning
    required property ProjectFiles files
    required property MapCamera camera
    /// Of the setting that is asked for.
    property string key: ""
    signal toolRequested(tool: int)

    Connections {
        target: root.planning.steps

        function onPickRequested(key: string, how: int): void {
            root.key = key;
            if (how === ParameterModel.Pick.Place)
                picker.picking = true;
            else if (how === ParameterModel.Pick.Places)
                severalPicker.start();
            else if (how === ParameterModel.Pick.Line)
                root.toolRequested(FieldEditor.Guide);
            else if (how === ParameterModel.Pick.Split)
                root.toolRequested(FieldEditor.Split);
            else if (how === ParameterModel.Pick.File)
                fileDialog.open();
        }
    }
    PlacePicker {
        id: picker

        objectName: "picker"
        anchors.fill: parent
        camera: root.camera
        hint: qsTr("Click the place on the map. Esc ends it.")
        onPicked: place => root.planning.set(root.key, "POINT (%1 %2)".arg(place.longitude.toFixed(8)).arg(place.latitude.toFixed(8)))
    }
    PlacesPicker {
        id: severalPicker

        objectName: "placesPicker"
        anchors.fill: parent
        camera: root.camera
        hint: places.length === 0 ? qsTr("Click the places on the map") : qsTr("Click another place, or one of them to remove it")
        onAdded: place => root.planning.addPoint(root.key, place)
        onRemoved: index => root.planning.removePoint(root.key, index)

        function start(): void {
            refresh();
            picking = true;
        }
        function refresh(): void {
            places = root.planning.pointsOf(root.key);
        }
    }
    Connections {
        target: root.planning
        enabled: severalPicker.picking

        function onSettingsChanged(): void {
            severalPicker.refresh();
        }
    }
    FileChooser {
        id: fileDialog

        objectName: "pickedFileDialog"
        fileMode: FileChooser.OpenFile
        onAccepted: root.planning.set(root.key, root.files.pathOf(selectedFile))
    }
}
