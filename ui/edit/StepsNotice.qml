import QtQuick
import Furrow.Controls
import Furrow.Text

/// The outline was traced along the pixels of an image: says so, and offers to make it straight.
NoticeCard {
    id: root

    required property FieldEditor editor
    /// Fields in the project; with several, all can be made straight at once.
    property int fields: 1
    /// Of the fields for which it was closed.
    property list<string> closed: []
    /// There is something to make straight in the current field.
    readonly property bool offered: editor.outlineSteps > 0 && !closed.includes(editor.fieldId)

    objectName: "outlineSteps"
    visible: !editor.drawing && (offered || editor.stepsLeft.length > 0)
    failed: editor.stepsRefusal.length > 0
    text: !offered ? editor.stepsLeft : qsTr("The outline has %1 steps of about %2 %3, like the pixels of an image.").arg(editor.outlineSteps).arg(Display.quantities.text(editor.stepHeightM, QuantityText.Length, 1)).arg(Display.quantities.unit(QuantityText.Length))
    remedy: !offered ? qsTr("Made straight, their outlines would be refused. Open one of them to see why.") : [failed ? editor.stepsRefusal : qsTr("No machine follows them. Straight edges lead through the middles of the steps."), editor.stepsLeft].filter(part => part.length > 0).join(" ")

    PushButton {
        objectName: "outlineSteps.straighten"
        visible: root.offered
        text: qsTr("Make them straight")
        onClicked: root.editor.straightenSteps(false)
    }
    PushButton {
        objectName: "outlineSteps.all"
        visible: root.offered && root.fields > 1
        text: qsTr("In all fields")
        onClicked: root.editor.straightenSteps(true)
    }
    PushButton {
        objectName: "outlineSteps.close"
        text: qsTr("Close")
        onClicked: {
            if (root.offered)
                root.closed = root.closed.concat([root.editor.fieldId]);
            root.editor.forgetStepsLeft();
        }
    }

    // The menu has the command, too: why it failed is told where the card was closed.
    onFailedChanged: {
        if (failed)
            closed = closed.filter(id => id !== editor.fieldId);
    }
}
