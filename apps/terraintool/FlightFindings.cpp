// SPDX-License-Identifier: Apache-2.0
#include "terraintool/FlightFindings.h"

#include <algorithm>
#include <sstream>

namespace terraintool
{

void FlightFindings::add(const osgTerrainROAM::core::DrawnMeshReport& found,
                         const osgTerrainROAM::core::RefineResult& said, const viewlod::Budget& asked)
{
    ++frames;
    tJunctions += found.tJunctions;
    cracks += found.cracks;
    ceilingExceeded += said.leaves > asked.maxTriangles ? 1 : 0;
    toleranceExceeded += found.maxErrorPx <= said.tolerancePx ? 0 : 1; // an error that is no number, too
    maxErrorPx = std::max(maxErrorPx, found.maxErrorPx);
    tolerancePx = std::max(tolerancePx, said.tolerancePx);
}

std::string FlightFindings::text() const
{
    std::ostringstream words;
    words << frames << " frames, " << tJunctions << " T-junctions, " << cracks << " cracks, "
          << ceilingExceeded << " frames above the ceiling, " << toleranceExceeded
          << " beyond their tolerance; at most " << maxErrorPx << " px off where " << tolerancePx
          << " px are allowed";
    return words.str();
}

} // namespace terraintool
