import QtQuick
import QtPositioning
import Furrow.Edit
import Furrow.Layers
import Furrow.Trouble

/// What happened, on cards over the map. They stand on each other, so none covers another.
Column {
    id: root

    required property Session session
    required property MapPage page
    signal reportRequested()

    spacing: 8

    CrashNotice {
        width: root.width
        report: root.session.trouble
        onReportRequested: root.reportRequested()
    }
    DrawingNotice {
        width: root.width
    }
    ImageryNotice {
        width: root.width
        imagery: root.session.imagery
    }
    FarImageryNotice {
        id: farImagery

        width: root.width
        onGoRequested: root.page.fitArea(area, true)
    }
    StepsNotice {
        width: root.width
        editor: root.page.editor
        fields: root.session.farm.fields.length
    }
    Connections {
        target: root.session.imagery

        function onAdded(area: geoRectangle): void {
            if (root.session.farm.hasField)
                farImagery.look(area, root.page.drawing.bounds);
            else
                root.page.fitArea(area, false);
        }
    }
}
