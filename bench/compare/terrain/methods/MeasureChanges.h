// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "compare/terrain/methods/MeasureRival.h"

namespace terraintool
{

/// The sample nearest to an eye well inside its picture; nothing: no sample lies there.
std::optional<osgTerrainROAM::core::GridPoint> sampleInSight(const osgTerrainROAM::core::PlacedTile& tile,
                                                             const viewlod::ViewState& view);

/// Measures what morphing costs over the first frames of the flight; nothing: the method does not morph.
std::optional<MorphFigures> measureMorph(const Rival& rival, const ComparedFlight& flight,
                                         double tolerancePx);

/// Lowers a sample of the terrain of `rivals` in sight of the first eye again and again, and measures how
/// long each method's mesh takes to follow. A method whose mesh is then off by more than twice the compared
/// error, and twice its tolerance, does not follow. Writes `editUs` of each; the terrain stays edited.
void measureEdits(const Rivals& rivals, const ComparedFlight& flight, std::vector<MethodFigures>& methods);

} // namespace terraintool
