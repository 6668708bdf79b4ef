import QtQuick
import Furrow.Files

/// Asks which imagery is to be laid below the plan.
Item {
    id: root

    required property ImageryModel imagery

    function addFiles(): void {
        imageryDialog.open();
    }
    function addTileFolder(): void {
        tileFolderDialog.open();
    }

    FileChooser {
        id: imageryDialog

        objectName: "imageryDialog"
        title: qsTr("Add imagery")
        fileMode: FileChooser.OpenFiles
        nameFilters: [qsTr("Pictures and heights (%1)").arg("*.tif *.tiff *.mbtiles *.gpkg *.jp2 *.png *.jpg *.jpeg *.webp *.asc *.hgt *.dt0 *.dt1 *.dt2"), qsTr("All files (*)")]
        onAccepted: root.imagery.addUrls(selectedFiles)
    }
    FileChooser {
        id: tileFolderDialog

        objectName: "tileFolderDialog"
        fileMode: FileChooser.Folder
        title: qsTr("Add a folder of tiles")
        onAccepted: root.imagery.addUrls([selectedFolder])
    }
}
