#include "planner/gdal/drivers.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_http.h>
#include <cpl_string.h>
#include <cpl_vsi_virtual.h>
#include <gdal_priv.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <mutex>
#include <string_view>
#include <vector>

namespace furrow {

namespace {

/// Fields, pictures and heights, and what GDAL itself works in. None of them follows references to other
/// files.
constexpr std::string_view kKeptDrivers[] = {
    "GeoJSON",     "GeoJSONSeq", "JSONFG",  "TopoJSON",   "ESRIJSON", "ESRI Shapefile", "LIBKML",
    "KML",         "GPKG",       "GML",     "FlatGeobuf", "CSV",      "OpenFileGDB",    "GPX",
    "DXF",         "GTiff",      "PNG",     "JPEG",       "WEBP",     "MBTiles",        "DTED",
    "JP2OpenJPEG", "AAIGrid",    "SRTMHGT", "MEM",        "Memory"};

/// Files inside of other files, and in memory; those on disks need no handler.
constexpr std::string_view kFileHandlers[] = {"/vsimem/", "/vsizip/", "/vsigzip/", "/vsisubfile/"};

constexpr const char* kNotFetched = "only files on this computer are read";

/// In the place of a download. Without any result GDAL would go on to its own way of fetching.
CPLHTTPResult* fetchNothing(const char* url, CSLConstList, GDALProgressFunc, void*, CPLHTTPFetchWriteFunc,
                            void*, void*) {
    CPLError(CE_Failure, CPLE_NotSupported, "%s: %s", url, kNotFetched);
    auto* const result = static_cast<CPLHTTPResult*>(CPLCalloc(1, sizeof(CPLHTTPResult)));
    result->nStatus = 1;
    result->pszErrBuf = CPLStrdup(kNotFetched);
    return result;
}

void keepOnlyOurDrivers() {
    GDALDriverManager& manager = *GetGDALDriverManager();
    std::vector<GDALDriver*> others;
    for (int i = 0; i < manager.GetDriverCount(); ++i) {
        GDALDriver* const driver = manager.GetDriver(i);
        if (!std::ranges::contains(kKeptDrivers, std::string_view{driver->GetDescription()})) {
            others.push_back(driver);
        }
    }
    for (GDALDriver* const driver : others) {
        manager.DeregisterDriver(driver);
        GDALDestroyDriver(driver);
    }
}

void keepOnlyOurFileHandlers() {
    const CPLStringList prefixes{VSIFileManager::GetPrefixes()};
    for (int i = 0; i < prefixes.size(); ++i) {
        if (!std::ranges::contains(kFileHandlers, std::string_view{prefixes[i]})) {
            VSIFileManager::RemoveHandler(prefixes[i]);
        }
    }
}

}  // namespace

void registerGdalDrivers() {
    static std::once_flag once;
    std::call_once(once, [] {
        GDALAllRegister();
        keepOnlyOurDrivers();
        keepOnlyOurFileHandlers();
        CPLHTTPSetFetchCallback(fetchNothing, nullptr);
        OSRSetPROJEnableNetwork(0);
    });
}

}  // namespace furrow
