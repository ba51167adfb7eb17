// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include <foundation/ContentMark.h>
#include <foundation/MappedFile.h>

namespace foundation
{

/// Returns a mark of the bytes of a GeoPackage (.gpkg) or GeoTIFF (.tif, .tiff), if they are all that reading
/// it follows from. Absent: it is of another kind (a .vrt names more files), or cannot be read, or beside it
/// lies a file that GDAL reads with it (map.gpkg-wal, map.tif.aux.xml, map.tfw).
/// Cost: that of reading the file, and the names in its folder.
inline std::optional<ContentMark> markOfSoleFile(const std::filesystem::path& file)
{
    const std::string suffix = file.extension().string();
    const bool isPackage = suffix == ".gpkg";
    if (!isPackage && suffix != ".tif" && suffix != ".tiff") return std::nullopt;
    const std::string name = file.filename().string();
    // World files have the name of the raster with another suffix.
    const std::string shared = isPackage ? name : file.stem().string() + '.';
    std::error_code failed;
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    for (const auto& entry : std::filesystem::directory_iterator(folder, failed))
        if (const std::string other = entry.path().filename().string();
            other != name && other.starts_with(shared))
            return std::nullopt;
    if (failed) return std::nullopt;
    const auto bytes = MappedFile::open(file);
    if (!bytes) return std::nullopt;
    bytes->fetchAll();
    return ContentMark().add(bytes->text());
}

} // namespace foundation
