// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include <osgRoads/core/network/RoadNetwork.h>

namespace scenery::roads
{

/// How many signals and objects of each kind ("signal de 274", "object barrier") are drawn, and as what.
struct ThingCounts
{
    std::map<std::string, int> models, painted;
    std::map<std::string, int>
        withoutModel; ///< signals that are left out, objects that are grey boxes of their size
};

/// Counts what is drawn for the signals and objects of a network. Repeated objects count once.
ThingCounts countThings(const osgRoads::core::RoadNetwork& network);

} // namespace scenery::roads
