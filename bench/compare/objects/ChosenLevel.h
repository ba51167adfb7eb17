// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <osgPMObjects/core/selection/LevelTable.h>

namespace pmtool
{

/// A level that a node shows.
struct ChosenLevel
{
    std::uint32_t steps = 0, faces = 0;
    double tolerance = 0.0; ///< units of the model
};

/// Returns the level that a node shows in its first frame at a tolerance of one pixel, with its sphere of
/// this radius so many pixels across.
ChosenLevel levelShownAt(const osgPMObjects::core::LevelTable& table, double radius, double acrossPx);

} // namespace pmtool
