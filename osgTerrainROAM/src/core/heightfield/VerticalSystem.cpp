// SPDX-License-Identifier: Apache-2.0
#include "VerticalSystem.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <foundation/SmallLetters.h>

namespace osgTerrainROAM::core
{

namespace
{

std::string attributeOf(OGRSpatialReferenceH crs, const char* node, int child)
{
    const char* text = OSRGetAttrValue(crs, node, child);
    return text ? text : "";
}

bool hasOneOf(const std::string& text, std::initializer_list<std::string_view> words)
{
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return text.find(word) != std::string::npos; });
}

} // namespace

VerticalSystem verticalSystemOf(OGRSpatialReferenceH crs)
{
    VerticalSystem system;
    if (!OSRIsCompound(crs))
    {
        system.isEllipsoidal = OSRGetAxesCount(crs) == 3;
        return system;
    }
    system.name = attributeOf(crs, "VERT_CS", 0);
    const std::string names =
        foundation::inSmallLetters(system.name + " " + attributeOf(crs, "VERT_DATUM", 0));
    constexpr const char* kEllipsoidalDatum = "2002"; // datum type of OGC 01-009
    system.isEllipsoidal =
        attributeOf(crs, "VERT_DATUM", 1) == kEllipsoidalDatum || hasOneOf(names, {"ellipsoid"});
    system.isEgm96 = !system.isEllipsoidal && hasOneOf(names, {"egm96", "mean sea level", "msl ", "unknown",
                                                               "unnamed", "not specified"});
    // Files of GDAL 2, and "+geoidgrids", name the grid themselves.
    if (const std::string grid = attributeOf(crs, "VERT_DATUM|EXTENSION", 1);
        !grid.empty() && grid != "egm96_15.gtx" && !system.isEllipsoidal)
    {
        system.isEgm96 = false;
        system.name += " by " + grid;
    }
    const char* authority = OSRGetAuthorityName(crs, "VERT_CS");
    const char* code = OSRGetAuthorityCode(crs, "VERT_CS");
    if (authority && code) system.code = std::string(authority) + ":" + code;
    OGRAxisOrientation direction = OAO_Other;
    OSRGetAxis(crs, "VERT_CS", 0, &direction);
    system.isDepth = direction == OAO_Down;
    system.metresPerUnit = OSRGetTargetLinearUnits(crs, "VERT_CS", nullptr);
    return system;
}

} // namespace osgTerrainROAM::core
