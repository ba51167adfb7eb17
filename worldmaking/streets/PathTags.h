// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "worldmaking/map/StreetMap.h"

namespace worldmaking
{

/// Whether a way is one for people on foot, riders or tractors: painted on the ground, carried by
/// footbridges, and kept clear of by the bridges of streets. Streets that are closed to cars are such ways,
/// too. Source: the OpenStreetMap wiki, *Key:highway*.
bool isFootway(const Tags& tags);

} // namespace worldmaking
