// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <osgRoads/core/network/Signal.h>

#include "scenery/models/roads/RoadModel.h"

namespace scenery::roads
{

/// Returns the model of a signal by its country, type, subtype and value (lengths 0: not told), or nothing
/// when it is painted on the road or not known. Known: Germany (StVO, annexes 1 to 3; also under the country
/// OpenDRIVE, whose numbers are these), Sweden (Vägmärkesförordningen 2007:90), the words jin and shi for
/// China, and traffic lights 1000001, 1000002 (two lamps) and 1000009 to 1000012 (three lamps; the last three
/// with arrows by subtype: 10 left, 20 right, 30 ahead, 40 and 50 ahead and left or right). What has a text
/// but no face is a white board.
std::optional<models::RoadModel> signModel(const osgRoads::core::Signal& signal);

} // namespace scenery::roads
