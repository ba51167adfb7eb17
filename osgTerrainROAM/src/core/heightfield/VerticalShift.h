// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include <glm/vec2.hpp>

#include "ReferenceSystem.h"

namespace osgTerrainROAM::core
{

/// How high the zero of a vertical reference system other than EGM96 lies above the ellipsoid WGS84, by the
/// grids that PROJ finds. Debian's proj-data has none besides EGM96; a user may put others into a folder of
/// PROJ_DATA.
/// Threads: one at a time.
class VerticalShift
{
public:
    /// `compound`: a reference system with a vertical part. `places`, in its own coordinates, east before
    /// north: where the shift must be known. Returns nothing where PROJ has no grid for one of them.
    static std::optional<VerticalShift> find(OGRSpatialReferenceH compound,
                                             std::span<const glm::dvec2> places);

    /// Puts the metres that its zero lies above the ellipsoid into `heightsM`, one for each place; a height
    /// stays as it is where the grid has none.
    void heights(std::span<const glm::dvec2> places, std::span<double> heightsM) const;

private:
    CoordinateTransform _toEllipsoid;
};

} // namespace osgTerrainROAM::core
