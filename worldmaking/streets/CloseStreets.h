// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "worldmaking/streets/HeightNodes.h"

namespace worldmaking
{

/// A node, and the place beside it on another street, or on another stretch of its own, that should have its
/// height.
struct StreetTie
{
    std::size_t node = 0;              ///< number
    std::size_t before = 0, after = 0; ///< numbers of the nodes around the place
    double share = 0.0;                ///< of the way from the one to the other
    double weight = 0.0;               ///< that of a node's wish is 1
};

/// Finds where streets on the ground run so close to each other that the ground between them would be a wall:
/// carriageways, service roads beside streets, mouths that leave a crossing side by side, the legs of
/// hairpins. The closer, the greater the weight.
/// `halfWidthsM`: half of the paving of each row. Cost: near-linear in the number of nodes (a grid).
std::vector<StreetTie> closeStreets(const HeightNodes& nodes, const std::vector<double>& halfWidthsM);

inline constexpr double kCloseM = 12.0; ///< between pavings; farther apart ground has room to rise

} // namespace worldmaking
