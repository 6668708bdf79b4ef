import QtQuick

/// Says what goes into an entry as long as it is empty.
BodyText {
    anchors {
        left: parent.left
        right: parent.right
        margins: 12
        verticalCenter: parent.verticalCenter
    }
    color: Theme.muted
    elide: Text.ElideRight
    Accessible.ignored: true
}
