// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>

#include <osgRoads/core/query/RoadPosition.h>

namespace osgRoads::core
{

/// Lays a network into a scene: says where a point of the file's inertial frame lies in the scene's frame,
/// and back.
/// Units: metres. Threads: any number may ask at the same time.
class RoadDatum
{
public:
    virtual ~RoadDatum() = default;

    /// Returns the place in the scene of a position on a road. `inertial`: that position in the file's frame.
    virtual glm::dvec3 toScene(const RoadPosition& position, const glm::dvec3& inertial) const = 0;

    /// Returns the inertial place of a point of the scene. Its plan position is exact; its height is that
    /// above the file's own zero, without what toScene() adds for the road that lies there.
    virtual glm::dvec3 toInertial(const glm::dvec3& scene) const = 0;
};

} // namespace osgRoads::core
