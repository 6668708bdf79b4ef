#include "ui/files/sticks.h"

#include <QDir>
#include <QStringList>

#include <algorithm>
#include <iterator>

namespace furrow {

namespace {

bool isStick(const QStorageInfo& volume) {
    static const QStringList places{QStringLiteral("/media/"), QStringLiteral("/run/media/"),
                                    QStringLiteral("/mnt/"), QStringLiteral("/Volumes/")};
    const bool ready = volume.isValid() && volume.isReady() && !volume.isRoot();
    const bool disk = volume.device().startsWith("/dev/") && volume.device() != QStorageInfo::root().device();
    return ready && disk && std::ranges::any_of(places, [&volume](const QString& place) {
               return volume.rootPath().startsWith(place);
           });
}

}  // namespace

std::vector<QStorageInfo> pluggedIn() {
    std::vector<QStorageInfo> all;
    std::ranges::copy_if(QStorageInfo::mountedVolumes(), std::back_inserter(all), isStick);
    return all;
}

QString nameOf(const QStorageInfo& volume) {
    const QString label = volume.displayName();
    return label.startsWith(u'/') ? QDir{label}.dirName() : label;
}

}  // namespace furrow
