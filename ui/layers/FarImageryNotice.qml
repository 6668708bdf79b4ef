import QtQuick
import QtPositioning
import Furrow.Controls
import Furrow.Text

/// A picture that was added lies elsewhere: says how far, and offers to go there.
Rectangle {
    id: root

    /// Of the field; empty where there is none.
    property geoRectangle field
    property geoRectangle area
    property bool shown: false
    readonly property real away: shown && area.isValid && field.isValid ? area.center.distanceTo(field.center) : 0
    signal goRequested()

    objectName: "farImagery"
    visible: shown
    width: 400
    height: column.height + 28
    radius: Theme.cardRadius
    color: Theme.panel
    border.width: Theme.hairline
    border.color: Theme.line
    Accessible.role: Accessible.AlertMessage
    Accessible.name: message.text

    SoftShadow { radius: root.radius }
    Column {
        id: column

        x: 16
        y: 14
        width: parent.width - 32
        spacing: 8

        BodyText {
            id: message

            objectName: "farImagery.text"
            width: parent.width
            text: qsTr("This picture does not show the field: it lies %1 away.").arg(Display.quantities.scaleText(root.away))
            font.weight: Font.DemiBold
            wrapMode: Text.Wrap
        }
        Row {
            spacing: 8

            PushButton {
                objectName: "farImagery.go"
                text: qsTr("Go there")
                onClicked: {
                    root.shown = false;
                    root.goRequested();
                }
            }
            PushButton {
                objectName: "farImagery.close"
                text: qsTr("Close")
                onClicked: root.shown = false
            }
        }
    }

    /// Whether it is far: then it is told.
    function look(area: geoRectangle, field: geoRectangle): void {
        root.area = area;
        root.field = field;
        root.shown = field.isValid && area.isValid && !area.intersects(field);
    }
}
