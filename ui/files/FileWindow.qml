pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// The file dialog in the window's look: places, the files of a folder, and a name. It makes no folder and writes
/// over no file without being told so.
T.Popup {
    id: root

    required property FileBrowser browser
    required property string title
    required property list<string> nameFilters
    required property string defaultSuffix
    /// What is asked for; neither: a file to open, or several.
    required property bool saves
    required property bool takesFolder
    required property bool several
    readonly property bool roomForPlaces: width > 620
    /// What is asked before it goes on.
    property int asks: FileWindow.Nothing
    /// What that is about.
    property string about: ""
    /// What is wrong with what was typed.
    property string complaint: ""
    property bool done: false
    signal taken(urls: list<url>)
    signal rejected()

    enum Asks { Nothing, Replace, MakeFolder, NewFolder }

    objectName: "fileWindow"
    modal: true
    focus: true
    padding: 20
    width: Math.min(880, parent ? parent.width - 24 : 880)
    height: Math.min(620, parent ? parent.height - 24 : 620)
    closePolicy: T.Popup.CloseOnEscape
    onOpened: root.saves ? nameField.forceActiveFocus() : files.focusList()
    onClosed: {
        root.browser.watching = false;
        if (!root.done)
            root.rejected();
    }

    T.Overlay.modal: Rectangle { color: "#66000000" }
    background: Rectangle {
        radius: 14
        color: Theme.panel
        border.width: Theme.hairline
        border.color: Theme.line
    }
    contentItem: FocusScope {
        focus: true
        Accessible.role: Accessible.Dialog
        Accessible.name: root.title

        BodyText {
            id: heading

            width: parent.width
            text: root.title
            font.pixelSize: 18
            font.weight: Font.DemiBold
            elide: Text.ElideRight
        }
        Row {
            id: pathRow

            anchors { left: parent.left; right: parent.right; top: heading.bottom; topMargin: 10 }
            spacing: 8

            ToolIconButton {
                objectName: "files.up"
                height: Theme.controlHeight
                enabled: root.browser.canGoUp
                iconName: "chevron-up"
                hint: qsTr("The folder around it (Backspace)")
                hintBelow: true
                onClicked: files.goUp()
            }
            TextEntry {
                id: pathField

                objectName: "files.path"
                width: parent.width - 38 - 8 - newFolder.width - 8
                name: qsTr("Folder")
                value: root.browser.folder
                // Only by Return: whoever leaves it, as to cancel, has not asked to go there.
                onAccepted: root.goTo(text)
                onActiveFocusChanged: {
                    if (!activeFocus)
                        text = value;
                }
            }
            PushButton {
                id: newFolder

                objectName: "files.newFolder"
                text: qsTr("New folder…")
                onClicked: root.ask(FileWindow.NewFolder, "")
            }
        }
        FilePlaces {
            id: places

            anchors { left: parent.left; top: pathRow.bottom; bottom: below.top; topMargin: 12; bottomMargin: 12 }
            width: root.roomForPlaces ? 176 : 0
            visible: root.roomForPlaces
            browser: root.browser
        }
        Rectangle {
            anchors { left: places.right; right: parent.right; top: pathRow.bottom; bottom: below.top; leftMargin: root.roomForPlaces ? 12 : 0; topMargin: 12; bottomMargin: 12 }
            radius: Theme.radius
            color: Theme.panel
            border.width: Theme.hairline
            border.color: Theme.line

            FileList {
                id: files

                anchors { fill: parent; margins: 4 }
                browser: root.browser
                several: root.several
                onTaken: root.takeFromList()
                onPathBegun: text => root.typePath(text)
                onChosenChanged: {
                    root.asks = FileWindow.Nothing;
                    root.complaint = "";
                    if (root.saves && chosen.length === 1 && !root.browser.isFolderAt(root.browser.rowOf(root.browser.nameOf(chosen[0]))))
                        nameField.text = root.browser.nameOf(chosen[0]);
                }
            }
        }
        Column {
            id: below

            anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
            spacing: 10

            Rectangle {
                objectName: "files.question"
                width: parent.width
                height: Math.max(told.implicitHeight + 20, 50)
                visible: root.asks !== FileWindow.Nothing || root.complaint.length > 0
                radius: Theme.radius
                color: root.asks === FileWindow.Nothing ? Theme.failureGround : Theme.warningGround
                border.width: Theme.sunlight ? 2 : 0
                border.color: Theme.line
                Accessible.role: Accessible.AlertMessage
                Accessible.name: told.text

                BodyText {
                    id: told

                    objectName: "files.told"
                    anchors { left: parent.left; right: answers.left; leftMargin: 12; rightMargin: 8; verticalCenter: parent.verticalCenter }
                    text: root.asks === FileWindow.Replace ? qsTr("“%1” is already there. Write over it?").arg(root.browser.nameOf(root.about))
                        : root.asks === FileWindow.MakeFolder ? qsTr("There is no folder “%1”. Make it?").arg(root.about)
                        : root.asks === FileWindow.NewFolder ? qsTr("Name of the new folder") : root.complaint
                    color: root.asks === FileWindow.Nothing ? Theme.failure : Theme.ink
                    wrapMode: Text.Wrap
                }
                Row {
                    id: answers

                    anchors { right: parent.right; rightMargin: 8; verticalCenter: parent.verticalCenter }
                    spacing: 8
                    visible: root.asks !== FileWindow.Nothing

                    TextEntry {
                        id: folderName

                        objectName: "files.folderName"
                        visible: root.asks === FileWindow.NewFolder
                        width: 200
                        name: qsTr("Name of the new folder")
                        onAccepted: root.answer()
                        Keys.onEscapePressed: root.takeBack()
                    }
                    PushButton {
                        id: no

                        objectName: "files.no"
                        text: qsTr("No")
                        onClicked: root.takeBack()
                    }
                    PushButton {
                        objectName: "files.yes"
                        primary: true
                        text: root.asks === FileWindow.Replace ? qsTr("Write over it") : qsTr("Make the folder")
                        onClicked: root.answer()
                    }
                }
            }
            Row {
                width: parent.width
                spacing: 8

                BodyText {
                    id: nameLabel

                    visible: root.saves
                    height: Theme.controlHeight
                    verticalAlignment: Text.AlignVCenter
                    text: qsTr("Name")
                    color: Theme.muted
                }
                TextEntry {
                    id: nameField

                    objectName: "files.name"
                    visible: root.saves
                    width: parent.width - nameLabel.width - filter.width - buttons.width - 24
                    name: qsTr("Name")
                    onAccepted: root.accept()
                    onTextEdited: {
                        root.asks = FileWindow.Nothing;
                        root.complaint = "";
                    }
                    onActiveFocusChanged: {
                        // The ending stays when a new name is typed over it.
                        const dot = text.lastIndexOf(".");
                        if (activeFocus && dot > 0)
                            select(0, dot);
                    }
                    Keys.onEscapePressed: root.close()
                }
                Item {
                    visible: !root.saves
                    width: parent.width - filter.width - buttons.width - 16
                    height: 1
                }
                ChoiceField {
                    id: filter

                    objectName: "files.filter"
                    visible: root.nameFilters.length > 1
                    width: visible ? Math.min(230, root.width / 3) : 0
                    name: qsTr("Which files are shown")
                    model: root.nameFilters.map(each => each.replace(/\s*\([^)]*\)\s*$/, ""))
                    onActivated: index => root.browser.patterns = root.patternsOf(index)
                }
                Row {
                    id: buttons

                    spacing: 8

                    PushButton {
                        objectName: "files.cancel"
                        text: qsTr("Cancel")
                        onClicked: root.close()
                    }
                    PushButton {
                        objectName: "files.accept"
                        primary: true
                        text: root.saves ? qsTr("Save") : root.takesFolder ? qsTr("Choose this folder") : qsTr("Open")
                        onClicked: root.takesFolder ? root.finish([files.chosen.length > 0 ? files.chosen[0] : root.browser.folder]) : root.saves ? root.save() : root.takeFromList()
                    }
                }
            }
        }
    }

    function patternsOf(index: int): list<string> {
        const given = /\(([^)]*)\)\s*$/.exec(root.nameFilters[index] ?? "");
        const patterns = given ? given[1].split(/\s+/).filter(each => each.length > 0) : [];
        return patterns.includes("*") ? [] : patterns;
    }
    /// `suggestion` is a file to be saved.
    function begin(suggestion: url): void {
        root.done = false;
        root.asks = FileWindow.Nothing;
        root.complaint = "";
        files.chosen = [];
        filter.currentIndex = 0;
        root.browser.patterns = root.patternsOf(0);
        root.browser.watching = true;
        const suggested = root.saves ? root.browser.pathOf(suggestion) : "";
        nameField.text = root.browser.nameOf(suggested);
        const around = root.browser.folderOf(suggested);
        if (suggested.length > 0 && root.browser.whatIs(around) === FileBrowser.Folder)
            root.browser.show(around);
        else
            root.browser.showLast();
        root.open();
    }
    function ask(what: int, about: string): void {
        root.complaint = "";
        root.about = about;
        root.asks = what;
        if (what === FileWindow.NewFolder) {
            folderName.text = "";
            folderName.forceActiveFocus();
        } else {
            no.forceActiveFocus(Qt.TabFocusReason);
        }
    }
    function complain(text: string): void {
        root.asks = FileWindow.Nothing;
        root.complaint = text;
    }
    /// The question is answered with no.
    function takeBack(): void {
        root.asks = FileWindow.Nothing;
        root.saves ? nameField.forceActiveFocus() : files.focusList();
    }
    function answer(): void {
        const asked = root.asks;
        if (asked === FileWindow.Replace) {
            root.finish([root.about]);
            return;
        }
        const folder = asked === FileWindow.NewFolder ? root.browser.absolute(folderName.text) : root.about;
        if (folder.length === 0)
            return;
        if (root.browser.makeFolder(folder)) {
            // What was typed with its folder lies in that folder now.
            nameField.text = root.browser.nameOf(nameField.text);
            root.takeBack();
        } else {
            root.complain(qsTr("The folder “%1” cannot be made.").arg(folder));
        }
    }
    /// Over the folder that is shown; without a text, that is selected.
    function typePath(begun: string): void {
        pathField.forceActiveFocus(Qt.ShortcutFocusReason);
        if (begun.length > 0)
            pathField.text = begun;
        else
            pathField.selectAll();
    }
    /// To a folder that was typed, or a file in one.
    function goTo(entered: string): void {
        const path = root.browser.absolute(entered);
        const what = root.browser.whatIs(path);
        if (what === FileBrowser.Folder) {
            root.browser.show(path);
            root.complaint = "";
        } else if (what === FileBrowser.File && !root.takesFolder) {
            root.browser.show(root.browser.folderOf(path));
            if (root.saves)
                nameField.text = root.browser.nameOf(path);
            else
                root.finish([path]);
        } else if (root.saves || root.takesFolder) {
            root.ask(FileWindow.MakeFolder, path);
        } else {
            root.complain(qsTr("There is nothing called “%1”.").arg(path));
        }
    }
    /// What is chosen in the list, by two clicks or Return: a folder is looked into, also where a file is to be saved.
    function takeFromList(): void {
        if (files.chosen.length === 1 && root.browser.whatIs(files.chosen[0]) === FileBrowser.Folder)
            root.browser.show(files.chosen[0]);
        else
            root.accept();
    }
    function accept(): void {
        root.saves ? root.save() : root.openChosen();
    }
    function openChosen(): void {
        const folder = files.chosen.find(path => root.browser.whatIs(path) === FileBrowser.Folder);
        if (files.chosen.length > 0 && folder === undefined)
            root.finish(files.chosen);
        else
            root.complain(files.chosen.length > 1 ? qsTr("Choose files only, or one folder to look into.") : qsTr("Choose a file first."));
    }
    function save(): void {
        const typed = root.browser.absolute(nameField.text);
        if (root.browser.whatIs(typed) === FileBrowser.Folder && nameField.text.trim().length > 0) {
            root.browser.show(typed);
            nameField.text = "";
            return;
        }
        const path = root.browser.withSuffix(typed, root.defaultSuffix);
        const what = root.browser.whatIs(path);
        if (what === FileBrowser.NewFile)
            root.finish([path]);
        else if (what === FileBrowser.File)
            root.ask(FileWindow.Replace, path);
        else if (what === FileBrowser.NoFolder)
            root.ask(FileWindow.MakeFolder, root.browser.folderOf(path));
        else
            root.complain(what === FileBrowser.NotWritable ? qsTr("Nothing can be written in “%1”. Choose another folder.").arg(root.browser.folderOf(path)) : qsTr("Give the file a name."));
    }
    function finish(paths: list<string>): void {
        if (root.done)
            return;
        root.done = true;
        root.browser.remember(root.takesFolder ? paths[0] : root.browser.folderOf(paths[0]));
        root.close();
        root.taken(paths.map(path => root.browser.urlOf(path)));
    }
}
