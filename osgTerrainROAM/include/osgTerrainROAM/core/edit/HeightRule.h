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

/// The height that a place shall have, from where it is in the plan and the height that it has. Units: metres.
using HeightRule = std::function<double(const glm::dvec2& place, double heightM)>;

/// How finely an edit works.
enum class EditDetail
{
    samples, ///< what has a sample gets another height; the surface between follows
    places,  ///< every place of the tile's grid gets a sample where the height shall change
};

/// How many places an edit may look at.
inline constexpr std::size_t kMostEditedPlaces = 1u << 26;

/// The changes that a rule makes within boxes; none smaller than a tenth of a millimetre. Errors: more places than
/// kMostEditedPlaces, a box without any place of the data.
/// Threads: nobody edits the tile meanwhile. Cost: about half a microsecond a place.
foundation::Result<std::vector<HeightChange>> changesBy(const HeightRule& rule, const PlacedTile& tile,
                                                        std::span<const PlanBox> boxes, EditDetail detail);

} // namespace osgTerrainROAM::core
