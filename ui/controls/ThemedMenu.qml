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
        interactive: contentHeight > height + 1
        clip: true
        currentIndex: root.currentIndex

        T.ScrollBar.vertical: T.ScrollBar {
            id: bar

            width: 6
            contentItem: Rectangle {
                radius: 3
                color: Theme.line
                visible: bar.size < 1
            }
        }
    }

    function widest(): real {
        let width = 0;
        for (let i = 0; i < root.count; ++i)
            width = Math.max(width, root.itemAt(i)?.implicitWidth ?? 0);
        return Math.max(width, 272);
    }
}
