import QtQuick
import QtQuick.Controls
import QtQuick.Dialogs
import Furrow.Controls
import Furrow.Document
import Furrow.Plan

/// Opening and saving: asks where, and first what becomes of changes that are not saved.
Item {
    id: root

    required property PlanSession session
    readonly property ProjectFiles files: session.files
    /// What comes after the changes are saved or given up.
    property var next: null

    function open(): void {
        openDialog.open();
    }
    function openUrls(urls: list<url>): void {
        const replaces = urls.some(url => root.session.isProjectFile(url));
        if (replaces)
            root.settleThen(() => root.session.openUrls(urls));
        else
            root.session.openUrls(urls);
    }
    function addImagery(): void {
        imageryDialog.open();
    }
    function addTileFolder(): void {
        tileFolderDialog.open();
    }
    function startNew(): void {
        root.settleThen(() => root.session.closeField());
    }
    function save(): void {
        if (root.files.path.length > 0)
            root.files.save();
        else
            root.saveAs();
    }
    function saveAs(): void {
        saveDialog.selectedFile = root.files.suggestedFile();
        saveDialog.open();
    }
    /// Runs `action` when nothing is left unsaved.
    function settleThen(action: var): void {
        if (!root.session.document.modified) {
            action();
            return;
        }
        root.next = action;
        unsavedDialog.open();
    }
    function goOn(): void {
        const action = root.next;
        root.next = null;
        if (action)
            action();
    }

    UnsavedDialog {
        id: unsavedDialog

        anchors.centerIn: Overlay.overlay
        name: root.files.name
        onSaveChosen: root.save()
        onDiscardChosen: {
            root.files.discardChanges();
            root.goOn();
        }
    }
    FileDialog {
        id: openDialog

        objectName: "openDialog"
        title: qsTr("Open projects or field boundaries")
        fileMode: FileDialog.OpenFiles
        nameFilters: [qsTr("Projects and field boundaries (%1)").arg("*.furrow *.geojson *.json *.shp *.zip *.kml *.kmz *.gpkg *.gml *.fgb *.wkt *.csv *.xml *.dxf *.gpx *.tif *.tiff *.png *.mbtiles"), qsTr("Projects (%1)").arg("*.furrow"), qsTr("All files (*)")]
        onAccepted: root.openUrls(selectedFiles)
    }
    FileDialog {
        id: imageryDialog

        objectName: "imageryDialog"
        title: qsTr("Add imagery")
        fileMode: FileDialog.OpenFiles
        nameFilters: [qsTr("Pictures and heights (%1)").arg("*.tif *.tiff *.mbtiles *.gpkg *.jp2 *.png *.jpg *.jpeg *.webp *.asc *.hgt *.dt0 *.dt1 *.dt2"), qsTr("All files (*)")]
        onAccepted: root.session.imagery.addUrls(selectedFiles)
    }
    FolderDialog {
        id: tileFolderDialog

        objectName: "tileFolderDialog"
        title: qsTr("Add a folder of tiles")
        onAccepted: root.session.imagery.addUrls([selectedFolder])
    }
    FileDialog {
        id: saveDialog

        objectName: "saveDialog"
        title: qsTr("Save the project")
        fileMode: FileDialog.SaveFile
        defaultSuffix: "furrow"
        nameFilters: [qsTr("Projects (%1)").arg("*.furrow")]
        onAccepted: root.files.saveAs(selectedFile)
        onRejected: root.next = null
    }
    Connections {
        target: root.files

        function onSaved(): void {
            root.goOn();
        }
    }
}
