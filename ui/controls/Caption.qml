import QtQuick

/// The small label above a field, or the quiet line below a title.
BodyText {
    color: Theme.muted
    font.pixelSize: Theme.labelSize
}
