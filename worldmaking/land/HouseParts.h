// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "worldmaking/map/LandMap.h"
#include "worldmaking/map/MapPlane.h"

namespace worldmaking
{

/// An area that becomes a house, or a part of one.
struct HouseShape
{
    LandShape shape;
    std::int64_t whole = 0; ///< the id of the building that it is a part of; 0: it is none
};

/// Returns the areas with `building` and `building:part` of a map. Parts take the place of the building that
/// they lie in; what they leave of it stays, unless that is less than a tenth, or the building is as high as
/// its highest part and nothing lower stands on the ground. Parts have the height, colours, material and use
/// of their building where their own tags do not say them. A part without a building stands by itself.
/// `parts`: their number.
/// Source: the OpenStreetMap wiki, *Simple 3D Buildings*. Cost: near-linear (a grid).
std::vector<HouseShape> houseShapesOf(const LandMap& map, const MapPlane& plane, std::size_t& parts);

} // namespace worldmaking
