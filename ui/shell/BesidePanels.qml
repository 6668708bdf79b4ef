import QtQuick
import QtQuick.Templates as T
import QtPositioning
import Furrow.Compare
import Furrow.Controls
import Furrow.Driven
import Furrow.Edit
import Furrow.Guide
import Furrow.Results

/// What stands at the right of the map: the results, or in their place the guide, a field that is made from a track, two
/// plans beside each other, or a recorded track. As wide as what is shown of it.
Item {
    id: root

    required property Session session
    required property MapPage page
    /// All fields of the farm are in view.
    required property bool farmOpen
    /// The results need not be closed to see the map.
    required property bool roomForPanel
    property int currentFinding: -1
    property list<color> drivenColors
    property bool panelWanted: true
    /// Two plans are compared in place of the results of one.
    property bool compareWanted: false
    /// Each of the two is on a map of its own, where they are compared.
    property bool twoMapsWanted: false
    /// The guide is read beside the map.
    property bool guideOpen: false
    /// A field is being made from a recorded track.
    readonly property bool fromTrackOpen: session.fieldFromTrack.active && !guideOpen
    readonly property bool planInView: !fromTrackOpen && !farmOpen && session.shown.hasPlan && !guideOpen
    readonly property bool compareOpen: compareWanted && planInView
    readonly property bool twoMaps: compareOpen && twoMapsWanted
    /// A recorded track lies over the plan, beside its figures.
    readonly property bool drivenOpen: session.driven.active && !compareOpen && planInView
    /// What takes the place of the results.
    readonly property bool otherOpen: compareOpen || drivenOpen || fromTrackOpen || guideOpen
    readonly property bool panelOpen: !farmOpen && !otherOpen && session.shown.hasPlan && (roomForPanel || panelWanted)
    /// The other plan is on the map, for as long as its button is held.
    readonly property alias holdingOther: comparePanel.holding
    readonly property alias results: results
    readonly property alias guide: guidePanel.guide
    signal farmGivesWay()
    signal stepsGiveWay()
    signal findingRequested(index: int)
    signal driveRequested(segment: int)
    signal variantRequested()

    width: guideOpen ? guidePanel.width : otherOpen ? 340 : panelOpen ? results.width : 0
    onRoomForPanelChanged: panelWanted = roomForPanel

    ResultsPanel {
        id: results

        anchors { right: parent.right; top: parent.top; bottom: parent.bottom }
        width: 308
        visible: root.panelOpen
        shown: root.session.shown
        planning: root.session.planning
        figures: root.session.figures
        findings: root.session.findings
        lastChange: root.session.lastChange
        review: root.session.review
        editor: root.page.editor
        currentFinding: root.currentFinding
        onFindingRequested: index => root.findingRequested(index)
        onDriveRequested: segment => root.driveRequested(segment)
    }
    ComparePanel {
        id: comparePanel

        objectName: "comparePanel"
        anchors.fill: parent
        visible: root.compareOpen
        comparison: root.session.comparison
        twoMaps: root.twoMaps
        onTwoMapsChosen: on => root.twoMapsWanted = on
        onCloseRequested: root.closeCompare()
        onVariantRequested: root.variantRequested()
    }
    Binding {
        target: root.session.comparison
        property: "active"
        value: root.compareOpen
    }
    FieldFromTrackPanel {
        objectName: "fieldFromTrackPanel"
        anchors.fill: parent
        visible: root.fromTrackOpen
        source: root.session.fieldFromTrack
        onCloseRequested: {
            root.session.fieldFromTrack.close();
            if (root.session.farm.hasField)
                root.page.fitField(true);
            root.page.forceActiveFocus();
        }
    }
    Connections {
        target: root.session.fieldFromTrack

        function onOutlined(area: geoRectangle): void {
            root.farmGivesWay();
            root.guideOpen = false;
            root.page.fitArea(area, true);
        }
        function onLayRequested(): void {
            root.closeOthers();
        }
    }
    TrackQuestion {
        anchors.centerIn: T.Overlay.overlay
        source: root.session.fieldFromTrack
    }
    GuidePanel {
        id: guidePanel

        objectName: "guidePanel"
        anchors { right: parent.right; top: parent.top; bottom: parent.bottom }
        width: Math.min(440, Math.max(340, root.parent.width * 0.34), root.parent.width - 48)
        visible: root.guideOpen
        onCloseRequested: root.closeGuide()
    }
    DrivenPanel {
        objectName: "drivenPanel"
        anchors.fill: parent
        visible: root.drivenOpen
        track: root.session.driven
        colors: root.drivenColors
        onOpenRequested: {
            drivenDialog.forField = false;
            drivenDialog.open();
        }
        onFieldRequested: root.session.fieldFromTrack.takeOver(root.session.driven)
        onCloseRequested: {
            root.session.driven.close();
            root.page.forceActiveFocus();
        }
        onPlaceRequested: place => {
            if (place.isValid)
                root.page.camera.centreOn(place, 19, true);
        }
    }
    DrivenDialog {
        id: drivenDialog

        track: root.session.driven
        source: root.session.fieldFromTrack
    }

    function closeOthers(): void {
        root.guideOpen = false;
        root.compareWanted = false;
        root.farmGivesWay();
    }
    /// The results, in place of whatever stands there or over them.
    function showResults(): void {
        root.closeOthers();
        root.session.driven.close();
        root.session.fieldFromTrack.close();
        root.panelWanted = true;
        root.stepsGiveWay();
    }
    /// The list of what was found, beginning with what blocks.
    function showFindings(): void {
        if (!root.session.shown.hasPlan)
            return;
        root.showResults();
        results.showFindings();
    }
    function togglePanel(): void {
        if (root.guideOpen || !root.panelWanted)
            root.showResults();
        else
            root.panelWanted = false;
    }
    function showGuide(): void {
        root.guideOpen = true;
        root.stepsGiveWay();
        guidePanel.begin();
    }
    function showGuidePage(chapter: int, block: int): void {
        root.showGuide();
        guidePanel.show(chapter, block);
    }
    function closeGuide(): void {
        root.guideOpen = false;
        root.page.forceActiveFocus();
    }
    function showCompare(): void {
        root.closeOthers();
        root.compareWanted = true;
        comparePanel.begin();
    }
    function closeCompare(): void {
        root.compareWanted = false;
        root.page.forceActiveFocus();
    }
    function toggleTwoMaps(): void {
        const on = !root.twoMaps;
        root.twoMapsWanted = on;
        if (on && !root.compareOpen)
            root.showCompare();
    }
    /// A recording is asked for, to be laid over the plan or, if there is none, to become a field.
    function askForTrack(): void {
        root.closeOthers();
        drivenDialog.forField = !root.session.shown.hasPlan;
        drivenDialog.open();
    }
    function askForFieldTrack(): void {
        drivenDialog.forField = true;
        drivenDialog.open();
    }
}
