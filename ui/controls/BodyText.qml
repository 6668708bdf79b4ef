import QtQuick

/// Text in the window's type, with figures of one width.
Text {
    color: Theme.ink
    font {
        family: Theme.family
        pixelSize: Theme.bodySize
        features: ({ "tnum": 1 })
    }
    textFormat: Text.PlainText
}
