#pragma once

#include "planner/core/result.h"
#include "planner/machine/machine.h"

#include <QString>

#include <vector>

namespace furrow {

/// Machines that the user keeps under names of their own, a file for each, beside those of the library.
class OwnMachines {
public:
    /// Reads those that are in the folder. A file that is no machine is left alone.
    void keepIn(const QString& folder);
    /// By their names.
    const std::vector<Machine>& machines() const { return machines_; }
    bool holds(const std::string& id) const;
    /// Keeps a machine under a name; one of that name is replaced. Gives the machine as it is kept.
    /// InputRefused: no name. WriteFailed: with the system's reason.
    Result<Machine> keep(const Machine& machine, const QString& name);
    void forget(const std::string& id);

private:
    QString fileOf(const std::string& id) const;
    void sort();

    QString folder_;
    std::vector<Machine> machines_;
};

}  // namespace furrow
