import QtQuick
import QtQuick.Templates as T

/// Scrolls what does not fit, with a bar; what the keys go to is brought into view.
Flickable {
    id: root

    /// Of what lies behind it.
    property color ground: Theme.panel
    readonly property Item focused: Window.activeFocusItem

    boundsBehavior: Flickable.StopAtBounds
    clip: true
    // Fractions of a pixel are nothing to scroll for.
    interactive: contentHeight > height + 1
    onFocusedChanged: {
        // A click is not to lose what it was on; a dialog begins at its top.
        if (focused && focused.focusReason !== Qt.MouseFocusReason && focused.focusReason !== Qt.PopupFocusReason && root.holds(focused))
            root.bringIntoView(focused);
    }

    T.ScrollBar.vertical: T.ScrollBar {
        id: bar

        width: 8
        padding: 2
        contentItem: Rectangle {
            radius: 2
            color: bar.pressed ? Theme.muted : Theme.line
            visible: root.interactive
        }
    }

    // Below the edge there is more.
    Rectangle {
        parent: root
        z: 1
        anchors { left: parent.left; right: parent.right; bottom: parent.bottom }
        height: 28
        visible: root.interactive && root.contentY < root.contentHeight - root.height - 4
        gradient: Gradient {
            GradientStop { position: 0; color: Qt.alpha(root.ground, 0) }
            GradientStop { position: 1; color: root.ground }
        }
    }

    function scrollBy(pixels: real): void {
        root.contentY = Math.max(0, Math.min(root.contentHeight - root.height, root.contentY + pixels));
    }
    function holds(item: Item): bool {
        for (let above = item.parent; above; above = above.parent) {
            if (above === root.contentItem)
                return true;
        }
        return false;
    }
    function bringIntoView(item: Item): void {
        const margin = 12;
        const top = item.mapToItem(root.contentItem, 0, 0).y - margin;
        const bottom = top + item.height + 2 * margin;
        const most = Math.max(0, root.contentHeight - root.height);
        if (top < root.contentY)
            root.contentY = Math.max(0, top);
        else if (bottom > root.contentY + root.height)
            root.contentY = Math.min(most, Math.min(top, bottom - root.height));
    }
}
