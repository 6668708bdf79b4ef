#pragma once

#include <QStorageInfo>
#include <QString>

#include <vector>

namespace furrow {

/// What is plugged in: volumes where desktops mount sticks and drives, not folders of the system's own disk
/// that are mounted there. In the system's order.
std::vector<QStorageInfo> pluggedIn();

/// What people call a volume: its label, or the folder it is in.
QString nameOf(const QStorageInfo& volume);

}  // namespace furrow
