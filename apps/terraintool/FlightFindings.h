// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include <viewlod/Budget.h>

#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/RefineResult.h>

namespace terraintool
{

/// The sums of the checks of all frames of one flight. Units: errors in pixels.
struct FlightFindings
{
    std::size_t frames = 0;
    std::size_t tJunctions = 0;
    std::size_t cracks = 0;
    std::size_t ceilingExceeded = 0;   ///< frames with more leaves than the budget allows
    std::size_t toleranceExceeded = 0; ///< frames off the samples by more than the tolerance they report
    double maxErrorPx = 0.0;
    double tolerancePx = 0.0; ///< the largest that a frame reported

    /// Adds one frame: the result of the brute-force check, the statistics of its refinement, and the target.
    void add(const osgTerrainROAM::core::DrawnMeshReport& found,
             const osgTerrainROAM::core::RefineResult& said, const viewlod::Budget& asked);

    bool isSound() const { return tJunctions + cracks + ceilingExceeded + toleranceExceeded == 0; }

    /// Returns the findings as one line of text.
    std::string text() const;
};

} // namespace terraintool
