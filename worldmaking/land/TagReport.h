// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "worldmaking/map/LandMap.h"
#include "worldmaking/map/TagCounts.h"

namespace worldmaking
{

/// Tags of a map whose values are not taken as they stand.
struct TagReport
{
    TagCounts passedOver;   ///< that are no number, length or speed: as if they were not there
    TagCounts approximated; ///< of streets, taken for something else
};

/// Looks at all tags of knownTags() that are read and have a number, and at those of streets.
TagReport tagReportOf(const LandMap& map);

/// Returns counts on one line: "height=tall 2, lanes=many 1 and 5 others"; empty: none.
std::string lineOf(const TagCounts& counts);

} // namespace worldmaking
