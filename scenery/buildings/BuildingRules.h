// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "scenery/buildings/Building.h"

namespace scenery
{

using BuildingTags = std::map<std::string, std::string, std::less<>>;

/// Makes a building of an outline with the tags of OpenStreetMap's Simple 3D Buildings: height, min_height,
/// building:min_level, building:levels, roof:shape, roof:height, roof:levels, roof:orientation,
/// building:colour, roof:colour, building:material. What they do not say follows from the kind of the
/// building, its area and `id`: the same id, the same house.
/// `rings`: in metres, as MapShape has them. Nothing: an outline without area, or larger than 0.2 km².
/// Sources: the OpenStreetMap wiki, *Simple 3D Buildings*; osm2city's shares of roof forms (80 % gabled, 10 %
/// flat, 10 % hipped).
std::optional<Building> buildingOf(const std::vector<std::vector<glm::dvec2>>& rings,
                                   const BuildingTags& tags, std::uint64_t id);

/// Makes the building of a tower or mast that the map has as a point; nothing where the tags name none.
std::optional<Building> towerOf(const glm::dvec2& place, const BuildingTags& tags, std::uint64_t id);

} // namespace scenery
