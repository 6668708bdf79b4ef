pragma ComponentBehavior: Bound
import QtCore
import QtQuick
import Furrow.Controls

/// What the map shows of the plan; remembered.
Grid {
    id: root

    property bool boundary: true
    property bool headland: true
    property bool swaths: true
    property bool turns: true
    property bool directions: true
    property bool numbers: true
    property bool order: false
    property bool coverage: false
    property bool overlap: false
    property bool missed: true
    property bool wheels: false
    property bool findings: true
    /// All of the user's imagery, and the map from the network.
    property bool imagery: true
    property bool online: false
    /// Wide enough for every name.
    readonly property real wanted: {
        let widest = 0;
        for (let i = 0; i < root.children.length; ++i)
            widest = Math.max(widest, root.children[i].implicitWidth);
        return root.columns * widest + (root.columns - 1) * root.columnSpacing;
    }

    readonly property Settings stored: Settings {
        category: "layers"
        property alias boundary: root.boundary
        property alias headland: root.headland
        property alias swaths: root.swaths
        property alias turns: root.turns
        property alias directions: root.directions
        property alias numbers: root.numbers
        property alias order: root.order
        property alias coverage: root.coverage
        property alias overlap: root.overlap
        property alias missed: root.missed
        property alias wheels: root.wheels
        property alias findings: root.findings
        property alias imagery: root.imagery
        property alias online: root.online
    }

    objectName: "layerSwitches"

    columns: 2
    columnSpacing: 8

    component Layer: CheckRow {
        width: (root.width - root.columnSpacing) / 2
        hasSwatch: true
    }

    Layer {
        objectName: "layer.imagery"
        text: qsTr("Imagery")
        hasSwatch: false
        checked: root.imagery
        onToggled: root.imagery = checked
    }
    Layer {
        objectName: "layer.boundary"
        text: qsTr("Boundary")
        swatch: Theme.boundary
        checked: root.boundary
        onToggled: root.boundary = checked
    }
    Layer {
        objectName: "layer.headland"
        text: qsTr("Headland")
        swatch: Theme.headland
        checked: root.headland
        onToggled: root.headland = checked
    }
    Layer {
        objectName: "layer.swaths"
        text: qsTr("Swaths")
        swatch: Theme.swath
        checked: root.swaths
        onToggled: root.swaths = checked
    }
    Layer {
        objectName: "layer.turns"
        text: qsTr("Path")
        swatch: Theme.turn
        checked: root.turns
        onToggled: root.turns = checked
    }
    Layer {
        objectName: "layer.directions"
        text: qsTr("Directions")
        swatch: Theme.ink
        checked: root.directions
        onToggled: root.directions = checked
    }
    Layer {
        objectName: "layer.numbers"
        text: qsTr("Swath numbers")
        swatch: Theme.swath
        checked: root.numbers
        onToggled: root.numbers = checked
    }
    Layer {
        objectName: "layer.order"
        text: qsTr("Order numbers")
        swatch: Theme.ink
        checked: root.order
        onToggled: root.order = checked
    }
    Layer {
        objectName: "layer.coverage"
        text: qsTr("Coverage")
        swatch: Theme.covered
        checked: root.coverage
        onToggled: root.coverage = checked
    }
    Layer {
        objectName: "layer.overlap"
        text: qsTr("Worked twice")
        swatch: Theme.overlap
        checked: root.overlap
        onToggled: root.overlap = checked
    }
    Layer {
        objectName: "layer.missed"
        text: qsTr("Missed")
        swatch: Theme.missed
        checked: root.missed
        onToggled: root.missed = checked
    }
    Layer {
        objectName: "layer.wheels"
        text: qsTr("Wheel passes")
        swatch: Theme.wheels
        checked: root.wheels
        onToggled: root.wheels = checked
    }
    Layer {
        objectName: "layer.findings"
        text: qsTr("Findings")
        swatch: Theme.finding
        checked: root.findings
        onToggled: root.findings = checked
    }
}
