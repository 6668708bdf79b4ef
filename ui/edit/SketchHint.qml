import QtQuick
import QtPositioning
import Furrow.Controls
import Furrow.Text

/// What to do while something is drawn, and fields to type the next edge into.
Rectangle {
    id: root

    required property FieldEditor editor
    /// How near a traced line is kept to, m.
    property real traceTolerance: 0
    readonly property int needed: editor.sketchNeeded
    readonly property string firstText: editor.tool === FieldEditor.Field ? qsTr("Click the first corner of the field") : editor.tool === FieldEditor.Hole ? qsTr("Click the first corner of the hole") : editor.tool === FieldEditor.Obstacle ? qsTr("Click the first corner of the obstacle") : editor.tool === FieldEditor.Gate ? qsTr("Click on the boundary where the gate is") : editor.tool === FieldEditor.Split ? qsTr("Click where the split line begins") : qsTr("Click where the AB line begins")

    objectName: "drawingHint"
    width: row.width + 28
    height: 52
    radius: Theme.cardRadius
    color: Theme.panel
    border.width: Theme.hairline
    border.color: Theme.line

    SoftShadow { radius: root.radius }
    Row {
        id: row

        anchors { left: parent.left; leftMargin: 16; verticalCenter: parent.verticalCenter }
        spacing: 10

        BodyText {
            anchors.verticalCenter: parent.verticalCenter
            visible: root.editor.sketchCount === 0
            text: root.editor.freehand && root.editor.tool !== FieldEditor.Gate ? qsTr("Press and trace it with the pointer, to %1").arg(Display.quantities.text(root.traceTolerance, QuantityText.Length, 1) + " " + Display.quantities.unit(QuantityText.Length)) : root.firstText
        }
        NumberField {
            id: length

            objectName: "sketch.length"
            visible: root.editor.sketchCount > 0
            width: 108
            name: qsTr("Length of the next edge")
            kind: QuantityText.Length
            from: 0
            to: 100000
            decimals: 2
            value: activeFocus ? value : root.editor.sketchLengthM
            onCommitted: newValue => value = newValue
            Keys.onReturnPressed: root.addTyped()
        }
        NumberField {
            id: bearing

            objectName: "sketch.bearing"
            visible: root.editor.sketchCount > 0
            width: 100
            name: qsTr("Direction of the next edge")
            kind: QuantityText.Angle
            from: 0
            to: 360
            decimals: 1
            value: activeFocus ? value : root.editor.sketchBearingDeg
            Keys.onReturnPressed: root.addTyped()
        }
        SmallButton {
            objectName: "sketch.add"
            anchors.verticalCenter: parent.verticalCenter
            visible: root.editor.sketchCount > 0
            text: qsTr("Add")
            onClicked: root.addTyped()
        }
        CheckRow {
            objectName: "sketch.freehand"
            anchors.verticalCenter: parent.verticalCenter
            visible: root.editor.sketchCount === 0 && root.editor.tool !== FieldEditor.Gate
            text: qsTr("By hand")
            checked: root.editor.freehand
            onToggled: root.editor.freehand = checked
        }
        PushButton {
            objectName: "cancelDrawing"
            text: qsTr("Cancel")
            onClicked: root.editor.cancelSketch()
        }
        PushButton {
            objectName: "finishDrawing"
            visible: root.editor.tool !== FieldEditor.Gate
            text: root.editor.sketchOpen ? qsTr("Finish") : qsTr("Close boundary")
            primary: true
            enabled: root.editor.sketchCount >= root.needed
            onClicked: root.editor.finishSketch()
        }
    }

    function addTyped(): void {
        if (Display.quantities.isValue(length.text, QuantityText.Length) && Display.quantities.isValue(bearing.text, QuantityText.Angle))
            root.editor.addPointBy(Display.quantities.value(length.text, QuantityText.Length), Display.quantities.value(bearing.text, QuantityText.Angle));
    }
}
