import QtQuick
import Furrow.Commands
import Furrow.Edit
import Furrow.Plan

/// The command palette with what it finds beside commands (settings, machines, fields, samples, findings, pages of the
/// guide, places), and the way there.
CommandPalette {
    id: root

    required property Session session
    required property MapPage page
    required property PlanOverlays overlays
    required property BesidePanels beside
    required property StepsPanel steps
    signal stepsRequested()
    signal findingRequested(index: int)
    signal placeVisited()

    function openForPlace(): void {
        root.hint = qsTr("Coordinates, such as 48.1371, 11.5754");
        root.open();
    }
    function searchable(): var {
        const pages = root.beside.guide.searchable(qsTr("Guide"));
        const samples = root.session.opener.sampleNames.map((name, index) => ({ kind: "sample", name: name, group: qsTr("Sample field"), keywords: qsTr("example try"), index: index }));
        if (!root.session.farm.hasField)
            return [...samples, ...pages];
        const fields = root.session.farm.fields.map((name, index) => ({ kind: "field", name: name, group: qsTr("Fields"), keywords: qsTr("field"), index: index }));
        const findings = root.session.findings.texts().map((text, index) => ({ kind: "finding", name: text, group: qsTr("Findings"), keywords: qsTr("finding"), index: index }));
        return [...root.session.planning.steps.searchable(), ...root.session.planning.machine.searchable(), ...fields, ...findings, ...samples, ...pages];
    }
    function goTo(entry: var): void {
        if (entry.kind === "place") {
            root.page.camera.centreOn(entry.place, 16, true);
            root.overlays.pulseAt(entry.place);
            root.placeVisited();
        } else if (entry.kind === "guide") {
            root.beside.showGuidePage(entry.chapter, entry.block);
        } else if (entry.kind === "field") {
            root.session.farm.currentField = entry.index;
        } else if (entry.kind === "sample") {
            root.session.opener.openSample(entry.index);
        } else if (entry.kind === "finding") {
            root.beside.showResults();
            root.findingRequested(entry.index);
            root.beside.results.showFinding(entry.index);
        } else {
            // What has a value is taken, as in its panel.
            if (entry.machine !== undefined)
                root.session.planning.machine.libraryIndex = entry.machine;
            else if (entry.value !== undefined)
                root.session.planning.set(entry.key, entry.value);
            root.stepsRequested();
            root.steps.openSetting(entry.stepId, entry.key);
        }
    }

    placeEntry: text => {
        const place = root.page.camera.placeNamedBy(text);
        return place.isValid ? { kind: "place", name: qsTr("Go to %1").arg(root.page.camera.nameOf(place)), group: qsTr("Map"), keywords: "", place: place } : null;
    }
    onAboutToShow: {
        root.entries = root.searchable();
        // What opened late would take the keys.
        root.steps.wantedKey = "";
    }
    onEntryChosen: entry => root.goTo(entry)
}
