import QtQuick
import Furrow.Controls
import Furrow.Drive
import Furrow.Edit
import Furrow.Map
import Furrow.Plan
import Furrow.Project
import Furrow.Review

/// Plans: to compare, to drive through, to review.
MenuCommands {
    id: root

    required property FarmModel farm
    required property ShownPlan shown
    required property Planning planning
    required property ReviewModel review
    required property DriveThrough drive
    required property MapPage page
    required property bool twoMaps
    signal addPlanRequested()
    signal compareRequested()
    signal twoMapsRequested()
    signal trackRequested()
    signal renamePlanRequested()
    signal bestPlanRequested()
    signal orderRequested()
    signal driveBarRequested(on: bool)
    signal driveRequested(segment: int)
    signal commentRequested(atPlace: bool)
    signal sendRequested()
    signal takeInRequested()
    signal findingRequested(by: int)
    signal findingOfKindRequested(by: int)

    title: qsTr("Plan")

    readonly property CommandGroup driveMenu: CommandGroup { title: qsTr("Drive-through") }
    readonly property CommandGroup reviewMenu: CommandGroup { title: qsTr("Review") }
    readonly property CommandGroup findingsMenu: CommandGroup { title: qsTr("Findings") }

    commands: [
        Command {
            objectName: "command.addPlan"
            group: root
            text: qsTr("Add a plan…")
            keywords: qsTr("season operation copy")
            enabled: root.farm.hasField
            onTriggered: root.addPlanRequested()
        },
        Command {
            objectName: "command.compare"
            ruled: true
            group: root
            text: qsTr("Compare with another plan")
            shortcut: "Ctrl+D"
            keywords: qsTr("compare variants differences side by side better")
            enabled: root.shown.hasPlan
            onTriggered: root.compareRequested()
        },
        Command {
            objectName: "command.twoMaps"
            group: root
            text: qsTr("Compare on two maps")
            shortcut: "Ctrl+Shift+D"
            keywords: qsTr("compare side by side split map")
            checkable: true
            checked: root.twoMaps
            enabled: root.shown.hasPlan
            onTriggered: root.twoMapsRequested()
        },
        Command {
            objectName: "command.track"
            group: root
            text: qsTr("Compare with a recorded track…")
            shortcut: "Ctrl+T"
            keywords: qsTr("driven recorded GPX NMEA log cross-track error compare")
            onTriggered: root.trackRequested()
        },
        Command {
            objectName: "command.renamePlan"
            ruled: true
            group: root
            text: qsTr("Rename the plan…")
            enabled: root.farm.hasField
            onTriggered: root.renamePlanRequested()
        },
        Command {
            objectName: "command.removePlan"
            group: root
            text: qsTr("Remove the plan")
            keywords: qsTr("delete")
            enabled: root.farm.plans.length > 1
            onTriggered: root.farm.removePlan()
        },
        Command {
            objectName: "command.planAgain"
            ruled: true
            group: root
            text: qsTr("Plan again")
            shortcut: "F5"
            enabled: root.farm.hasField
            onTriggered: root.planning.planAgain()
        },
        Command {
            objectName: "command.bestPlan"
            group: root
            text: qsTr("Find the best plan…")
            shortcut: "Ctrl+B"
            keywords: qsTr("quickest optimise compare alternatives")
            enabled: root.farm.hasField
            onTriggered: root.bestPlanRequested()
        },
        Command {
            objectName: "command.order"
            group: root
            text: qsTr("Change the order by hand…")
            keywords: qsTr("order swaths list drag sequence")
            enabled: root.planning.order.count > 1
            onTriggered: root.orderRequested()
        },
        Command {
            objectName: "command.drive"
            group: root
            submenu: root.driveMenu
            name: qsTr("Drive through the plan")
            text: root.drive.playing ? qsTr("Pause the drive") : name
            shortcut: "Ctrl+Space"
            keywords: qsTr("drive play pause simulate machine")
            enabled: root.drive.available
            onTriggered: {
                root.driveBarRequested(true);
                root.drive.playing = !root.drive.playing;
            }
        },
        Command {
            objectName: "command.driveHere"
            group: root
            submenu: root.driveMenu
            text: qsTr("Drive from what is selected")
            keywords: qsTr("drive play here swath turn")
            enabled: root.drive.available && root.page.editor.selectedSegment >= 0
            onTriggered: root.driveRequested(root.page.editor.selectedSegment)
        },
        Command {
            objectName: "command.driveFaster"
            group: root
            submenu: root.driveMenu
            text: qsTr("Drive faster")
            keywords: qsTr("pace speed")
            enabled: root.drive.available
            onTriggered: root.drive.faster()
        },
        Command {
            objectName: "command.driveSlower"
            group: root
            submenu: root.driveMenu
            text: qsTr("Drive slower")
            keywords: qsTr("pace speed")
            enabled: root.drive.available
            onTriggered: root.drive.slower()
        },
        Command {
            objectName: "command.commentPlace"
            group: root
            submenu: root.reviewMenu
            text: qsTr("Comment on a place…")
            shortcut: "Ctrl+M"
            keywords: qsTr("review note remark pin")
            enabled: root.shown.hasPlan
            onTriggered: root.commentRequested(true)
        },
        Command {
            objectName: "command.commentPlan"
            group: root
            submenu: root.reviewMenu
            text: qsTr("Comment on the whole plan…")
            keywords: qsTr("review note remark")
            enabled: root.shown.hasPlan
            onTriggered: root.commentRequested(false)
        },
        Command {
            objectName: "command.sendReview"
            group: root
            submenu: root.reviewMenu
            text: root.review.sendText
            keywords: qsTr("contractor share file approve")
            enabled: root.shown.hasPlan
            onTriggered: root.sendRequested()
        },
        Command {
            objectName: "command.takeInReview"
            group: root
            submenu: root.reviewMenu
            text: qsTr("Take in a review that came back…")
            keywords: qsTr("merge comments contractor")
            enabled: root.farm.hasField
            onTriggered: root.takeInRequested()
        },
        Command {
            objectName: "command.nextFinding"
            group: root
            submenu: root.findingsMenu
            text: qsTr("Next finding")
            shortcut: "F8"
            keywords: qsTr("problem check step through")
            enabled: root.shown.hasPlan
            onTriggered: root.findingRequested(1)
        },
        Command {
            objectName: "command.previousFinding"
            group: root
            submenu: root.findingsMenu
            text: qsTr("Previous finding")
            shortcut: "Shift+F8"
            keywords: qsTr("problem check step back")
            enabled: root.shown.hasPlan
            onTriggered: root.findingRequested(-1)
        },
        Command {
            objectName: "command.nextOfKind"
            group: root
            submenu: root.findingsMenu
            text: qsTr("Next finding of the same kind")
            shortcut: "Ctrl+F8"
            keywords: qsTr("problem check step through")
            enabled: root.shown.hasPlan
            onTriggered: root.findingOfKindRequested(1)
        },
        Command {
            objectName: "command.previousOfKind"
            group: root
            submenu: root.findingsMenu
            text: qsTr("Previous finding of the same kind")
            shortcut: "Ctrl+Shift+F8"
            keywords: qsTr("problem check step back")
            enabled: root.shown.hasPlan
            onTriggered: root.findingOfKindRequested(-1)
        }
    ]
}
