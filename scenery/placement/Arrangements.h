// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/placement/Site.h"

namespace scenery
{

/// Each fills the field that the site has begun. `wanted`: how many objects; placed() of the site says how many it became.
void scatter(Site& site, std::uint32_t wanted);
void plantRows(Site& site, std::uint32_t wanted);
void park(Site& site, std::uint32_t wanted);
/// As many settlements as the field's layout says, with their streets. Returns how many plots they have.
std::uint32_t settle(Site& site);

} // namespace scenery
