import QtQml

/// Commands that belong together: a menu, or a menu in a menu. Its title follows the language, the group stays.
QtObject {
    required property string title
}
