import QtQuick
import QtPositioning
import Furrow.Controls
import Furrow.Text

/// A picture that was added lies elsewhere: says how far, and offers to go there.
NoticeCard {
    id: root

    /// Of the picture.
    property geoRectangle area
    property real away: 0
    signal goRequested()

    objectName: "farImagery"
    visible: away > 0
    text: qsTr("This picture does not show the field: it lies %1 away.").arg(Display.quantities.scaleText(root.away))

    PushButton {
        objectName: "farImagery.go"
        text: qsTr("Go there")
        onClicked: {
            root.away = 0;
            root.goRequested();
        }
    }
    PushButton {
        objectName: "farImagery.close"
        text: qsTr("Close")
        onClicked: root.away = 0
    }

    /// Tells it where the picture does not touch the field.
    function look(area: geoRectangle, field: geoRectangle): void {
        root.area = area;
        root.away = field.isValid && area.isValid && !area.intersects(field) ? area.center.distanceTo(field.center) : 0;
    }
}
