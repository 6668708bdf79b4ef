import QtQuick
import Furrow.Controls

/// What this program is: version, licence, and whose work is in it.
ThemedDialog {
    id: root

    required property string version

    objectName: "aboutDialog"
    title: qsTr("Furrow %1").arg(version)
    width: 520
    closePolicy: ThemedDialog.CloseOnEscape | ThemedDialog.CloseOnPressOutside

    BodyText {
        width: parent.width
        text: qsTr("Furrow plans how a machine covers a farm field.")
        wrapMode: Text.WordWrap
    }
    BodyText {
        objectName: "about.licence"
        width: parent.width
        text: qsTr("Free software under the BSD 3-Clause licence: use it, change it and pass it on, without any warranty.")
        wrapMode: Text.WordWrap
        lineHeight: 1.15
    }
    BodyText {
        width: parent.width
        text: qsTr("The methods follow the Fields2Cover paper (Mier, Valente and de Bruin, 2023) and the sources that the design names.")
        wrapMode: Text.WordWrap
        lineHeight: 1.15
    }
    BodyText {
        objectName: "about.credits"
        width: parent.width
        text: qsTr("Built with %1.").arg("Qt 6, GEOS, GDAL, PROJ, Eigen, oneTBB, nlohmann/json, pugixml, CLI11, SQLite, Protobuf, zlib, zstd, LZ4, libqrencode, Inter, Natural Earth")
        wrapMode: Text.WordWrap
        lineHeight: 1.15
        color: Theme.muted
    }
    PushButton {
        objectName: "about.close"
        focus: true
        text: qsTr("Close")
        onClicked: root.close()
    }
}
