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

/// A grid of samples in a coordinate reference system, or on a plane without one.
struct GridReference
{
    GridFrame frame{};
    std::string crsWkt; ///< empty: a plane
};

/// Transforms coordinates (column, row) of one grid to those of another. It is exact where both have the same
/// reference system; otherwise PROJ relates the two.
/// Threads: one at a time.
class FrameTransform
{
public:
    /// Errors: reference systems that cannot be related; the message names `name`.
    static foundation::Result<FrameTransform> create(const std::string& name, const GridReference& from,
                                                     const GridReference& to, GdalSession& gdal);

    /// Points where a map projection is not defined become NaN.
    void apply(std::span<glm::dvec2> places) const;

    bool isExact() const { return !_crs; } ///< the same reference system: straight lines stay straight

private:
    FrameTransform() = default;

    GridFrame _from{}, _to{};
    CoordinateTransform _crs;
};

} // namespace osgTerrainROAM::core
