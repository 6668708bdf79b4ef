import QtQml
import Furrow.Controls
import Furrow.Edit
import Furrow.Layers
import Furrow.Map
import Furrow.Plan

/// How the plan is drawn: the colours, what the layers show of it, what is selected, and whether it is old.
QtObject {
    id: root

    required property ShownPlan shown
    required property Planning planning
    required property ImageryModel imagery
    required property LayerSwitches layers
    required property FieldEditor editor
    /// The steps to the cells are gone through: of the plan the map shows the swaths only.
    required property bool steppingCells
    /// What is drawn is a plan of what the panels showed before.
    readonly property bool planIsOld: shown.hasPlan && (planning.state === PlanState.OutOfDate || planning.state === PlanState.Planning && planning.slow && !shown.draft)
    readonly property planStyle style: ({
            boundary: Theme.boundary,
            casing: Theme.casing,
            headland: Theme.headland,
            swath: Theme.swath,
            turn: Theme.turn,
            finding: Theme.finding,
            obstacle: Theme.obstacle,
            start: Theme.startMark,
            end: Theme.endMark,
            ground: Theme.panel,
            ink: Theme.ink,
            lineFactor: Theme.lineFactor,
            showBoundary: root.layers.boundary && !root.editor.dragging && !root.shown.behind,
            showHeadland: root.layers.headland,
            showSwaths: root.layers.swaths,
            showTurns: root.layers.turns && !root.steppingCells,
            showDirections: root.layers.directions && !root.steppingCells,
            showNumbers: root.layers.numbers && !root.steppingCells,
            covered: Theme.covered,
            overlap: Theme.overlap,
            missed: Theme.missed,
            wheels: Theme.wheels,
            showCoverage: root.layers.coverage,
            showOverlap: root.layers.overlap,
            showMissed: root.layers.missed && !root.steppingCells,
            showWheels: root.layers.wheels,
            onImagery: root.layers.online || root.layers.imagery && root.imagery.count > 0,
            showFindings: root.layers.findings && !root.steppingCells,
            showOrder: root.layers.order && !root.steppingCells,
            selectedFinding: root.editor.selectedFinding,
            selectedSegment: root.editor.selectedSegment,
            selectedCell: root.editor.selectedCell,
            old: root.planIsOld
        })
}
