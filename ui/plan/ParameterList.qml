pragma ComponentBehavior: Bound
import QtQuick

/// All settings of a step, narrow ones two in a row.
Flow {
    id: root

    required property ParameterModel parameters

    spacing: 12

    Repeater {
        model: root.parameters

        ParameterField {
            parameters: root.parameters
            width: wide ? root.width : (root.width - root.spacing) / 2
        }
    }
}
