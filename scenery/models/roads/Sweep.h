// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "scenery/models/mesh/ModelBuilder.h"

namespace scenery::models
{

/// One cross-section of a swept body: where its middle is, and its profile there, to the left and up. Units:
/// metres.
struct SweepStation
{
    glm::dvec3 at{0.0};
    glm::dvec2 left{0.0, 1.0}; ///< horizontal unit vector
    /// counter-clockwise with left to the right and up; equally many points at each station, even
    std::vector<glm::dvec2> profile;
};

/// Adds the closed body that a profile sweeps along a line. Its ends are closed as strips: point i faces
/// point n - 1 - i.
/// `uvPerM`: of the texture, along and around; 0: the plain cell of the atlas of signs.
/// Precondition: a part has begun; at least two stations.
void addSweep(ModelBuilder& builder, const std::vector<SweepStation>& stations, double uvPerM = 0.0);

} // namespace scenery::models
