pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls
import Furrow.Files
import Furrow.Plan

/// The work order of a plan or of a farm: what stands on it on the left, its pages on the right.
T.Popup {
    id: root

    required property Printing printing
    required property Planning planning
    readonly property bool refused: printing.refusal.length > 0
    readonly property bool busy: printing.state === Printing.Making || printing.state === Printing.Writing
    readonly property bool canWrite: !refused && printing.pageCount > 0 && !busy
    readonly property real windowWidth: parent ? parent.width : 1200
    readonly property real windowHeight: parent ? parent.height : 800

    objectName: "printDialog"
    modal: true
    focus: true
    width: Math.min(1040, windowWidth - 32)
    height: Math.min(860, windowHeight - 32)
    padding: 24
    closePolicy: printing.state === Printing.Writing ? T.Popup.NoAutoClose : T.Popup.CloseOnEscape
    onAboutToShow: printing.open = true
    onOpened: pages.list.forceActiveFocus(Qt.TabFocusReason)
    onClosed: printing.open = false

    T.Overlay.modal: Rectangle { color: "#66000000" }
    enter: Transition {
        NumberAnimation { property: "opacity"; from: 0; to: 1; duration: Theme.motion }
    }
    background: Rectangle {
        radius: 14
        color: Theme.panel
        border.width: Theme.hairline
        border.color: Theme.line
    }
    contentItem: FocusScope {
        focus: true
        Accessible.role: Accessible.Dialog
        Accessible.name: title.text

        ScrollArea {
            id: form

            anchors { left: parent.left; top: parent.top; bottom: buttons.top; leftMargin: -6; bottomMargin: 14; topMargin: -4 }
            width: 376
            contentHeight: column.implicitHeight + 8

            Column {
                id: column

                x: 6
                y: 4
                width: 350
                spacing: 14

                BodyText {
                    id: title

                    width: parent.width
                    text: qsTr("Print the work order")
                    font.pixelSize: 18
                    font.weight: Font.DemiBold
                }
                Column {
                    width: parent.width
                    visible: root.printing.heading.length > 0
                    spacing: 2

                    BodyText {
                        objectName: "print.heading"
                        width: parent.width
                        text: root.printing.heading
                        font.weight: Font.DemiBold
                        wrapMode: Text.Wrap
                    }
                    Caption {
                        objectName: "print.details"
                        width: parent.width
                        text: root.printing.details
                        wrapMode: Text.WordWrap
                        lineHeight: 1.15
                    }
                }
                NoticeBar {
                    objectName: "print.refusal"
                    width: parent.width
                    visible: root.refused
                    text: root.printing.refusal
                }
                PushButton {
                    objectName: "print.planAgain"
                    visible: root.planning.state === PlanState.OutOfDate
                    text: qsTr("Plan again")
                    onClicked: root.planning.planAgain()
                }
                NoticeBar {
                    objectName: "print.blocking"
                    width: parent.width
                    visible: root.planning.state === PlanState.Problems
                    text: qsTr("%n problem(s) in this plan: it cannot be driven as drawn. The pages say so too.", "", root.planning.problemCount)
                }
                Row {
                    width: parent.width
                    spacing: 12

                    Column {
                        width: (parent.width - 12) / 2
                        spacing: 5

                        Caption { text: qsTr("Pages of") }
                        ChoiceField {
                            objectName: "print.scope"
                            width: parent.width
                            name: qsTr("Pages of")
                            model: root.printing.chosen.length > 0 ? [qsTr("This field"), qsTr("%n field(s) of the list", "", root.printing.fieldCount)] : root.printing.fieldCount > 1 ? [qsTr("This field"), qsTr("The whole farm (%1)").arg(root.printing.fieldCount)] : [qsTr("This field")]
                            chosen: root.printing.wholeFarm && (root.printing.fieldCount > 1 || root.printing.chosen.length > 0) ? 1 : 0
                            onActivated: index => root.printing.wholeFarm = index === 1
                        }
                    }
                    Column {
                        width: (parent.width - 12) / 2
                        spacing: 5

                        Caption { text: qsTr("Paper") }
                        ChoiceField {
                            objectName: "print.paper"
                            width: parent.width
                            name: qsTr("Paper")
                            model: [qsTr("A4"), qsTr("Letter")]
                            chosen: root.printing.paper
                            onActivated: index => root.printing.paper = index
                        }
                    }
                }
                Column {
                    width: parent.width
                    spacing: 5

                    Caption { text: qsTr("Printer") }
                    ChoiceField {
                        id: printer

                        objectName: "print.printer"
                        width: parent.width
                        name: qsTr("Printer")
                        enabled: root.printing.printers.length > 0
                        model: root.printing.printers.length > 0 ? root.printing.printers : [qsTr("No printer was found")]
                        chosen: root.printing.defaultPrinter
                    }
                }
                Rectangle {
                    width: parent.width
                    height: Theme.hairline
                    color: Theme.line
                }
                OrderForm {
                    width: parent.width
                    order: root.printing.order
                }
            }
        }
        PageList {
            id: pages

            anchors { left: form.right; right: parent.right; top: parent.top; bottom: buttons.top; leftMargin: 8; bottomMargin: 14 }
            printing: root.printing
        }
        Item {
            id: buttons

            anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
            height: row.implicitHeight + (outcome.visible ? outcome.height + 10 : 0)

            NoticeBar {
                id: outcome

                objectName: "print.outcome"
                width: parent.width
                visible: root.printing.message.length > 0
                failed: root.printing.state === Printing.Failed
                good: root.printing.state === Printing.Done
                text: root.printing.message
                remedy: root.printing.remedy
            }
            ProgressLine {
                objectName: "print.progress"
                anchors { left: parent.left; right: row.left; rightMargin: 16; verticalCenter: row.verticalCenter }
                visible: root.busy
                value: root.printing.progress
            }
            Row {
                id: row

                anchors { right: parent.right; bottom: parent.bottom }
                spacing: 8

                PushButton {
                    objectName: "print.close"
                    text: root.busy ? qsTr("Stop") : qsTr("Close")
                    onClicked: {
                        if (root.busy)
                            root.printing.cancel();
                        else
                            root.close();
                    }
                }
                PushButton {
                    objectName: "print.picture"
                    // A farm's first page has no map.
                    enabled: root.canWrite && !root.printing.wholeFarm
                    text: qsTr("Save picture…")
                    onClicked: {
                        pictureDialog.selectedFile = root.printing.suggestedFile("png");
                        pictureDialog.open();
                    }
                }
                PushButton {
                    objectName: "print.print"
                    enabled: root.canWrite && root.printing.printers.length > 0
                    text: qsTr("Print")
                    onClicked: root.printing.print(printer.currentIndex)
                }
                PushButton {
                    objectName: "print.pdf"
                    primary: true
                    enabled: root.canWrite
                    text: qsTr("Save as PDF…")
                    onClicked: {
                        pdfDialog.selectedFile = root.printing.suggestedFile("pdf");
                        pdfDialog.open();
                    }
                }
            }
        }
    }

    FileChooser {
        id: pdfDialog

        objectName: "pdfDialog"
        title: qsTr("Save the work order")
        fileMode: FileChooser.SaveFile
        defaultSuffix: "pdf"
        nameFilters: [qsTr("PDF (%1)").arg("*.pdf")]
        onAccepted: root.printing.save(selectedFile)
    }
    FileChooser {
        id: pictureDialog

        objectName: "pictureDialog"
        title: qsTr("Save the page with the map as a picture")
        fileMode: FileChooser.SaveFile
        defaultSuffix: "png"
        nameFilters: [qsTr("Pictures (%1)").arg("*.png *.svg")]
        onAccepted: root.printing.save(selectedFile)
    }
}
