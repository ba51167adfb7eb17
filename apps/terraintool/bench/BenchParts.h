// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <nlohmann/json.hpp>

#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace terraintool
{

/// What one triangle of a subtree of at least a thousand costs to remove, by enhMerge and by the same merges one after the
/// other: medians over subtrees at one sample a triangle, that at even levels have at least a thousand, the dearest level
/// of each kind. Units: nanoseconds.
nlohmann::ordered_json measureMerges(const std::shared_ptr<const osgTerrainROAM::core::RoamTile>& tile);

/// A restless eye with leaps, each frame with a slice of thread time: how far past it the frames end, how the dearest
/// compares with the median, and how often work was left over.
nlohmann::ordered_json measureSlices(const std::shared_ptr<const osgTerrainROAM::core::RoamTile>& tile);

/// Two flights of an eye, at 240 m/s and close to the ground at 30 m/s, both at 60 frames a second, half a cell a frame at
/// most: the largest change of the drawn height from a frame to the next at any vertex of the two meshes, seen from the
/// eye, in centre pixels; with and without morphing at the same tolerance.
nlohmann::ordered_json measurePops(const std::shared_ptr<const osgTerrainROAM::core::RoamTile>& tile);

/// Heights of the drawn surface, with the bound, at random places over a mesh of the flight; the median of some rounds. Units: queries per second.
double measureQueries(const std::shared_ptr<const osgTerrainROAM::core::RoamTile>& tile);

} // namespace terraintool
