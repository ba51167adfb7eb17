// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include <viewlod/Budget.h>

#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

namespace terraintool
{

/// What the checks of all frames of one flight add up to. Units: pixels.
struct FlightFindings
{
    std::size_t frames = 0;
    std::size_t tJunctions = 0;
    std::size_t cracks = 0;
    std::size_t ceilingExceeded = 0;   ///< frames with more leaves than the budget allows
    std::size_t toleranceExceeded = 0; ///< frames off the samples by more than the tolerance they report
    double maxErrorPx = 0.0;
    double tolerancePx = 0.0; ///< the largest that a frame reported

    /// Takes one frame in: what brute force found in it, what its refinement says of itself, and what was asked.
    void add(const osgTerrainROAM::core::DrawnMeshReport& found,
             const osgTerrainROAM::core::RefineResult& said, const viewlod::Budget& asked);

    bool isSound() const { return tJunctions + cracks + ceilingExceeded + toleranceExceeded == 0; }

    /// All of it in words, one line.
    std::string text() const;
};

} // namespace terraintool
