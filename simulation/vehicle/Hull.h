// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace simulation
{

/// A box of the body that may hit something. Axes: x forward, y left, z up. Units: metres.
struct HullBox
{
    std::string name;
    glm::dvec3 sizeM{0.0};
    glm::dvec3 place{0.0}; ///< of its middle
};

struct HullData
{
    std::vector<HullBox> boxes;
    double friction = 0.5;
    double crashesAtMps = 0.0; ///< closing speed at which the vehicle counts as crashed
};

} // namespace simulation
