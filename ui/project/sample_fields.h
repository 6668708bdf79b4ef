#pragma once

#include <QString>
#include <QStringList>

namespace furrow {

/// A field that comes with the program.
struct SampleField {
    QString name;
    QString resource;
};

QList<SampleField> sampleFields();

}  // namespace furrow
