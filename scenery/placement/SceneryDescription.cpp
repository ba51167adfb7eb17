// SPDX-License-Identifier: Apache-2.0
#include "scenery/placement/SceneryDescription.h"

#include <algorithm>

namespace scenery
{

std::vector<SceneryObject> objectsOf(const SceneryDescription& description)
{
    std::vector<SceneryObject> all;
    for (const SceneryField& field : description.fields)
        for (const SceneryObject& object : field.objects)
            if (std::find(all.begin(), all.end(), object) == all.end()) all.push_back(object);
    return all;
}

} // namespace scenery
