import Furrow.Controls

/// Help.
MenuCommands {
    id: root

    signal guideRequested()
    signal tourRequested()
    signal keysRequested()
    signal troubleRequested()
    signal aboutRequested()

    title: qsTr("Help")
    commands: [
        Command {
            objectName: "command.guide"
            group: root
            text: qsTr("Guide")
            shortcut: "F1"
            keywords: qsTr("help manual how to documentation")
            onTriggered: root.guideRequested()
        },
        Command {
            objectName: "command.tour"
            group: root
            text: qsTr("Take the tour")
            keywords: qsTr("help introduction first start")
            onTriggered: root.tourRequested()
        },
        Command {
            objectName: "command.keys"
            group: root
            text: qsTr("Keys and mouse")
            shortcut: "Ctrl+F1"
            keywords: qsTr("shortcuts help")
            onTriggered: root.keysRequested()
        },
        Command {
            objectName: "command.trouble"
            ruled: true
            group: root
            text: qsTr("Report a problem…")
            keywords: qsTr("bug crash support error")
            onTriggered: root.troubleRequested()
        },
        Command {
            objectName: "command.about"
            ruled: true
            group: root
            text: qsTr("About Furrow")
            keywords: qsTr("version licence credits")
            onTriggered: root.aboutRequested()
        }
    ]
}
