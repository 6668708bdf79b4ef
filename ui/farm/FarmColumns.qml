import QtQuick

/// Where the columns of the list of fields stand. A narrow list goes without machines.
QtObject {
    required property real width
    readonly property real mark: 8
    readonly property real nameAt: 80
    readonly property real name: width - nameAt - machine - area - time - way - state
    readonly property real machineAt: nameAt + name
    readonly property real machine: width > 700 ? Math.min(240, Math.max(176, 0.24 * width)) : 0
    readonly property real areaAt: machineAt + machine
    readonly property real area: 72
    readonly property real timeAt: areaAt + area
    readonly property real time: width > 560 ? 92 : 86
    readonly property real wayAt: timeAt + time
    readonly property real way: width > 560 ? 74 : 0
    readonly property real stateAt: wayAt + way
    readonly property real state: 128
}
