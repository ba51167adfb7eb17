// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgTerrainROAM/core/features/GroundFeature.h>

#include "CellClip.h"
#include "RunwayStrokes.h"

namespace osgTerrainROAM::core
{

/// The shapes to be cut into cells, in the order of painting. Metres, local frame.
struct FeatureShapes
{
    struct Area
    {
        std::vector<Ring> rings;
        FeatureKind kind = FeatureKind::field;
        Crop crop = Crop::cereal;
        int seed = 0;              ///< 0 … 63: chooses its shade
        glm::dvec2 rows{1.0, 0.0}; ///< unit direction of its rows
    };

    /// A piece of a line.
    struct Segment
    {
        glm::dvec2 a, b;
        double halfWidthM = 0.0;
        double wayM = 0.0; ///< from the line's beginning to `a`, modulo FeatureCells::kWayPeriodM
        int code = 0;      ///< FeatureCells
        int line = 0;      ///< number of the line it belongs to
    };

    std::vector<Area> areas;
    std::vector<Segment> segments;
    std::vector<RunwayFrame> runways;
    std::vector<Stroke> strokes; ///< of runways and taxiways

    explicit FeatureShapes(const std::vector<GroundFeature>& features);
};

} // namespace osgTerrainROAM::core
