pragma ComponentBehavior: Bound
import QtQuick
import Furrow.Controls
import Furrow.Text

/// One setting of a step: its name above, below it the field that suits its kind.
Column {
    id: root

    required property ParameterModel parameters
    required property int index
    required property string key
    required property string name
    required property string description
    required property int kind
    required property real value
    required property string autoText
    required property bool canBeAuto
    required property int quantity
    required property real from
    required property real to
    required property real step
    required property int decimals
    required property real sliderTo
    required property list<string> choices
    required property int choiceIndex
    required property string choiceHint
    required property bool checked
    required property string text
    required property int picking
    required property string picked
    /// Needs the whole width of the panel.
    readonly property bool wide: kind === ParameterModel.Flag || kind === ParameterModel.Text || sliderTo > 0 || longTexts || kind === ParameterModel.Choice && index === 0
    /// What half the panel could not show, in this language.
    readonly property bool longTexts: metrics.advanceWidth(name) > 150 || choices.some(choice => metrics.advanceWidth(choice) > 96)

    /// Got by clicks on the map: its text is there for those who want it.
    readonly property bool onMap: kind === ParameterModel.Text && picking !== ParameterModel.Pick.None && picking !== ParameterModel.Pick.File
    property bool asText: false
    /// Its field is to come, and to get the keys.
    property bool textAsked: false
    signal textWanted()

    spacing: 5
    onPositioningComplete: {
        // With the keys it is scrolled to, so it has to be in its place, as all around it.
        if (root.textAsked)
            Qt.callLater(() => root.textWanted());
        root.textAsked = false;
    }

    FontMetrics {
        id: metrics

        font {
            family: Theme.family
            pixelSize: Theme.bodySize
        }
    }
    Item {
        width: parent.width
        height: 16
        visible: root.kind !== ParameterModel.Flag

        Caption {
            anchors { left: parent.left; right: auto.left; verticalCenter: parent.verticalCenter }
            text: root.name
            elide: Text.ElideRight
        }
        SmallButton {
            id: auto

            objectName: root.key + ".auto"
            anchors { right: parent.right; rightMargin: -6; verticalCenter: parent.verticalCenter }
            visible: root.canBeAuto && root.autoText.length === 0
            width: visible ? implicitWidth : 0
            text: qsTr("Auto")
            Accessible.name: qsTr("%1: let Furrow choose").arg(root.name)
            onClicked: root.parameters.setAuto(root.index)
        }
        SmallButton {
            objectName: root.key + ".asText"
            anchors { right: parent.right; rightMargin: -6; verticalCenter: parent.verticalCenter }
            visible: root.onMap
            checkable: true
            checked: root.asText
            text: qsTr("As text")
            Accessible.name: qsTr("%1 as text").arg(root.name)
            onToggled: {
                root.asText = checked;
                root.textAsked = checked;
            }
        }
    }
    Loader {
        active: root.onMap
        visible: active
        width: parent.width
        sourceComponent: places
    }
    Loader {
        active: !root.onMap || root.asText
        visible: active
        width: parent.width
        sourceComponent: root.kind === ParameterModel.Choice ? choice : root.kind === ParameterModel.Flag ? flag : root.kind === ParameterModel.Text ? words : number
    }
    Loader {
        active: root.sliderTo > 0
        visible: active
        width: parent.width
        sourceComponent: slider
    }
    Caption {
        width: parent.width
        visible: text.length > 0
        text: root.kind === ParameterModel.Choice ? (root.index === 0 ? root.choiceHint : "") : root.wide ? root.description : ""
        wrapMode: Text.WordWrap
        lineHeight: 1.15
    }

    Component {
        id: number

        NumberField {
            objectName: root.key
            name: root.name
            value: root.value
            autoText: root.autoText
            from: root.from
            to: root.to
            step: root.step
            decimals: root.decimals
            kind: root.quantity
            onCommitted: newValue => root.parameters.setNumber(root.index, newValue)
            onCleared: if (root.canBeAuto) root.parameters.setAuto(root.index)
        }
    }
    Component {
        id: slider

        ValueSlider {
            objectName: root.key + ".slider"
            name: root.name
            from: root.from
            to: root.sliderTo
            stepSize: Display.quantities.roundStep(root.step, root.quantity)
            value: root.value
            property bool dragged: false

            onMoved: {
                dragged = pressed;
                root.parameters.setNumber(root.index, value, pressed);
            }
            onPressedChanged: {
                if (!pressed && dragged)
                    root.parameters.setNumber(root.index, value, false);
                dragged = false;
            }
        }
    }
    Component {
        id: choice

        ChoiceField {
            objectName: root.key
            name: root.name
            model: root.choices
            chosen: root.choiceIndex
            onActivated: chosen => root.parameters.setChoice(root.index, chosen)
        }
    }
    Component {
        id: places

        Item {
            implicitHeight: Theme.controlHeight

            BodyText {
                objectName: root.key + ".picked"
                anchors { left: parent.left; right: remove.left; rightMargin: 8; verticalCenter: parent.verticalCenter }
                text: root.picked.length > 0 ? root.picked : qsTr("not chosen")
                color: root.picked.length > 0 ? Theme.ink : Theme.muted
                elide: Text.ElideRight
            }
            SmallButton {
                id: remove

                objectName: root.key + ".remove"
                anchors { right: onMapButton.left; rightMargin: visible ? 8 : 0; verticalCenter: parent.verticalCenter }
                visible: root.text.length > 0
                width: visible ? implicitWidth : 0
                text: qsTr("Remove")
                Accessible.name: qsTr("%1: remove").arg(root.name)
                onClicked: root.parameters.setText(root.index, "")
            }
            PushButton {
                id: onMapButton

                objectName: root.key + ".pick"
                anchors.right: parent.right
                text: qsTr("On the map")
                onClicked: root.parameters.pick(root.index)
            }
        }
    }
    Component {
        id: words

        Item {
            implicitHeight: entry.implicitHeight

            Connections {
                target: root

                function onTextWanted() {
                    entry.forceActiveFocus(Qt.TabFocusReason);
                }
            }
            TextEntry {
                id: entry

                objectName: root.key
                anchors { left: parent.left; right: fileButton.left; rightMargin: fileButton.visible ? 8 : 0 }
                name: root.name
                value: root.text
                placeholderText: root.onMap ? qsTr("as text") : ""
                accepts: entered => root.parameters.accepts(root.index, entered)
                onCommitted: entered => root.parameters.setText(root.index, entered)
            }
            PushButton {
                id: fileButton

                objectName: root.key + ".pick"
                anchors.right: parent.right
                visible: root.picking === ParameterModel.Pick.File
                width: visible ? implicitWidth : 0
                text: qsTr("Choose…")
                onClicked: root.parameters.pick(root.index)
            }
        }
    }
    Component {
        id: flag

        CheckRow {
            objectName: root.key
            text: root.name
            checked: root.checked
            onToggled: root.parameters.setFlag(root.index, checked)
        }
    }
}
