// SPDX-License-Identifier: Apache-2.0
#include "pmtool/polygons/ReadPolygons.h"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

namespace pmtool
{

namespace
{

foundation::Result<std::string> textOf(const std::filesystem::path& file)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
        return foundation::Error{file.string(), "is a folder", "name a file in it"};
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (stream) return text;
    return foundation::Error{file.string(),
                             "cannot be read: " + std::generic_category().message(errno != 0 ? errno : EIO),
                             "check its name and its permissions"};
}

} // namespace

foundation::Result<PolygonSet> readPolygons(const std::filesystem::path& file)
{
    const std::string extension = file.extension().string();
    const bool isObj = extension == ".obj";
    if (!isObj && extension != ".geojson" && extension != ".json")
        return foundation::Error{file.string(), "is no file of polygons by its extension",
                                 "give .obj, .geojson or .json"};
    const auto text = textOf(file);
    if (!text) return text.error();
    return isObj ? parseObj(*text, file.string()) : parseGeoJson(*text, file.string());
}

} // namespace pmtool
