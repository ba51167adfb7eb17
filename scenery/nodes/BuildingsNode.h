// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <osg/Group>

#include "scenery/buildings/BuildingFacets.h"

namespace scenery
{

/// Makes a node of buildings: walls and roofs in squares of kShellSquareM, one geometry for each texture,
/// drawn up to kShellFarM; windows and doors in squares of kOpeningsSquareM, drawn up to kOpeningsFarM. Both
/// ranges overlap the next (RangedGroup).
/// Frame: the scene's. Needs the uniforms of an Atmosphere above it in the graph. Memory: some 15 KB a
/// building.
/// `panes`: gets the panes of all windows; null: they are not asked for.
osg::ref_ptr<osg::Group> makeBuildingsNode(std::span<const StandingBuilding> buildings,
                                           std::vector<WindowPane>* panes = nullptr);

inline constexpr double kShellSquareM = 500.0, kShellFarM = 12000.0;
inline constexpr double kOpeningsSquareM = 250.0, kOpeningsFarM = 900.0;

} // namespace scenery
