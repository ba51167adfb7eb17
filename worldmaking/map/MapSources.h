// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <foundation/Result.h>

namespace worldmaking
{

/// One file of a map.
struct MapSource
{
    std::string file;   ///< as GDAL opens it: a path, or a name in an archive (/vsizip/…)
    bool isOsm = false; ///< of OpenStreetMap, for libosmium; otherwise a format of OGR

    bool isInArchive() const { return file.starts_with("/vsizip/"); }
};

/// Finds the files of a map: those given, those in a folder and in its folders, those in an archive (.zip),
/// by the ends of their names: .osm, .pbf, .o5m, .opl, changes (.osc, .o5c) and histories (.osh), also as .gz
/// or .bz2; .gpkg, .geojson, .shp and others of OGR. What else lies in a folder is passed over. In the order
/// given; within a folder or archive by name. Reads the beginnings of files and the lists of archives alone.
/// Errors: a file that cannot be read, or is none of a map; a folder or archive without one; an archive that
/// is damaged, or of another kind.
foundation::Result<std::vector<MapSource>> mapSourcesOf(const std::vector<std::filesystem::path>& given);

/// Whether a file may be a map by its name, or is a folder.
bool isMapName(const std::filesystem::path& file);

} // namespace worldmaking
