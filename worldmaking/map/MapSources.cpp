// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/map/MapSources.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <optional>
#include <system_error>

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <foundation/ReadableFile.h>

#include "worldmaking/map/GdalScope.h"

namespace worldmaking
{

namespace
{

using foundation::Error;
using foundation::Result;
using Sources = std::vector<MapSource>;

constexpr const char* kRemedy = "give a map as .osm, .osm.gz, .osm.bz2, .osm.pbf, .o5m, .osc, GeoPackage, "
                                "GeoJSON, shapefile, or a folder or .zip of them";
constexpr std::size_t kMostFiles = 10000; ///< of a folder or archive

enum class NameKind
{
    unknown,
    osm,
    vector,
    zip,
    otherArchive,
};

std::string lowerOf(std::string text)
{
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

template<std::size_t N>
bool endsWithOneOf(const std::string& name, const std::array<const char*, N>& ends)
{
    return std::any_of(ends.begin(), ends.end(), [&](const char* end) { return name.ends_with(end); });
}

NameKind kindOf(const std::string& path)
{
    static constexpr std::array kOsm{".osm", ".pbf", ".osc", ".osh", ".o5m", ".o5c", ".opl", ".osm.xml"};
    static constexpr std::array kVector{".gpkg", ".geojson", ".json", ".geojsonl", ".shp", ".shz", ".fgb",
                                        ".gml",  ".sqlite",  ".gdb",  ".tab",      ".mif", ".kml"};
    static constexpr std::array kRasters{".hgt.zip", ".tif.zip", ".asc.zip",
                                         ".dt0.zip", ".dt1.zip", ".dt2.zip"};
    static constexpr std::array kArchives{".7z",      ".rar",    ".tar", ".tgz", ".tar.gz",
                                          ".tar.bz2", ".tar.xz", ".xz",  ".zst"};
    std::string name = lowerOf(path);
    if (name.ends_with(".zip")) return endsWithOneOf(name, kRasters) ? NameKind::unknown : NameKind::zip;
    if (endsWithOneOf(name, kArchives)) return NameKind::otherArchive;
    const bool isGzip = name.ends_with(".gz"), isBzip2 = name.ends_with(".bz2");
    if (isGzip) name.resize(name.size() - 3);
    if (isBzip2) name.resize(name.size() - 4);
    if (endsWithOneOf(name, kOsm)) return NameKind::osm;
    return !isBzip2 && endsWithOneOf(name, kVector) ? NameKind::vector : NameKind::unknown;
}

std::string beginningOf(const std::filesystem::path& file)
{
    std::string text(2000, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
    return text;
}

/// Looks at the beginning of a file whose name does not tell all.
Result<MapSource> sourceOf(const std::filesystem::path& file)
{
    if (const auto readable = foundation::checkReadable(file); !readable) return readable.error();
    const std::string name = file.string();
    const NameKind kind = kindOf(name);
    if (kind == NameKind::otherArchive)
        return Error{name, "is an archive of a kind that is not read", "unpack it, or make a .zip of it"};
    const std::string text = beginningOf(file);
    if (text.find("\"elements\"") != std::string::npos && text.find("\"osm3s\"") != std::string::npos)
        return Error{name, "is JSON of Overpass, which is not read", "ask Overpass for [out:xml]"};
    const std::size_t mark = text.find_first_not_of("\xEF\xBB\xBF \t\r\n");
    if (kind != NameKind::vector && mark != std::string::npos &&
        (lowerOf(text.substr(mark, 9)) == "<!doctype" || lowerOf(text.substr(mark, 5)) == "<html"))
        return Error{name, "is a page of a web server, not a map", "fetch it again"};
    const bool isXml = text.find("<osm") != std::string::npos && text.find('<') < 200;
    if (kind == NameKind::osm || (kind == NameKind::unknown && lowerOf(name).ends_with(".xml") && isXml))
        return MapSource{name, true};
    if (kind == NameKind::vector) return MapSource{name, false};
    const GdalScope quiet;
    if (GDALIdentifyDriverEx(name.c_str(), GDAL_OF_VECTOR, nullptr, nullptr)) return MapSource{name, false};
    return Error{name, "is in no format of maps that is read", kRemedy};
}

/// Adds the maps of an archive.
foundation::Outcome addArchive(const std::filesystem::path& file, Sources& sources)
{
    if (const auto readable = foundation::checkReadable(file); !readable) return readable.error();
    const GdalScope quiet;
    const std::string root = "/vsizip/" + std::filesystem::absolute(file).string();
    const std::unique_ptr<char*, decltype(&CSLDestroy)> listed(VSIReadDirRecursive(root.c_str()), CSLDestroy);
    if (!listed)
        return Error{file.string(), "cannot be read as a .zip archive", "fetch it again, or unpack it"};
    std::vector<std::string> names;
    for (char** entry = listed.get(); *entry; ++entry)
        names.emplace_back(*entry);
    if (names.size() > kMostFiles)
        return Error{file.string(), "holds more than 10 000 files", "unpack it, and name the maps in it"};
    std::sort(names.begin(), names.end());
    const std::size_t before = sources.size();
    for (const std::string& name : names)
    {
        const NameKind kind = kindOf(name);
        const bool isHidden = name.starts_with("__MACOSX") || name.find("/.") != std::string::npos;
        if (!isHidden && (kind == NameKind::osm || kind == NameKind::vector))
            sources.push_back({root + "/" + name, kind == NameKind::osm});
    }
    if (sources.size() == before) return Error{file.string(), "has no map in it", kRemedy};
    return foundation::success();
}

/// The files of a folder and of the folders in it, by name.
std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    std::error_code failed;
    auto entry = std::filesystem::recursive_directory_iterator(
        folder, std::filesystem::directory_options::skip_permission_denied, failed);
    for (; !failed && entry != std::filesystem::recursive_directory_iterator() && files.size() <= kMostFiles;
         entry.increment(failed))
    {
        if (entry->path().filename().string().starts_with("."))
        {
            entry.disable_recursion_pending();
            continue;
        }
        std::error_code ignored;
        const bool isFolder = entry->is_directory(ignored);
        const bool isWhole = isFolder && kindOf(entry->path().string()) == NameKind::vector; // .gdb
        if (entry.depth() >= 1 || isWhole) entry.disable_recursion_pending();
        if (!isFolder || isWhole) files.push_back(entry->path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

foundation::Outcome addFolder(const std::filesystem::path& folder, Sources& sources)
{
    const std::size_t before = sources.size();
    const auto files = filesIn(folder);
    if (files.size() > kMostFiles)
        return Error{folder.string(), "holds more than 10 000 files", "name the maps in it"};
    for (const auto& file : files)
    {
        const NameKind kind = kindOf(file.string());
        if (kind == NameKind::zip)
        {
            if (const auto added = addArchive(file, sources); !added) return added;
        }
        else if (kind == NameKind::osm || kind == NameKind::vector)
            sources.push_back({file.string(), kind == NameKind::osm});
    }
    if (sources.size() == before) return Error{folder.string(), "is a folder without a map", kRemedy};
    return foundation::success();
}

} // namespace

foundation::Result<std::vector<MapSource>> mapSourcesOf(const std::vector<std::filesystem::path>& given)
{
    Sources sources;
    for (const auto& file : given)
    {
        std::error_code ignored;
        const NameKind kind = kindOf(file.string());
        foundation::Outcome added = foundation::success();
        if (std::filesystem::is_directory(file, ignored) && kind != NameKind::vector)
            added = addFolder(file, sources);
        else if (kind == NameKind::zip)
            added = addArchive(file, sources);
        else if (std::filesystem::is_directory(file, ignored) || file.string().starts_with("/vsi"))
            sources.push_back({file.string(), false});
        else if (auto source = sourceOf(file))
            sources.push_back(*std::move(source));
        else
            added = source.error();
        if (!added) return added.error();
    }
    return sources;
}

bool isMapName(const std::filesystem::path& file)
{
    std::error_code ignored;
    return kindOf(file.string()) != NameKind::unknown || std::filesystem::is_directory(file, ignored);
}

} // namespace worldmaking
