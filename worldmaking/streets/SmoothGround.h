// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <foundation/Heights.h>
#include <glm/vec2.hpp>

#include "worldmaking/streets/CloseStreets.h"
#include "worldmaking/streets/HeightNodes.h"

namespace worldmaking
{

/// Returns the height that the ground asks for at each node: close to it where a street lies on it, smooth
/// along the street and across crossings, and level with streets that run close beside it (`ties`); on
/// bridges and in tunnels straight from one end to the other. Limits of grade are not its business.
/// Method: least squares over the whole network: departure from the ground against second differences, and
/// first differences where there is no ground; one sparse Cholesky factorisation. Cost: some 0.2 s for 100
/// 000 nodes.
/// Source: Eilers & Marx, *Flexible smoothing with B-splines and penalties*, Statistical Science 11, 1996.
std::vector<double> smoothGround(const HeightNodes& nodes, const foundation::HeightInPlan& ground,
                                 std::span<const StreetTie> ties = {});

} // namespace worldmaking
