import Furrow.Controls

/// The commands of one menu of the window, in their order.
CommandGroup {
    property list<Command> commands
}
