import QtQuick
import QtPositioning
import Furrow.Compare
import Furrow.Controls
import Furrow.Drive
import Furrow.Driven
import Furrow.Edit
import Furrow.Farm
import Furrow.Map
import Furrow.Results
import Furrow.Review

/// What lies over the plan on the map: tracks, differences, the machine, names of fields, comments, pickers.
Item {
    id: root

    required property Session session
    required property MapPage page
    required property BesidePanels beside
    required property bool farmOpen
    /// The steps to the cells are gone through.
    required property bool steppingCells
    /// Of what only the other plan has.
    required property color otherColor
    readonly property MapCamera camera: page.camera
    readonly property alias pins: pins
    signal fieldPicked(row: int, how: int)
    signal fieldOpened(row: int)
    signal commentClicked(row: int)
    signal commentPlaced(place: geoCoordinate)

    /// Draws the eye to a place.
    function pulseAt(place: geoCoordinate): void {
        pulse.begin(place);
    }

    DrivenLayer {
        anchors.fill: parent
        visible: root.beside.drivenOpen
        camera: root.camera
        track: root.session.driven
        colors: root.beside.drivenColors
        casingColor: Theme.panel
        missedColor: Theme.missed
        lineFactor: Theme.lineFactor
    }
    TrackOutlineLayer {
        objectName: "trackOutlineLayer"
        anchors.fill: parent
        visible: root.beside.fromTrackOpen
        camera: root.camera
        source: root.session.fieldFromTrack
        lineColor: Theme.boundary
        casingColor: Theme.casing
        fillColor: Qt.alpha(Theme.accent, 0.16)
        trackColor: Theme.swath
        lineFactor: Theme.lineFactor
    }
    DifferenceLayer {
        anchors.fill: parent
        visible: root.beside.compareOpen && !root.page.showOther
        showSecond: !root.beside.twoMaps
        camera: root.camera
        comparison: root.session.comparison
        firstColor: Theme.accent
        secondColor: root.otherColor
        casingColor: Theme.panel
        lineFactor: Theme.lineFactor
    }
    FarmNames {
        anchors.fill: parent
        visible: root.session.farmList.count > 1 || root.farmOpen
        fields: root.session.farmList
        camera: root.camera
        choosing: root.farmOpen
        onPicked: (row, how) => root.fieldPicked(row, how)
        onOpened: row => root.fieldOpened(row)
    }
    WorkedLayer {
        objectName: "workedLayer"
        anchors.fill: parent
        visible: root.session.drive.underWay && !root.steppingCells
        camera: root.camera
        drive: root.session.drive
        color: Theme.covered
        // As one picture: land that is worked twice is not darker.
        layer.enabled: true
        opacity: 0.32
    }
    DriveLayer {
        objectName: "driveLayer"
        anchors.fill: parent
        visible: !root.steppingCells
        camera: root.camera
        drive: root.session.drive
        bodyColor: Theme.accent
        wheelColor: Theme.ink
        implementColor: Theme.dark ? Theme.boundary : Theme.ink
        casingColor: Theme.panel
    }
    CommentPins {
        id: pins

        objectName: "commentPins"
        anchors.fill: parent
        visible: root.session.shown.hasPlan && !root.steppingCells
        review: root.session.review
        camera: root.camera
        onClicked: row => root.commentClicked(row)
        onPlaced: place => root.commentPlaced(place)
    }
    Pickers {
        anchors.fill: parent
        planning: root.session.planning
        files: root.session.files
        camera: root.camera
        onToolRequested: tool => root.page.startTool(tool)
    }
    FindingPulse {
        id: pulse

        anchors.fill: parent
        camera: root.camera
    }
}
