// SPDX-License-Identifier: Apache-2.0
#include "RasterPath.h"

#include <algorithm>
#include <system_error>

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <foundation/SmallLetters.h>

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Error;

std::string lowerExtension(const std::filesystem::path& file)
{
    return foundation::inSmallLetters(file.extension().string());
}

/// Orders members of an archive: possible elevation formats before text, metadata and images.
bool looksLikeElevation(const std::string& member)
{
    static constexpr const char* kKnown[] = {".hgt", ".tif", ".tiff", ".dt0", ".dt1",
                                             ".dt2", ".asc", ".flt",  ".img"};
    const std::string extension = lowerExtension(member);
    return std::any_of(std::begin(kKnown), std::end(kKnown), [&](const char* k) { return extension == k; });
}

std::vector<std::string> zipMembers(const std::string& archive)
{
    std::vector<std::string> members;
    char** list = VSIReadDirRecursive(archive.c_str());
    for (int i = 0; i < CSLCount(list); ++i)
        if (const std::string member = list[i]; !member.empty() && member.back() != '/')
            members.push_back(std::string(archive).append("/").append(member));
    CSLDestroy(list);
    std::sort(members.begin(), members.end());
    std::stable_partition(members.begin(), members.end(), looksLikeElevation);
    return members;
}

} // namespace

foundation::Result<std::vector<std::string>> rasterPaths(const std::filesystem::path& file)
{
    const std::string name = file.string();
    if (name.rfind("/vsi", 0) == 0) return std::vector<std::string>{name};

    std::error_code code;
    const std::filesystem::file_status status = std::filesystem::status(file, code);
    if (!std::filesystem::exists(status)) return Error{name, "no such file", "check the path"};
    if (std::filesystem::is_directory(status))
        return Error{name, "is a folder, not an elevation file", "name one raster in it"};
    if (VSILFILE* probe = VSIFOpenL(name.c_str(), "rb"))
        VSIFCloseL(probe);
    else
        return Error{name, "cannot be opened for reading", "check its permissions"};

    const std::string absolute = std::filesystem::absolute(file, code).string();
    const std::string extension = lowerExtension(file);
    if (extension == ".gz") return std::vector<std::string>{"/vsigzip/" + absolute};
    if (extension != ".zip") return std::vector<std::string>{name};
    std::vector<std::string> members = zipMembers("/vsizip/{" + absolute + "}");
    if (members.empty())
        return Error{name, "is no zip archive, is damaged, or holds nothing", "fetch it again, or unpack it"};
    return members;
}

} // namespace osgTerrainROAM::core
