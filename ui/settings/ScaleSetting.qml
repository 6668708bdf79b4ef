import QtQuick
import QtCore

/// How large everything is drawn, in per cent; the program reads it when it starts.
QtObject {
    id: root

    property int percent: 100
    signal changed()

    readonly property Settings stored: Settings {
        category: "window"
        property alias scale: root.percent
    }

    function set(percent: int): void {
        if (percent !== root.percent) {
            root.percent = percent;
            root.stored.sync();
            root.changed();
        }
    }
}
