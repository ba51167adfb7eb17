// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgTerrainROAM/core/features/GroundFeature.h>

namespace osgTerrainROAM::core
{

/// A line of one style.
struct Chain
{
    FeatureStyle style;
    std::vector<glm::dvec2> points;
};

/// Joins the lines of features that continue one another. Maps cut a road where an attribute changes or a map
/// sheet ends, and each cut would leave a gap in the markings. Lines are joined at an end that exactly two
/// lines of the same style share (within 5 cm); at a junction of three or more nothing is joined.
/// Deterministic: in the order given.
std::vector<Chain> joinedLines(const std::vector<GroundFeature>& features);

} // namespace osgTerrainROAM::core
