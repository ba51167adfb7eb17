// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "scenery/models/Model.h"

namespace scenery::models
{

/// Sets the sizes of a model to those of its mesh.
inline void measureModel(Model& model)
{
    model.radiusM = model.heightM = model.foundationM = 0.0;
    for (const glm::dvec3& p : model.mesh.positions)
    {
        model.radiusM = std::max(model.radiusM, std::hypot(p.x, p.y));
        model.heightM = std::max(model.heightM, p.z);
        model.foundationM = std::max(model.foundationM, -p.z);
    }
}

} // namespace scenery::models
