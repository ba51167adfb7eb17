// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <nlohmann/json.hpp>

#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace terraintool
{

/// Measures the time to remove one triangle of a subtree of at least a thousand triangles, with enhMerge and
/// with the same merges one after the other: medians over repetitions, at one sample a triangle, of the
/// slowest even level.
/// Units: nanoseconds.
nlohmann::ordered_json measureMerges(const std::shared_ptr<const osgTerrainROAM::core::RoamTile>& tile);

/// Measures a random walk with jumps, each frame with a slice of thread time: how far the frames exceed it,
/// the slowest frame against the median, and how often work was left over.
nlohmann::ordered_json measureSlices(const std::shared_ptr<const osgTerrainROAM::core::RoamTile>& tile);

/// Measures popping on two flights, at 240 m/s and close to the ground at 30 m/s, both at 60 frames a second
/// and at most half a cell a frame: the largest change of the drawn height between two frames at any sample,
/// in centre pixels, with and without morphing at the same tolerance.
nlohmann::ordered_json measurePops(const std::shared_ptr<const osgTerrainROAM::core::RoamTile>& tile);

/// Measures queries of the drawn height with its bound at random points over a mesh of the flight; the median
/// of some rounds. Units: queries per second.
double measureQueries(const std::shared_ptr<const osgTerrainROAM::core::RoamTile>& tile);

} // namespace terraintool
