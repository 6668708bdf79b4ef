import QtQuick
import QtQuick.Layouts
import Furrow.Commands
import Furrow.Controls
import Furrow.Plan
import Furrow.Settings

/// Where the user is, and what is needed everywhere.
Rectangle {
    id: root

    required property Session session
    required property AppCommands commands
    property bool panelOffered: false
    property bool panelOpen: true
    property bool farmOpen: false
    property bool stepsOffered: true
    property bool stepsOpen: true
    readonly property alias exportButton: exportButton
    /// Names give way to the buttons up to here.
    readonly property real narrowestName: 64

    objectName: "topBar"
    implicitHeight: 52
    color: Theme.panel

    Rectangle {
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        height: Theme.hairline
        color: Theme.line
    }
    RowLayout {
        anchors { fill: parent; leftMargin: 16; rightMargin: 12 }
        spacing: 4

        BodyText {
            visible: root.width > 780
            text: "Furrow"
            color: Theme.accent
            font.pixelSize: 17
            font.weight: Font.Bold
        }
        ToolIconButton {
            objectName: "stepsSwitch"
            Layout.leftMargin: 8
            visible: root.stepsOffered
            iconName: "steps"
            hint: root.stepsOpen ? qsTr("Hide the steps") : qsTr("Show the steps")
            hintBelow: true
            checked: root.stepsOpen
            onClicked: root.commands.view.stepsRequested()
        }
        ToolIconButton {
            objectName: "farmButton"
            visible: root.session.farm.hasField
            iconName: "farm"
            hint: root.commands.named("farm").text
            hintBelow: true
            checked: root.farmOpen
            onClicked: root.commands.named("farm").trigger()
        }
        BodyText {
            objectName: "projectName"
            Layout.fillWidth: true
            Layout.preferredWidth: Math.ceil(implicitWidth)
            Layout.maximumWidth: Math.min(Math.ceil(implicitWidth), root.width * 0.16)
            // The title of the window says it, too.
            visible: root.session.farm.hasField && root.width > 780
            text: root.session.files.name.length > 0 ? root.session.files.name : qsTr("Not saved yet")
            color: Theme.muted
            elide: Text.ElideMiddle
        }
        Rectangle {
            objectName: "modifiedMark"
            visible: root.session.farm.hasField && root.session.document.modified
            Layout.preferredWidth: 7
            Layout.preferredHeight: 7
            radius: 3.5
            color: Theme.accent
            Accessible.role: Accessible.StaticText
            Accessible.name: qsTr("There are changes that are not saved")
        }
        BodyText {
            visible: root.session.farm.hasField && root.width > 780
            text: "/"
            color: Theme.muted
        }
        Crumb {
            objectName: "fieldCrumb"
            Layout.fillWidth: true
            Layout.minimumWidth: root.narrowestName
            Layout.preferredWidth: Math.ceil(implicitWidth)
            Layout.maximumWidth: Math.min(Math.ceil(implicitWidth), root.width * 0.2)
            visible: root.session.farm.hasField
            strong: true
            text: root.session.farm.fieldName
            choices: root.session.farm.fields
            current: root.session.farm.currentField
            commands: [root.commands.named("renameField"), root.commands.named("removeField")]
            onChosen: index => root.session.farm.currentField = index
        }
        BodyText {
            visible: root.session.farm.hasField
            text: "/"
            color: Theme.muted
        }
        Crumb {
            objectName: "planCrumb"
            Layout.fillWidth: true
            Layout.minimumWidth: root.narrowestName
            Layout.preferredWidth: Math.ceil(implicitWidth)
            Layout.maximumWidth: Math.min(Math.ceil(implicitWidth), root.width * 0.2)
            visible: root.session.farm.hasField
            text: root.session.farm.plans[root.session.farm.currentPlan] ?? ""
            choices: root.session.farm.plans
            current: root.session.farm.currentPlan
            commands: [root.commands.named("addPlan"), root.commands.named("renamePlan"), root.commands.named("removePlan")]
            onChosen: index => root.session.farm.currentPlan = index
        }
        Item { Layout.fillWidth: true }
        ToolIconButton {
            objectName: "undoButton"
            iconName: "undo"
            hint: root.commands.named("undo").text
            hintBelow: true
            enabled: root.commands.named("undo").enabled
            onClicked: root.commands.named("undo").trigger()
        }
        ToolIconButton {
            objectName: "redoButton"
            iconName: "redo"
            hint: root.commands.named("redo").text
            hintBelow: true
            enabled: root.commands.named("redo").enabled
            onClicked: root.commands.named("redo").trigger()
        }
        SearchButton {
            objectName: "searchButton"
            visible: root.width > 1100
            onClicked: root.commands.edit.paletteRequested()
        }
        ThemeSwitch { hintBelow: true }
        ToolIconButton {
            objectName: "panelSwitch"
            visible: root.panelOffered
            iconName: "panel"
            hint: root.panelOpen ? qsTr("Hide the results") : qsTr("Show the results")
            hintBelow: true
            checked: root.panelOpen
            onClicked: root.commands.view.panelRequested()
        }
        PushButton {
            objectName: "openButton"
            // The panel of the first step has it, too.
            visible: root.width > 720
            Layout.leftMargin: 4
            text: qsTr("Open")
            iconName: "open"
            onClicked: root.commands.file.openRequested()
        }
        PushButton {
            objectName: "compareButton"
            visible: root.width > 1000
            Layout.leftMargin: 4
            text: qsTr("Compare")
            enabled: root.session.shown.hasPlan
            onClicked: root.commands.named("compare").trigger()
        }
        PushButton {
            id: exportButton

            objectName: "exportButton"
            Layout.leftMargin: 4
            text: qsTr("Export")
            // There is nothing to take where there is no plan.
            primary: root.session.planning.state !== PlanState.Failed
            // What cannot be exported is told there, and why.
            enabled: root.session.farm.hasField
            onClicked: root.commands.file.exportRequested()
        }
    }
}
