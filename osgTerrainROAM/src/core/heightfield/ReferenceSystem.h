// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <type_traits>

#include <ogr_srs_api.h>

namespace osgTerrainROAM::core
{

struct ReferenceSystemCloser
{
    void operator()(OGRSpatialReferenceH system) const { OSRDestroySpatialReference(system); }
};
using ReferenceSystem = std::unique_ptr<std::remove_pointer_t<OGRSpatialReferenceH>, ReferenceSystemCloser>;

struct TransformCloser
{
    void operator()(OGRCoordinateTransformationH transform) const
    {
        OCTDestroyCoordinateTransformation(transform);
    }
};
using CoordinateTransform =
    std::unique_ptr<std::remove_pointer_t<OGRCoordinateTransformationH>, TransformCloser>;

/// Reduces a reference system to its two horizontal dimensions, longitude before latitude.
inline void makeHorizontal(OGRSpatialReferenceH system)
{
    OSRStripVertical(system);
    OSRDemoteTo2D(system, nullptr);
    OSRSetAxisMappingStrategy(system, OAMS_TRADITIONAL_GIS_ORDER);
}

} // namespace osgTerrainROAM::core
