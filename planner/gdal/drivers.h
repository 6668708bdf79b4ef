#pragma once

namespace furrow {

/// Makes GDAL ready, once for the whole process; everything that calls GDAL calls this first. Only the
/// formats that Furrow reads or writes are left, each in files of their own; what fetches from a network is
/// taken out: drivers of services, GDAL's ways to read from the web and from other programs, its downloads,
/// PROJ's grids.
///
/// Cost: some milliseconds, the first time. Thread-safe.
void registerGdalDrivers();

}  // namespace furrow
