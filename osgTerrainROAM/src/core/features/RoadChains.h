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

/// The lines of features with those joined that go on as one another: maps cut a road wherever an attribute changes or a
/// square ends, and a cut would leave a gap in its markings. Lines are joined at an end that exactly two lines of the same style
/// share (within 5 cm); at a junction of three nothing is joined. Deterministic: in the order given.
std::vector<Chain> joinedLines(const std::vector<GroundFeature>& features);

} // namespace osgTerrainROAM::core
