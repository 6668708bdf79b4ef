import QtQuick
import QtQuick.Controls
import Furrow.Files

/// Opening and saving: asks where, and first what becomes of changes that are not saved.
Item {
    id: root

    required property Document document
    required property ProjectFiles files
    required property FieldOpener opener
    /// What comes after the changes are saved or given up.
    property var next: null
    /// Asked before a single project is opened: offer(url, openIt). It may do something else with the file.
    property var offer: (url, openIt) => openIt()

    function open(): void {
        openDialog.open();
    }
    function openUrls(urls: list<url>): void {
        const replaces = urls.some(url => root.opener.isProjectFile(url));
        const openIt = () => root.settleThen(() => root.opener.openUrls(urls));
        if (replaces && urls.length === 1)
            root.offer(urls[0], openIt);
        else if (replaces)
            openIt();
        else
            root.opener.openUrls(urls);
    }
    function startNew(): void {
        root.settleThen(() => root.opener.startNew());
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
        if (!root.document.modified) {
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
    FileChooser {
        id: openDialog

        objectName: "openDialog"
        title: qsTr("Open projects or field boundaries")
        fileMode: FileChooser.OpenFiles
        nameFilters: [qsTr("Projects and field boundaries (%1)").arg("*.furrow *.geojson *.json *.shp *.zip *.kml *.kmz *.gpkg *.gml *.fgb *.wkt *.csv *.xml *.dxf *.gpx *.tif *.tiff *.png *.mbtiles *.log *.nmea *.txt *.mcap *.db3"), qsTr("Projects (%1)").arg("*.furrow"), qsTr("All files (*)")]
        onAccepted: root.openUrls(selectedFiles)
    }
    FileChooser {
        id: saveDialog

        objectName: "saveDialog"
        title: qsTr("Save the project")
        fileMode: FileChooser.SaveFile
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
