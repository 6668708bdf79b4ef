pragma ComponentBehavior: Bound
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
    readonly property int points: editor.sketchCount
    readonly property string firstText: editor.tool === FieldEditor.Field ? qsTr("Click the first corner of the field") : editor.tool === FieldEditor.Hole ? qsTr("Click the first corner of the hole") : editor.tool === FieldEditor.Obstacle ? qsTr("Click the first corner of the obstacle") : editor.tool === FieldEditor.Gate ? qsTr("Click on the boundary where the gate is") : editor.tool === FieldEditor.Split ? qsTr("Click where the split line begins") : qsTr("Click where the AB line begins")

    objectName: "drawingHint"
    width: Math.max(row.width, takingBack.visible ? takingBack.implicitWidth : 0) + 28
    height: takingBack.visible ? 72 : 52
    radius: Theme.cardRadius
    color: Theme.panel
    border.width: Theme.hairline
    border.color: Theme.line
    // What was typed was for the point before.
    onPointsChanged: {
        length.follow();
        bearing.follow();
    }

    /// Of the next edge: follows the pointer until something is typed.
    component WayField: NumberField {
        id: field

        required property double pointed
        property bool typed: false

        from: 0
        onTextEdited: field.typed = true
        onTakenBack: field.follow()
        onCleared: field.follow()
        onCommitted: newValue => {
            field.typed = true;
            field.value = newValue;
        }
        Keys.onReturnPressed: root.addTyped()
        Keys.onEnterPressed: root.addTyped()

        Binding on value {
            value: field.pointed
            when: !field.typed
            restoreMode: Binding.RestoreNone
        }

        function follow(): void {
            field.typed = false;
            field.showValue();
            if (field.activeFocus)
                field.selectAll();
        }
    }

    SoftShadow { radius: root.radius }
    Row {
        id: row

        anchors { left: parent.left; leftMargin: 16 }
        y: 9
        height: Theme.controlHeight
        spacing: 10

        BodyText {
            anchors.verticalCenter: parent.verticalCenter
            visible: root.points === 0
            text: root.editor.freehand && root.editor.tool !== FieldEditor.Gate ? qsTr("Press and trace it with the pointer, to %1").arg(Display.quantities.text(root.traceTolerance, QuantityText.Length, 1) + " " + Display.quantities.unit(QuantityText.Length)) : root.firstText
        }
        WayField {
            id: length

            objectName: "sketch.length"
            visible: root.points > 0
            width: 108
            name: qsTr("Length of the next edge")
            kind: QuantityText.Length
            to: 100000
            decimals: 2
            pointed: root.editor.sketchLengthM
        }
        WayField {
            id: bearing

            objectName: "sketch.bearing"
            visible: root.points > 0
            width: 100
            name: qsTr("Direction of the next edge")
            kind: QuantityText.Angle
            to: 360
            decimals: 1
            pointed: root.editor.sketchBearingDeg
        }
        SmallButton {
            objectName: "sketch.add"
            anchors.verticalCenter: parent.verticalCenter
            visible: root.points > 0
            text: qsTr("Add")
            onClicked: root.addTyped()
        }
        CheckRow {
            objectName: "sketch.freehand"
            anchors.verticalCenter: parent.verticalCenter
            visible: root.points === 0 && root.editor.tool !== FieldEditor.Gate
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
            enabled: root.points >= root.needed
            onClicked: root.editor.finishSketch()
        }
    }

    Caption {
        id: takingBack

        objectName: "sketch.takingBack"
        anchors { left: parent.left; leftMargin: 16; bottom: parent.bottom; bottomMargin: 9 }
        visible: root.points > 0
        text: qsTr("Backspace or Ctrl+Z takes the last point back")
    }

    function addTyped(): void {
        if (Display.quantities.isValue(length.text, QuantityText.Length) && Display.quantities.isValue(bearing.text, QuantityText.Angle))
            root.editor.addPointBy(Display.quantities.value(length.text, QuantityText.Length), Display.quantities.value(bearing.text, QuantityText.Angle));
    }
}
