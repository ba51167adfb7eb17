// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <osgRoads/core/query/RoadLocator.h>

#include "simulation/road/RoadPlace.h"

namespace simulation
{

/// How something stands on a road. Angles as EntityState has them: heading from x towards y, pitch positive
/// nose down, roll positive right side down. Units: metres, radians.
struct RoadPose
{
    glm::dvec3 position{0.0};
    double headingRad = 0.0, pitchRad = 0.0, rollRad = 0.0;
};

/// The roads that the entities of a scenario drive on: an OpenDRIVE network with a look-up of places.
/// Frame: the inertial frame of the file, which is the scene's.
/// Threads: any number may ask at the same time.
class RoadScene
{
public:
    /// Errors: as osgRoads::core::readNetwork().
    static foundation::Result<std::shared_ptr<const RoadScene>> open(const std::filesystem::path& file);

    /// `mistakes`: of its file, as lines.
    explicit RoadScene(osgRoads::core::RoadNetwork network, std::vector<foundation::Error> mistakes = {});

    /// What breaks the standard in the file, and what is done instead: the first ten, and how many more.
    const std::vector<foundation::Error>& mistakes() const { return _mistakes; }

    const osgRoads::core::RoadNetwork& network() const { return _network; }
    const osgRoads::core::Road& roadAt(const RoadPlace& place) const
    {
        return _network.roads[static_cast<std::size_t>(place.road)];
    }

    /// Returns a place on a lane, looking along its traffic; nothing: no such road or lane at s.
    std::optional<RoadPlace> onLane(const std::string& roadId, int lane, double s, double offsetM) const;

    /// Returns a place at (s, t), on the lane that is nearest there, looking along its traffic; nothing: no
    /// such road.
    std::optional<RoadPlace> onTrack(const std::string& roadId, double s, double t) const;

    /// Returns the place of a point on the nearest road, its height kept; nothing: there is no road.
    std::optional<RoadPlace> nearest(const glm::dvec3& point, double headingRad) const;

    /// Returns how something stands at a place, its reference point on the surface.
    RoadPose poseAt(const RoadPlace& place) const;

    /// Puts a place onto a lane at its s; its t and curvature follow from lane and offset. False: there is no
    /// such lane.
    bool putOnLane(RoadPlace& place, int lane, double offsetM) const;

    /// Takes the lane that is nearest to t, and the offset from its middle.
    void takeNearestLane(RoadPlace& place) const;

    /// Puts a place onto the middle of the nearest lane at its s that carries traffic the way the place
    /// looks, and lets it look along that; where all run the other way onto the nearest of them, and it looks
    /// as before. False: no lane there carries traffic.
    bool takeLaneAhead(RoadPlace& place) const;

    /// Whether traffic on the lane of the place runs towards greater s.
    bool runsForward(const RoadPlace& place) const;

    /// Whether the lanes of any road come as near to a position as that, in the plan. Units: metres.
    bool hasRoadWithin(double distanceM, const glm::dvec3& position) const
    {
        return !_locator.within(glm::dvec2(position), distanceM).empty();
    }

    /// Returns the roads, by index, whose lanes come as near to a point as that, in the plan. Units: metres.
    std::vector<int> roadsWithin(double distanceM, const glm::dvec2& point) const;

    /// Whether the lanes at a place, sidewalks and verges not counted, are under it.
    bool isOffRoad(const RoadPlace& place, const glm::dvec3& position) const;

private:
    RoadPlace looking(RoadPlace place) const;

    osgRoads::core::RoadNetwork _network;
    osgRoads::core::RoadLocator _locator;
    std::vector<foundation::Error> _mistakes;
};

} // namespace simulation
