pragma Singleton
pragma ComponentBehavior: Bound
import QtQuick
import QtCore

/// Colours, sizes and motion of the whole window.
QtObject {
    id: root

    enum Mode { System, Light, Dark, Sunlight }

    /// What the user chose; remembered.
    property int mode: Theme.System
    /// In its place for this run, where it is not System.
    property int forced: Theme.System
    readonly property int effective: forced !== Theme.System ? forced : mode
    readonly property bool systemDark: Application.styleHints.colorScheme === Qt.ColorScheme.Dark
    readonly property bool dark: effective === Theme.Dark || (effective === Theme.System && systemDark)
    readonly property bool sunlight: effective === Theme.Sunlight

    readonly property color background: pick("#F4F6F2", "#111714", "#FFFFFF")
    readonly property color panel: pick("#FFFFFF", "#1A221E", "#FFFFFF")
    readonly property color sunken: pick("#F4F6F2", "#151C18", "#FFFFFF")
    readonly property color ink: pick("#17231C", "#E8EFEA", "#000000")
    readonly property color muted: pick("#5B6B61", "#9DB0A5", "#333333")
    readonly property color line: pick("#DCE3DD", "#2B3731", "#000000")
    readonly property color accent: pick("#1B6B43", "#57C48A", "#00441F")
    readonly property color accentHover: pick("#175C3A", "#6BD09B", "#003317")
    readonly property color accentInk: pick("#FFFFFF", "#0C1811", "#FFFFFF")
    readonly property color softAccent: pick("#E7F1EA", "#20332A", "#FFFFFF")
    readonly property color hover: pick("#F0F3EF", "#222C27", "#EEEEEE")
    readonly property color warning: pick("#9A5B00", "#F0B35A", "#5C3600")
    readonly property color warningGround: pick("#FFF3DC", "#33291A", "#FFFFFF")
    readonly property color failure: pick("#A3262A", "#FF8F87", "#7A0006")
    readonly property color failureGround: pick("#FDECEA", "#371F1E", "#FFFFFF")
    readonly property color shadow: pick("#0A17231C", "#22000000", "#00000000")

    readonly property color mapGround: pick("#E9EDE4", "#161D19", "#FFFFFF")
    readonly property color mapSea: pick("#D9E3E4", "#0F1618", "#E4F0FF")
    readonly property color mapCoast: pick("#B9C6BC", "#34423A", "#000000")
    readonly property color mapGrid: pick("#E0E5DC", "#1B2420", "#DDDDDD")
    readonly property color boundary: "#FFC933"
    readonly property color casing: pick("#2A2617", "#0B0F0D", "#000000")
    readonly property color headland: "#E69F00"
    readonly property color swath: pick("#0072B2", "#56B4E9", "#004C80")
    readonly property color turn: pick("#D55E00", "#FF9A5C", "#9C3F00")
    readonly property color finding: pick("#B0307A", "#E58AC0", "#7A0A4B")
    readonly property color obstacle: pick("#7A2F2F", "#E08A8A", "#5A0000")
    readonly property color covered: pick("#2E8B57", "#57C48A", "#007A3D")
    readonly property color overlap: pick("#7B4FA3", "#B48AE0", "#4B1F7A")
    readonly property color missed: pick("#B0307A", "#E58AC0", "#7A0A4B")
    readonly property color wheels: pick("#5A4632", "#C9B08F", "#3A2A17")
    /// Lines that the mainland is cut along; over a casing of the other lightness.
    readonly property color split: pick("#17231C", "#0B0F0D", "#000000")
    readonly property color startMark: "#009E73"
    readonly property color endMark: pick("#17231C", "#E8EFEA", "#000000")
    readonly property real lineFactor: sunlight ? 1.5 : 1.0
    readonly property real hairline: sunlight ? 2 : 1

    readonly property string family: "Inter"
    readonly property int bodySize: 13
    readonly property int labelSize: 12
    readonly property int titleSize: 14
    readonly property int controlHeight: 34
    readonly property int radius: 8
    readonly property int cardRadius: 10
    readonly property int unit: 8
    readonly property int motion: 140

    readonly property Settings stored: Settings {
        category: "window"
        property alias theme: root.mode
    }

    function pick(light: color, darkOne: color, sun: color): color {
        return root.sunlight ? sun : root.dark ? darkOne : light;
    }
}
