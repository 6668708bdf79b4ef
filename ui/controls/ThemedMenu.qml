pragma ComponentBehavior: Bound
import QtQuick
import QtQuick.Templates as T

/// A menu in the window's look.
T.Menu {
    id: root

    implicitWidth: widest() + leftPadding + rightPadding
    implicitHeight: contentItem.implicitHeight + topPadding + bottomPadding
    padding: 4
    margins: 4
    overlap: 1
    enter: Transition {
        NumberAnimation { property: "opacity"; from: 0; to: 1; duration: Theme.motion }
    }
    delegate: ThemedMenuItem {}
    background: Rectangle {
        radius: Theme.radius
        color: Theme.panel
        border.width: Theme.hairline
        border.color: Theme.line

        SoftShadow { radius: Theme.radius }
    }
    contentItem: ListView {
        implicitHeight: contentHeight
        model: root.contentModel
        interactive: Window.window ? contentHeight > Window.window.height - 24 : false
        clip: true
        currentIndex: root.currentIndex
    }

    function widest(): real {
        let width = 0;
        for (let i = 0; i < root.count; ++i)
            width = Math.max(width, root.itemAt(i)?.implicitWidth ?? 0);
        return Math.max(width, 272);
    }
}
