pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// The user's guide beside the map, so that it can be followed while it is read: the chapters, a search, a chapter.
Rectangle {
    id: root

    readonly property alias guide: guide
    /// To be gone to once it is laid out.
    property int wantedBlock: -1
    signal closeRequested()

    color: Theme.panel

    Guide {
        id: guide

        onChapterChanged: flick.contentY = 0
    }
    Shortcut {
        enabled: root.visible
        sequences: [StandardKey.Cancel]
        onActivated: root.back()
    }

    component Line: T.Button {
        id: line

        property string caption: ""

        height: texts.implicitHeight + 18
        focusPolicy: Qt.StrongFocus
        Accessible.name: caption.length > 0 ? text + ". " + caption : text

        background: Rectangle {
            radius: Theme.radius
            color: line.hovered ? Theme.hover : Theme.sunken

            Focusable { control: line }
        }
        contentItem: Item {
            Column {
                id: texts

                x: 14
                y: 9
                width: parent.width - 28
                spacing: 2

                BodyText {
                    width: parent.width
                    text: line.text
                    font.weight: Font.DemiBold
                    wrapMode: Text.WordWrap
                }
                Caption {
                    width: parent.width
                    visible: text.length > 0
                    text: line.caption
                    wrapMode: Text.WordWrap
                }
            }
        }
    }

    Rectangle {
        anchors { left: parent.left; top: parent.top; bottom: parent.bottom }
        width: Theme.hairline
        color: Theme.line
    }
    Item {
        id: head

        anchors { left: parent.left; right: parent.right; top: parent.top; leftMargin: 20; rightMargin: 12; topMargin: 12 }
        height: 38

        ToolIconButton {
            id: backButton

            objectName: "guide.back"
            anchors.verticalCenter: parent.verticalCenter
            visible: guide.chapter >= 0
            iconName: "chevron-left"
            hint: qsTr("All chapters")
            hintBelow: true
            onClicked: guide.chapter = -1
        }
        BodyText {
            objectName: "guide.title"
            anchors { left: backButton.visible ? backButton.right : parent.left; leftMargin: backButton.visible ? 4 : 0; right: closeButton.left; rightMargin: 8; verticalCenter: parent.verticalCenter }
            text: guide.chapter >= 0 ? guide.chapters[guide.chapter] : qsTr("Guide")
            elide: Text.ElideRight
            font.pixelSize: 18
            font.weight: Font.DemiBold
            Accessible.role: Accessible.Heading
            Accessible.name: text
        }
        ToolIconButton {
            id: closeButton

            objectName: "guide.close"
            anchors { right: parent.right; verticalCenter: parent.verticalCenter }
            iconName: "close"
            hint: qsTr("Close the guide (Esc)")
            hintBelow: true
            onClicked: root.closeRequested()
        }
    }
    TextEntry {
        id: search

        objectName: "guide.search"
        anchors { left: parent.left; right: parent.right; top: head.bottom; leftMargin: 20; rightMargin: 20; topMargin: 8 }
        visible: guide.chapter < 0
        name: qsTr("Search the guide")
        placeholderText: qsTr("Search the guide")
        onTextEdited: guide.query = text
    }
    ScrollArea {
        id: flick

        objectName: "guide.scroller"
        anchors { left: parent.left; right: parent.right; top: guide.chapter < 0 ? search.bottom : head.bottom; bottom: parent.bottom; leftMargin: 20; topMargin: 12; bottomMargin: 8 }
        // Texts and pictures get their heights one after the other.
        onContentHeightChanged: root.goToBlock()
        onMovementStarted: root.wantedBlock = -1
        contentHeight: (guide.chapter < 0 ? list : reading).height + 24

        Column {
            id: list

            width: flick.width - 20
            visible: guide.chapter < 0
            spacing: 8

            Repeater {
                model: search.text.length > 0 ? guide.hits : guide.chapters

                Line {
                    required property var modelData
                    required property int index

                    objectName: "guide.line." + index
                    width: list.width
                    text: modelData.title ?? modelData
                    caption: modelData.excerpt ?? ""
                    onClicked: modelData.title ? root.show(modelData.chapter, modelData.block) : root.show(index, 0)
                }
            }
            BodyText {
                objectName: "guide.nothing"
                width: parent.width
                visible: search.text.length > 0 && guide.hits.length === 0
                text: qsTr("Nothing is found. Try another word.")
                wrapMode: Text.WordWrap
                color: Theme.muted
            }
        }
        Column {
            id: reading

            width: flick.width - 20
            visible: guide.chapter >= 0
            spacing: 10

            Repeater {
                id: blocks

                model: guide.blocks

                Column {
                    id: block

                    required property var modelData
                    required property int index

                    width: reading.width
                    spacing: 4

                    BodyText {
                        objectName: "guide.block." + block.index
                        width: parent.width
                        visible: block.modelData.picture.length === 0
                        text: visible ? block.modelData.text : ""
                        textFormat: Text.MarkdownText
                        wrapMode: Text.WordWrap
                        lineHeight: 1.2
                    }
                    Image {
                        objectName: "guide.picture." + block.index
                        width: parent.width
                        height: visible && implicitWidth > 0 ? width * implicitHeight / implicitWidth : 0
                        visible: block.modelData.picture.length > 0
                        source: block.modelData.picture
                        fillMode: Image.PreserveAspectFit
                        smooth: true
                        mipmap: true
                        Accessible.role: Accessible.Graphic
                        Accessible.name: block.modelData.text
                    }
                    Caption {
                        width: parent.width
                        visible: block.modelData.picture.length > 0
                        text: visible ? block.modelData.text : ""
                        wrapMode: Text.WordWrap
                    }
                }
            }
        }
    }

    /// A chapter, at one of its blocks.
    function show(chapter: int, block: int): void {
        guide.chapter = chapter;
        root.wantedBlock = block;
        flick.forceActiveFocus();
        Qt.callLater(root.goToBlock);
    }
    function goToBlock(): void {
        const wanted = root.wantedBlock >= 0 ? blocks.itemAt(root.wantedBlock) : null;
        if (wanted)
            flick.contentY = Math.max(0, Math.min(wanted.y, flick.contentHeight - flick.height));
    }
    function begin(): void {
        guide.chapter = -1;
        search.text = "";
        guide.query = "";
        search.forceActiveFocus(Qt.TabFocusReason);
    }
    function back(): void {
        if (guide.chapter >= 0)
            guide.chapter = -1;
        else
            root.closeRequested();
    }
    Keys.onPressed: event => {
        const way = event.key === Qt.Key_Down ? 60 : event.key === Qt.Key_Up ? -60 : event.key === Qt.Key_PageDown ? flick.height - 40 : event.key === Qt.Key_PageUp ? 40 - flick.height : 0;
        if (way !== 0) {
            root.wantedBlock = -1;
            flick.scrollBy(way);
            event.accepted = true;
        }
    }
}
