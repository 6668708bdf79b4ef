pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Controls
import QtQuick.Dialogs

/// Asks for files or a folder: with the dialog of the desktop where it brings one, with one in the window's look
/// elsewhere.
Item {
    id: root

    enum Mode { OpenFile, OpenFiles, SaveFile, Folder }

    property int fileMode: FileChooser.OpenFile
    property string title: ""
    /// "Projects (*.furrow *.json)"; all files where there are none.
    property list<string> nameFilters
    /// Of names without an ending of their own.
    property string defaultSuffix: ""
    /// What was chosen; before that the name that is suggested.
    property url selectedFile
    property list<url> selectedFiles
    property url selectedFolder
    /// The desktop's dialog is used.
    property bool ofDesktop: browser.desktopDialog
    readonly property FileBrowser browser: FileBrowser { foldersOnly: root.fileMode === FileChooser.Folder }
    signal accepted()
    signal rejected()

    FileWindow {
        id: ours

        parent: Overlay.overlay
        anchors.centerIn: Overlay.overlay
        browser: root.browser
        title: root.title
        nameFilters: root.nameFilters
        defaultSuffix: root.defaultSuffix
        saves: root.fileMode === FileChooser.SaveFile
        takesFolder: root.fileMode === FileChooser.Folder
        several: root.fileMode === FileChooser.OpenFiles
        onTaken: urls => root.take(urls)
        onRejected: root.rejected()
    }
    Loader {
        id: theirs

        property bool asked: false

        active: theirs.asked
        sourceComponent: root.fileMode === FileChooser.Folder ? folderDialog : fileDialog
    }
    Component {
        id: fileDialog

        FileDialog {
            title: root.title
            fileMode: root.fileMode === FileChooser.SaveFile ? FileDialog.SaveFile : root.fileMode === FileChooser.OpenFiles ? FileDialog.OpenFiles : FileDialog.OpenFile
            nameFilters: root.nameFilters
            defaultSuffix: root.defaultSuffix
            onAccepted: root.take(selectedFiles.length > 0 ? selectedFiles : [selectedFile])
            onRejected: root.rejected()
        }
    }
    Component {
        id: folderDialog

        FolderDialog {
            title: root.title
            onAccepted: root.take([selectedFolder])
            onRejected: root.rejected()
        }
    }

    function open(): void {
        if (!root.ofDesktop) {
            ours.begin(root.selectedFile);
            return;
        }
        theirs.asked = true;
        if (root.fileMode === FileChooser.SaveFile)
            theirs.item.selectedFile = root.selectedFile;
        theirs.item.open();
    }
    function take(urls: list<url>): void {
        if (root.fileMode === FileChooser.Folder) {
            root.selectedFolder = urls[0];
        } else {
            root.selectedFiles = urls;
            root.selectedFile = urls[0];
        }
        root.accepted();
    }
}
