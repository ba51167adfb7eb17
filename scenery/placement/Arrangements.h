// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/placement/Site.h"

namespace scenery
{

/// The arrangements. Each fills the field that the site has begun with `wanted` objects; placed() of the site
/// tells how many found room.
void scatter(Site& site, std::uint32_t wanted);
void plantRows(Site& site, std::uint32_t wanted);
void park(Site& site, std::uint32_t wanted);
/// Places the settlements of the layout with their streets. Returns the number of plots.
std::uint32_t settle(Site& site);

} // namespace scenery
