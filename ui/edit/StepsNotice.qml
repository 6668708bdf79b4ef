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
    /// Of the field whose outline would be refused, and why.
    property string failedId: ""
    property string refusal: ""

    objectName: "outlineSteps"
    visible: !editor.drawing && editor.outlineSteps > 0 && (failed || !closed.includes(editor.fieldId))
    failed: failedId === editor.fieldId
    text: qsTr("The outline has %1 steps of about %2 %3, like the pixels of an image.").arg(editor.outlineSteps).arg(Display.quantities.text(editor.stepHeightM, QuantityText.Length, 1)).arg(Display.quantities.unit(QuantityText.Length))
    remedy: failed ? root.refusal : qsTr("No machine follows them. Straight edges lead through the middles of the steps.")

    PushButton {
        objectName: "outlineSteps.straighten"
        text: qsTr("Make them straight")
        onClicked: root.straighten(false)
    }
    PushButton {
        objectName: "outlineSteps.all"
        visible: root.fields > 1
        text: qsTr("In all fields")
        onClicked: root.straighten(true)
    }
    PushButton {
        objectName: "outlineSteps.close"
        text: qsTr("Close")
        onClicked: {
            root.failedId = "";
            root.closed = root.closed.concat([root.editor.fieldId]);
        }
    }

    function straighten(all: bool): void {
        root.editor.straightenSteps(all);
        root.failedId = root.editor.outlineSteps > 0 ? root.editor.fieldId : "";
        root.refusal = root.editor.stepsRefusal();
    }
}
