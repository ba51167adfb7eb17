// SPDX-License-Identifier: Apache-2.0
#include "CrowdedObj.h"

#include <fstream>
#include <string>

namespace osgPMObjects
{

namespace
{

/// Closed meshes have two faces a position, open ones less.
constexpr std::size_t kMostFacesAPosition = 16;

} // namespace

bool isCrowdedObj(const std::filesystem::path& file)
{
    std::ifstream stream(file);
    std::size_t positions = 0, faces = 0;
    for (std::string line; std::getline(stream, line);)
    {
        positions += line.starts_with("v ");
        faces += line.starts_with("f ");
    }
    return faces > kMostFacesAPosition * positions;
}

} // namespace osgPMObjects
