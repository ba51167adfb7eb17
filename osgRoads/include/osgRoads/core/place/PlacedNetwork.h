// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <glm/vec3.hpp>

#include <osgRoads/core/network/RoadNetwork.h>
#include <osgRoads/core/place/RoadBed.h>
#include <osgRoads/core/place/RoadDatum.h>
#include <osgRoads/core/query/RoadLocator.h>

namespace osgRoads::core
{

/// A network in the frame of a scene: what is drawn, what the ground is cut to and what wheels stand on all
/// ask here. Without a datum the scene's frame is the inertial frame of the file.
/// Ownership: shares network and datum. Threads: any number may ask at the same time.
class PlacedNetwork
{
public:
    explicit PlacedNetwork(std::shared_ptr<const RoadNetwork> network,
                           std::shared_ptr<const RoadDatum> datum = nullptr);

    const RoadNetwork& network() const { return *_network; }
    const Road& road(int index) const { return _network->roads[static_cast<std::size_t>(index)]; }
    const RoadLocator& locator() const { return _locator; }

    /// Returns the place of a road position (h above the road plane). Frame: the scene's.
    glm::dvec3 point(const RoadPosition& position) const;

    /// The same for a position whose inertial place is known.
    glm::dvec3 toScene(const RoadPosition& position, const glm::dvec3& inertial) const
    {
        return _datum ? _datum->toScene(position, inertial) : inertial;
    }

    /// Returns the place of the surface at (s, t), lane heights included; beside the lanes the cross-section
    /// goes on.
    glm::dvec3 surfacePoint(int road, double s, double t) const;

    /// Returns the place of the surface where the locator has found a road: on its lanes as surfacePoint(),
    /// beside them that of the verge, which falls outwards whatever the superelevation. Farther out than
    /// `mostOutM` it is the place there.
    glm::dvec3 surfaceAt(const RoadMatch& match, const RoadBed& bed, double mostOutM = 1e9) const;

    /// Returns the inertial place of a point of the scene, for look-ups.
    glm::dvec3 toInertial(const glm::dvec3& scene) const
    {
        return _datum ? _datum->toInertial(scene) : scene;
    }

private:
    std::shared_ptr<const RoadNetwork> _network;
    std::shared_ptr<const RoadDatum> _datum; ///< null: the scene's frame is the file's
    RoadLocator _locator;
};

} // namespace osgRoads::core
