// SPDX-License-Identifier: Apache-2.0
#include "worldtool/LandCover.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

#include <osgTerrainROAM/core/cover/CoverImport.h>

namespace worldtool
{

namespace
{

using osgTerrainROAM::core::GroundKind;
using worldmaking::Cover;

Cover classOf(GroundKind kind)
{
    switch (kind)
    {
    case GroundKind::forest:
        return Cover::trees;
    case GroundKind::shrub:
        return Cover::shrubs;
    case GroundKind::meadow:
    case GroundKind::dryGrass:
        return Cover::grass;
    case GroundKind::crop:
        return Cover::crops;
    case GroundKind::rock:
    case GroundKind::soil:
    case GroundKind::sand:
        return Cover::bare;
    case GroundKind::snow:
        return Cover::ice;
    case GroundKind::wetland:
        return Cover::wetland;
    case GroundKind::garden:
        return Cover::garden;
    case GroundKind::yard:
        return Cover::yard;
    default:
        return Cover::none;
    }
}

} // namespace

foundation::Result<CoverOnEarth> coverOf(const Request& request, const EarthGround& ground)
{
    if (request.landCover.empty()) return CoverOnEarth();
    const auto table = osgTerrainROAM::core::readCoverTable(request.landCoverClasses);
    if (!table) return table.error();
    auto read = osgTerrainROAM::core::importCover(request.landCover, *table, *ground.tile);
    if (!read) return read.error();
    for (const std::string& note : read->notes)
        std::cout << "note: " << note << '\n';
    const auto map = std::make_shared<const osgTerrainROAM::core::CoverMap>(*std::move(read));
    return CoverOnEarth(
        [map, tile = ground.tile](const glm::dvec2& degrees)
        {
            const auto& frame = tile->frame();
            const glm::dvec2 grid = frame.gridAt(frame.localFromGeodetic({degrees.y, degrees.x, 0.0}));
            const glm::dvec2 last(tile->grid().dataColumns() - 1, tile->grid().dataRows() - 1);
            const glm::dvec2 at = glm::round(grid / last * glm::dvec2(map->width - 1, map->height - 1));
            if (!(at.x >= 0.0 && at.y >= 0.0 && at.x < map->width && at.y < map->height)) return Cover::none;
            return classOf(map->at(static_cast<int>(at.x), static_cast<int>(at.y)));
        });
}

} // namespace worldtool
