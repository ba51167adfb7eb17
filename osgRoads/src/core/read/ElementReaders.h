// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "NodeReader.h"

namespace osgRoads::core
{

/// Readers of the parts of a road; each stands in the file of its name.

Road readRoad(NodeReader& element);

/// Reads the reference line. Geometry that cannot be used is told, and leaves the line empty; a plan view
/// that is shorter than the road makes it as short.
void readPlanView(NodeReader& road, Road& into);

void readLateralProfile(NodeReader& road, Road& into);

/// Reads the lanes with their sections and offset.
void readLanes(NodeReader& road, Road& into);

std::vector<RoadMark> readRoadMarks(NodeReader& lane);

void readObjects(NodeReader& road, Road& into);

void readSignals(NodeReader& road, Road& into);

Controller readController(NodeReader& element);

Junction readJunction(NodeReader& element);

std::vector<LaneValidity> readValidities(NodeReader& element);

/// Reads what objects and signals share; their heading has another name in each.
void readItem(NodeReader& element, RoadItem& item);

/// Reports an object or signal whose s is not on its road. `name`: what it is, and its id.
void reportOffRoad(NodeReader& element, const std::string& name, double s, const Road& road);

/// Reads a speed: attributes `max` and `unit`. No value: no limit.
std::optional<double> readSpeed(NodeReader& element);

/// Finds the roads and junctions that links name, and tells which are not there.
void resolveLinks(RoadNetwork& network, ReadContext& context);

} // namespace osgRoads::core
