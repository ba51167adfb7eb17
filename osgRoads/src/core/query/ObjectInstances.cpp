// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 13.3 (object outline), 13.4 (repeating objects).
#include <algorithm>
#include <cmath>

#include <osgRoads/core/query/ObjectInstances.h>
#include <osgRoads/core/query/RoadSurface.h>

namespace osgRoads::core
{

namespace
{

ObjectInstance plainInstance(const RoadObject& object)
{
    ObjectInstance instance;
    instance.s = object.s;
    instance.t = object.t;
    instance.z = object.zOffset;
    instance.headingRad = object.headingRad;
    instance.pitchRad = object.pitchRad;
    instance.rollRad = object.rollRad;
    instance.length = object.length;
    instance.width = object.width;
    instance.height = object.height;
    instance.radius = object.radius;
    return instance;
}

double between(double from, double to, double share)
{
    return from + (to - from) * share;
}

double between(const std::optional<double>& from, const std::optional<double>& to, double otherwise,
               double share)
{
    return between(from.value_or(otherwise), to.value_or(from.value_or(otherwise)), share);
}

/// The object so far along a repeat: share 0 at its start, 1 at its end.
ObjectInstance instanceAt(const RoadObject& object, const ObjectRepeat& repeat, double share)
{
    ObjectInstance instance = plainInstance(object);
    instance.s = repeat.s + repeat.length * share;
    instance.t = between(repeat.tStart, repeat.tEnd, share);
    instance.z = between(repeat.zOffsetStart, repeat.zOffsetEnd, share);
    instance.length = between(repeat.lengthStart, repeat.lengthEnd, object.length, share);
    instance.width = between(repeat.widthStart, repeat.widthEnd, object.width, share);
    instance.height = between(repeat.heightStart, repeat.heightEnd, object.height, share);
    instance.radius = between(repeat.radiusStart, repeat.radiusEnd, object.radius, share);
    return instance;
}

ObjectInstance stretch(const RoadObject& object, const ObjectRepeat& repeat)
{
    ObjectInstance instance = instanceAt(object, repeat, 0.0);
    const ObjectInstance end = instanceAt(object, repeat, 1.0);
    instance.isStretch = true;
    instance.sEnd = end.s;
    instance.tEnd = end.t;
    instance.zEnd = end.z;
    instance.widthEnd = end.width;
    instance.heightEnd = end.height;
    return instance;
}

} // namespace

std::vector<ObjectInstance> objectInstances(const RoadObject& object)
{
    if (object.repeats.empty()) return {plainInstance(object)};
    std::vector<ObjectInstance> instances;
    for (const ObjectRepeat& repeat : object.repeats)
    {
        if (repeat.distance <= 0.0)
        {
            instances.push_back(stretch(object, repeat));
            continue;
        }
        for (double along = 0.0; along <= repeat.length + 1e-9 && instances.size() < kMostInstances;
             along += repeat.distance)
            instances.push_back(
                instanceAt(object, repeat, repeat.length > 0.0 ? along / repeat.length : 0.0));
    }
    return instances;
}

std::vector<glm::dvec3> outlineCorners(const Road& road, const RoadObject& object,
                                       const ObjectOutline& outline)
{
    const RoadFrame frame = frameAt(road, object.s);
    const glm::dvec3 origin = surfacePoint(road, object.s, object.t);
    const double heading = frame.headingRad + object.headingRad;
    const glm::dvec2 along(std::cos(heading), std::sin(heading));
    std::vector<glm::dvec3> corners;
    for (const OutlineCorner& corner : outline.corners)
    {
        if (corner.isOnRoad)
            corners.push_back(surfacePoint(road, corner.s, corner.t) + glm::dvec3(0.0, 0.0, corner.z));
        else
            corners.emplace_back(origin.x + corner.s * along.x - corner.t * along.y,
                                 origin.y + corner.s * along.y + corner.t * along.x,
                                 origin.z + object.zOffset + corner.z);
    }
    return corners;
}

} // namespace osgRoads::core
