import QtQuick
import Furrow.Controls

/// Goes through light, dark and sunlight; the first press leaves what the system says.
ToolIconButton {
    id: root

    objectName: "themeSwitch"
    iconName: Theme.sunlight ? "sunlight" : Theme.dark ? "dark" : "light"
    hint: Theme.sunlight ? qsTr("Sunlight colours; press for light") : Theme.dark ? qsTr("Dark colours; press for sunlight") : qsTr("Light colours; press for dark")
    onClicked: {
        const next = Theme.sunlight ? Theme.Light : Theme.dark ? Theme.Sunlight : Theme.Dark;
        Theme.forced = Theme.System;
        Theme.mode = next;
    }
}
