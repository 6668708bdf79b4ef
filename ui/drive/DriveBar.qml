pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T
import Furrow.Controls

/// Plays the drive over the plan: when, how fast, and what the machine does there.
Rectangle {
    id: root

    required property DriveThrough drive
    /// The map keeps the machine in its middle.
    property bool follows: false
    /// With room for little.
    property bool slim: false
    /// The texts stand below the slider: beside it they would leave it too little.
    readonly property bool narrow: width < 850
    /// And less of everything.
    readonly property bool tight: width < 520
    readonly property bool tiny: width < 320
    signal hideRequested()

    objectName: "driveBar"
    implicitHeight: slim ? 52 : 68
    color: Theme.panel
    Accessible.role: Accessible.ToolBar
    Accessible.name: qsTr("Drive-through")

    FrameAnimation {
        running: root.drive.playing
        onTriggered: root.drive.advance(frameTime)
    }
    Rectangle {
        width: parent.width
        height: Theme.hairline
        color: Theme.line
    }
    T.Button {
        id: play

        objectName: "drive.play"
        x: root.tight ? 8 : 16
        anchors.verticalCenter: parent.verticalCenter
        width: root.slim ? 36 : 40
        height: width
        focusPolicy: Qt.StrongFocus
        enabled: root.drive.available
        Accessible.name: root.drive.playing ? qsTr("Pause") : qsTr("Drive through the plan")
        onClicked: root.drive.playing = !root.drive.playing

        background: Rectangle {
            radius: width / 2
            color: play.hovered ? Theme.accentHover : Theme.accent
            opacity: play.enabled ? 1 : 0.45

            Focusable { control: play; radius: width / 2 }
        }
        contentItem: Item {
            Icon {
                anchors.centerIn: parent
                name: root.drive.playing ? "pause" : "play"
                color: Theme.accentInk
            }
        }
    }
    BodyText {
        id: now

        objectName: "drive.time"
        anchors { left: play.right; leftMargin: root.tight ? 0 : 14; verticalCenter: slider.verticalCenter }
        width: root.tight ? 0 : 58
        visible: !root.tight
        text: root.drive.timeText
        font.features: { "tnum": 1 }
    }
    ValueSlider {
        id: slider

        objectName: "drive.slider"
        anchors { left: now.right; right: root.tight ? pace.left : whole.left; leftMargin: 8; rightMargin: root.tight ? 8 : 12 }
        y: (parent.height - height - (root.narrow ? below.height : 0)) / 2
        name: qsTr("Moment of the drive")
        enabled: root.drive.available
        from: 0
        to: Math.max(1, root.drive.duration)
        stepSize: 10
        snapMode: T.Slider.NoSnap
        value: root.drive.time
        Accessible.description: root.drive.stateText
        onMoved: root.drive.time = value
        Keys.onPressed: event => {
            event.accepted = true;
            if (event.key === Qt.Key_PageDown)
                root.drive.stepSegment(1);
            else if (event.key === Qt.Key_PageUp)
                root.drive.stepSegment(-1);
            else if (event.key === Qt.Key_Home)
                root.drive.time = 0;
            else if (event.key === Qt.Key_End)
                root.drive.time = root.drive.duration;
            else if (event.key === Qt.Key_Space)
                root.drive.playing = !root.drive.playing;
            else
                event.accepted = false;
        }
        // What was dragged no longer follows by itself.
        Binding on value {
            value: root.drive.time
            when: !slider.pressed
        }
    }
    BodyText {
        id: whole

        objectName: "drive.whole"
        anchors { right: pace.left; rightMargin: 14; verticalCenter: slider.verticalCenter }
        visible: !root.tight
        text: root.drive.durationText
        color: Theme.muted
        font.features: { "tnum": 1 }
    }
    T.Button {
        id: pace

        objectName: "drive.pace"
        anchors { right: follow.left; rightMargin: root.tiny ? 0 : 6; verticalCenter: parent.verticalCenter }
        width: root.tiny ? 0 : 46
        visible: !root.tiny
        height: Theme.controlHeight
        focusPolicy: Qt.StrongFocus
        enabled: root.drive.available
        Accessible.name: qsTr("Pace: %1 times as fast").arg(root.drive.pace)
        Keys.onUpPressed: root.drive.faster()
        Keys.onDownPressed: root.drive.slower()
        onClicked: root.drive.pace = root.drive.pace === 64 ? 1 : root.drive.pace * 2

        background: Rectangle {
            radius: Theme.radius
            color: pace.hovered ? Theme.hover : Theme.panel
            border.width: Theme.hairline
            border.color: Theme.line

            Focusable { control: pace }
        }
        contentItem: BodyText {
            text: qsTr("%1×").arg(root.drive.pace)
            horizontalAlignment: Text.AlignHCenter
            verticalAlignment: Text.AlignVCenter
        }
        WheelHandler {
            onWheel: event => event.angleDelta.y > 0 ? root.drive.faster() : root.drive.slower()
        }
    }
    ToolIconButton {
        id: follow

        objectName: "drive.follow"
        anchors { right: texts.visible ? texts.left : close.left; rightMargin: texts.visible ? 12 : 0; verticalCenter: parent.verticalCenter }
        // The menu has it, too.
        width: root.tight ? 0 : implicitWidth
        visible: !root.tight
        iconName: "follow"
        hint: root.follows ? qsTr("Let the map rest") : qsTr("Follow the machine")
        checked: root.follows
        onClicked: root.follows = !root.follows
    }
    Column {
        id: texts

        anchors { right: close.left; rightMargin: 4; verticalCenter: parent.verticalCenter }
        width: Math.min(360, root.width * 0.38)
        visible: !root.narrow
        spacing: 1

        BodyText {
            objectName: "drive.state"
            width: parent.width
            text: root.drive.stateText
            wrapMode: Text.WordWrap
            maximumLineCount: 2
            elide: Text.ElideRight
            font.pixelSize: 12
        }
        Caption {
            objectName: "drive.figures"
            width: parent.width
            text: root.drive.figuresText
            elide: Text.ElideRight
            font.features: { "tnum": 1 }
        }
    }
    Column {
        id: below

        anchors { left: slider.left; right: pace.left; rightMargin: 8; top: slider.bottom }
        visible: root.narrow

        Caption {
            objectName: "drive.stateBelow"
            width: parent.width
            text: root.tight ? [root.drive.timeText, root.drive.stateText].join(" · ") : root.drive.stateText
            elide: Text.ElideRight
            font.features: { "tnum": 1 }
        }
        Caption {
            objectName: "drive.figuresBelow"
            width: parent.width
            visible: !root.slim
            text: root.drive.figuresText
            elide: Text.ElideRight
            font.features: { "tnum": 1 }
        }
    }
    ToolIconButton {
        id: close

        objectName: "drive.hide"
        anchors { right: parent.right; rightMargin: 2; verticalCenter: parent.verticalCenter }
        iconName: "close"
        hint: qsTr("Hide the drive-through")
        onClicked: root.hideRequested()
    }
}
