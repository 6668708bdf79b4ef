pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Window
import Furrow.Controls
import Furrow.Text

/// One layer of imagery: shown or not, how strong, its place in the order, and what is wrong with its file.
Column {
    id: root

    required property ImageryModel imagery
    required property int index
    required property string name
    required property string path
    required property bool shown
    required property real strength
    required property int state
    required property string problem
    required property string remedy
    required property bool heights
    required property bool tiles
    required property bool rowsFromSouth
    property real zoomLevel: 3
    readonly property bool ready: state === ImageryModel.Ready
    readonly property real contourStep: ready && heights ? root.imagery.contourStep(root.index, root.zoomLevel + Math.log2(Screen.devicePixelRatio)) : 0
    signal areaRequested()

    component Step: ToolIconButton {
        implicitWidth: Theme.controlHeight
        implicitHeight: Theme.controlHeight
        hintBelow: true
    }

    objectName: "imagery." + index
    spacing: 2

    Item {
        width: parent.width
        height: Theme.controlHeight

        CheckRow {
            objectName: "imagery.%1.shown".arg(root.index)
            anchors { left: parent.left; right: buttons.left; rightMargin: 4; verticalCenter: parent.verticalCenter }
            text: root.name
            checked: root.shown
            clip: true
            onToggled: root.imagery.show(root.index, checked)
        }
        Row {
            id: buttons

            anchors { right: parent.right; verticalCenter: parent.verticalCenter }

            Step {
                objectName: "imagery.%1.fit".arg(root.index)
                iconName: "fit"
                hint: qsTr("Show all of %1").arg(root.name)
                enabled: root.ready
                onClicked: root.areaRequested()
            }
            Step {
                objectName: "imagery.%1.up".arg(root.index)
                iconName: "chevron-up"
                hint: qsTr("Move %1 up").arg(root.name)
                visible: root.imagery.count > 1
                enabled: root.index > 0
                onClicked: root.imagery.move(root.index, -1)
            }
            Step {
                objectName: "imagery.%1.down".arg(root.index)
                iconName: "chevron-down"
                hint: qsTr("Move %1 down").arg(root.name)
                visible: root.imagery.count > 1
                enabled: root.index + 1 < root.imagery.count
                onClicked: root.imagery.move(root.index, 1)
            }
            Step {
                objectName: "imagery.%1.remove".arg(root.index)
                iconName: "trash"
                hint: qsTr("Remove %1").arg(root.name)
                onClicked: root.imagery.remove(root.index)
            }
        }
    }
    ValueSlider {
        objectName: "imagery.%1.opacity".arg(root.index)
        x: 26
        width: parent.width - 26
        visible: root.ready && root.shown
        name: qsTr("How strong %1 is").arg(root.name)
        from: 0.1
        to: 1
        stepSize: 0.05
        value: root.strength
        onMoved: root.imagery.setOpacity(root.index, value, pressed)
        onPressedChanged: {
            if (!pressed)
                root.imagery.setOpacity(root.index, value, false);
        }
    }
    Caption {
        x: 26
        width: parent.width - 26
        visible: root.state === ImageryModel.Opening
        text: qsTr("Opening …")
    }
    Caption {
        x: 26
        width: parent.width - 26
        visible: root.contourStep > 0
        text: qsTr("Contour lines every %1").arg(Display.quantities.scaleText(root.contourStep))
    }
    CheckRow {
        objectName: "imagery.%1.tms".arg(root.index)
        x: 26
        width: parent.width - 26
        visible: root.ready && root.tiles
        text: qsTr("Rows count from the south (TMS)")
        checked: root.rowsFromSouth
        onToggled: root.imagery.setRowsFromSouth(root.index, checked)
    }
    NoticeBar {
        objectName: "imagery.%1.problem".arg(root.index)
        width: parent.width
        visible: root.problem.length > 0
        text: root.problem
        remedy: root.remedy
    }
    Row {
        visible: root.problem.length > 0
        spacing: 8

        SmallButton {
            objectName: "imagery.%1.again".arg(root.index)
            text: qsTr("Try again")
            onClicked: root.imagery.tryAgain(root.index)
        }
        Caption {
            width: root.width - 90
            anchors.verticalCenter: parent.verticalCenter
            text: root.path
            elide: Text.ElideMiddle
        }
    }
}
