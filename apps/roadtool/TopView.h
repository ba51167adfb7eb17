// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include <osgRoads/core/network/RoadNetwork.h>
#include <osgRoads/core/query/BoxTree.h>

namespace roadtool
{

using osgRoads::core::PlanBox;

struct Colour
{
    std::uint8_t red = 0, green = 0, blue = 0;
};

/// A filled polygon in the inertial frame, metres.
struct FilledPolygon
{
    std::vector<glm::dvec2> corners;
    Colour colour;
};

/// What is seen from above: polygons in the order in which they are painted.
struct TopView
{
    PlanBox bounds; ///< with a margin
    Colour background;
    std::vector<FilledPolygon> polygons;
};

/// Makes the top view of a network: lanes by their type, road marks, objects, signals. Curves are sampled so
/// that chords are off by 5 cm at most (more where a network has over a million samples).
TopView topView(const osgRoads::core::RoadNetwork& network);

/// The bounds of the reference lines of all usable roads.
PlanBox boundsOf(const osgRoads::core::RoadNetwork& network);

} // namespace roadtool
