// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/edit/PlanShape.h>
#include <osgTerrainROAM/core/edit/TileEditor.h>

namespace osgTerrainROAM::core
{

/// A height rule returns the new height of a point from its horizontal position and its present height.
/// Several threads ask it at the same time. Units: metres.
using HeightRule = std::function<double(const glm::dvec2& place, double heightM)>;

/// The detail at which an edit works.
enum class EditDetail
{
    samples, ///< existing samples get other heights; the surface between them follows
    places,  ///< every grid point whose height changes gets a sample
};

/// The largest number of grid points that an edit may visit.
inline constexpr std::size_t kMostEditedPlaces = 1u << 26;

/// Evaluates a rule at the grid points within boxes. Returns the changes of at least a tenth of a millimetre.
/// Errors: more points than kMostEditedPlaces; no point of the data in any box.
/// Threads: nobody may edit the tile meanwhile; as many as the processor has, 8 at most, ask the rule. The
/// order of the changes does not depend on them. Cost: about half a microsecond a point, and what the rule
/// costs.
foundation::Result<std::vector<HeightChange>> changesBy(const HeightRule& rule, const PlacedTile& tile,
                                                        std::span<const PlanBox> boxes, EditDetail detail);

} // namespace osgTerrainROAM::core
