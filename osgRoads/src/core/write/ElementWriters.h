// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pugixml.hpp>

#include <osgRoads/core/network/Junction.h>
#include <osgRoads/core/network/Road.h>

namespace osgRoads::core
{

/// Each appends an element with all that belongs to it.
void writeRoad(pugi::xml_node root, const Road& road);
void writePlanView(pugi::xml_node roadNode, const ReferenceLine& line);
void writeLanes(pugi::xml_node roadNode, const Road& road);
void writeSignals(pugi::xml_node roadNode, const Road& road);
void writeController(pugi::xml_node root, const Controller& controller);
void writeJunction(pugi::xml_node root, const Junction& junction);

} // namespace osgRoads::core
