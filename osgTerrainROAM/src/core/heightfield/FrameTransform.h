// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include <foundation/Result.h>
#include <glm/glm.hpp>

#include "RasterFile.h"
#include "ReferenceSystem.h"

namespace osgTerrainROAM::core
{

/// A grid of samples in a coordinate reference system; without one, on a plane.
struct GridReference
{
    GridFrame frame{};
    std::string crsWkt; ///< empty: a plane
};

/// From places of one grid, (column, row), to places of another. Where both have the same reference system it is exact; else
/// PROJ relates the two.
/// Threads: one at a time.
class FrameTransform
{
public:
    /// Errors: reference systems that cannot be related, named as `name`'s fault.
    static foundation::Result<FrameTransform> create(const std::string& name, const GridReference& from,
                                                     const GridReference& to, GdalSession& gdal);

    /// Places where a map projection is not defined become NaN.
    void apply(std::span<glm::dvec2> places) const;

    bool isExact() const { return !_crs; } ///< the same reference system: straight lines stay straight

private:
    FrameTransform() = default;

    GridFrame _from{}, _to{};
    CoordinateTransform _crs;
};

} // namespace osgTerrainROAM::core
