import QtQuick
import QtPositioning
import Furrow.Compare
import Furrow.Controls
import Furrow.Edit
import Furrow.Layers
import Furrow.Map

/// Where the map of the other plan stands beside or below the map of the window, while it is open. It is made for that
/// time only.
Loader {
    id: root

    required property bool open
    required property MapPage page
    required property PlanComparison comparison
    required property ImageryModel imagery
    required property planStyle style
    property bool imageryShown: true
    property bool online: false
    /// What both maps have together.
    required property real fromX
    required property real toX
    required property real fromY
    required property real toY
    /// Of what only the other plan has; no colour that swaths or turns have.
    readonly property color lineColor: Theme.finding
    readonly property real roomX: toX - fromX
    readonly property real roomY: toY - fromY
    readonly property geoRectangle field: page.drawing.bounds
    /// Width of the field by its height.
    readonly property real shape: field.isValid && field.height > 0 ? field.width * Math.cos(field.center.latitude * Math.PI / 180) / field.height : 1
    /// The field is drawn larger that way.
    readonly property bool stacked: scaleIn(roomX, roomY / 2) > 1.1 * scaleIn(roomX / 2, roomY)
    readonly property bool beside: open && !stacked
    readonly property bool below: open && stacked
    property geoCoordinate centreBefore
    property real zoomBefore: 0

    /// Of a field of that shape, with what fitField leaves free.
    function scaleIn(wide: real, high: real): real {
        return Math.min((wide - 132) / shape, high - 144);
    }
    /// Both maps show all of the field; at the end the view is what it was.
    function change(open: bool): void {
        if (open) {
            centreBefore = page.camera.center;
            zoomBefore = page.camera.zoomLevel;
            Qt.callLater(() => page.fitField(false));
        } else {
            const centre = centreBefore;
            const zoom = zoomBefore;
            Qt.callLater(() => page.camera.goTo(centre, zoom));
        }
    }

    x: stacked ? fromX : Math.round((fromX + toX) / 2)
    y: stacked ? Math.round((fromY + toY) / 2) : fromY
    width: toX - x
    height: toY - y
    active: open
    sourceComponent: Item {
        OtherMap {
            objectName: "otherMap.map"
            anchors.fill: parent
            comparison: root.comparison
            camera: root.page.camera
            imagery: root.imagery
            imageryShown: root.imageryShown
            online: root.online
            onlineServer: root.page.onlineServer
            style: root.style.ofAnotherPlan()
            lineColor: root.lineColor
            casingColor: Theme.panel
        }
        Rectangle {
            width: root.stacked ? parent.width : 2
            height: root.stacked ? 2 : parent.height
            color: Theme.line
        }
    }
}
