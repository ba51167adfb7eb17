// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/things/CountThings.h"

#include <algorithm>

#include <osgRoads/core/query/PaintedItem.h>

#include "scenery/roads/things/ObjectModels.h"
#include "scenery/roads/things/SignCodes.h"

namespace scenery::roads
{

namespace
{

std::string orUnknown(const std::string& text)
{
    return text.empty() ? "?" : text;
}

bool hasModel(const osgRoads::core::RoadObject& object)
{
    const ObjectWords words(object);
    const auto isStretch = [](const auto& repeat) { return repeat.distance <= 0.0; };
    return isPlant(words) || isBoxLike(words) || objectModel(words, {}) ||
           std::any_of(object.repeats.begin(), object.repeats.end(), isStretch) ||
           std::any_of(object.outlines.begin(), object.outlines.end(),
                       [](const auto& outline) { return outline.corners.size() > 2; });
}

} // namespace

ThingCounts countThings(const osgRoads::core::RoadNetwork& network)
{
    ThingCounts counts;
    for (const auto& road : network.roads)
    {
        for (const auto& signal : road.signals)
        {
            const std::string kind = "signal " + orUnknown(signal.country) + " " + orUnknown(signal.type);
            ++(osgRoads::core::paintKind(signal) ? counts.painted
               : signModel(signal)               ? counts.models
                                                 : counts.withoutModel)[kind];
        }
        for (const auto& object : road.objects)
            ++(osgRoads::core::paintKind(object) ? counts.painted
               : hasModel(object)                ? counts.models
                                                 : counts.withoutModel)["object " + orUnknown(object.type)];
    }
    return counts;
}

} // namespace scenery::roads
