// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "worldmaking/madeup/Drainage.h"
#include "worldmaking/madeup/GroundGrid.h"
#include "worldmaking/madeup/WayWeb.h"

namespace worldmaking
{

/// A part of a way, and whether it is a bridge. Parts of one way follow each other, with their ends in
/// common.
struct WayPart
{
    std::vector<glm::dvec2> points;
    bool isBridge = false;
};

/// Parts a way where streams cross it: bridges from bank to bank, where the ground stands kBankM above the
/// stream, at least kLeastBridgeM and at most kMostBridgeM long, but without any crossing on them (`knots`).
std::vector<WayPart> bridgedParts(const MadeWay& way, const std::vector<Stream>& streams,
                                  const GroundGrid& ground, const std::vector<glm::dvec2>& knots);

inline constexpr double kBankM = 2.5, kLeastBridgeM = 24.0, kMostBridgeM = 90.0;

} // namespace worldmaking
