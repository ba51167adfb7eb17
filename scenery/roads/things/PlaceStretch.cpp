// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "scenery/roads/things/Placers.h"
#include "scenery/roads/things/RoadLine.h"

namespace scenery::roads
{

namespace
{

using osgRoads::core::ObjectInstance;

/// The beam of a steel guard rail, as high as told: two waves, seen from the road on either side.
/// Source: profile A of the German RAL-RG 620: 310 mm high, 81 mm deep; here 0.08 m.
Profile beam(double low, double high)
{
    const double step = (high - low) / 6.0;
    Profile right, left;
    const double waves[] = {0.0, 0.08, 0.08, 0.0, 0.08, 0.08, 0.0};
    for (int i = 0; i < 7; ++i)
    {
        right.emplace_back(waves[i] - 0.04, low + step * i);
        left.emplace_back(waves[i] - 0.045, low + step * i);
    }
    Profile profile(right);
    profile.insert(profile.end(), left.rbegin(), left.rend());
    return profile;
}

Profile wall(double width, double low, double high)
{
    return {{-0.5 * width, low}, {0.5 * width, low}, {0.5 * width, high}, {-0.5 * width, high}};
}

} // namespace

void placeStretch(const osgRoads::core::PlacedNetwork& placed, int road,
                  const osgRoads::core::RoadObject& object, const ObjectInstance& stretch, RoadThings& into)
{
    const auto between = [stretch](double from, double to, double s)
    {
        return from +
               (to - from) * std::clamp((s - stretch.s) / std::max(stretch.sEnd - stretch.s, 1e-9), 0.0, 1.0);
    };
    const std::string words = object.type + " " + object.subtype + " " + object.name;
    const auto has = [&](const char* part) { return words.find(part) != std::string::npos; };
    const double width = std::max(stretch.width, stretch.widthEnd),
                 height = std::max(stretch.height, stretch.heightEnd);
    const bool isFence = has("fence"), isRail = !isFence && width <= 0.3 && height <= 1.2;
    RoadLine line;
    line.s = stretch.s;
    line.sEnd = stretch.sEnd;
    line.lineT = [=](double s) { return between(stretch.t, stretch.tEnd, s); };
    if (isRail)
    {
        line.tint = {0.62F, 0.64F, 0.65F};
        const double high = height > 0.0 ? height : 0.31,
                     low = height > 0.0 ? 0.0 : 0.44; // file without sizes: 0.75 m high
        line.profileAt = [=](double s)
        {
            const double z = between(stretch.z, stretch.zEnd, s);
            return beam(z + low, z + low + high);
        };
    }
    else
    {
        line.surface = {isFence ? models::Painting::planks : models::Painting::plaster, models::Coat::matt};
        line.tint = isFence ? glm::vec3(0.55F, 0.45F, 0.35F) : glm::vec3(0.62F, 0.61F, 0.59F);
        line.uvPerM = 1.0 / 2.4;
        line.profileAt = [=](double s)
        {
            const double z = between(stretch.z, stretch.zEnd, s);
            return wall(std::max(between(stretch.width, stretch.widthEnd, s), isFence ? 0.04 : 0.2), z,
                        z + std::max(between(stretch.height, stretch.heightEnd, s), 0.1));
        };
    }
    addRoadLine(placed, road, line, into);
}

} // namespace scenery::roads
