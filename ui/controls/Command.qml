import QtQuick.Templates as T

/// Something that can be done, once for menus, keys, buttons and the command palette.
T.Action {
    /// The menu that it stands in.
    required property CommandGroup group
    /// In this menu of that menu.
    property CommandGroup submenu: null
    /// In menus a line parts it from the one before.
    property bool ruled: false
    /// What it is called wherever that says nothing of the moment.
    property string name: text
    /// Found by these words, too.
    property string keywords: ""
    /// As people read the keys.
    property string keysText: shortcut ? shortcut.toString().replace("Ctrl", qsTr("Ctrl")).replace("Shift", qsTr("Shift")) : ""
}
