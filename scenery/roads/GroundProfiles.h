// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <osgRoads/core/geometry/CubicBounds.h>
#include <osgRoads/core/network/RoadNetwork.h>
#include <osgRoads/core/query/RoadPosition.h>

#include "scenery/roads/BaseSurface.h"
#include "scenery/roads/HeightSpline.h"
#include "scenery/roads/RoadChains.h"

namespace scenery
{

/// What roads that are laid on ground may do. Units: metres, metres per metre.
struct GroundProfileLimits
{
    double grade =
        0.10; ///< along a reference line, the file's own elevation included (where that is less steep)
    double junctionSlope = 0.04; ///< of the plane of a junction
    double runInM =
        30.0; ///< from a junction: there a road leaves its plane; bends in height are as long, twice
    double stepM = 5.0; ///< between the coefficients of a profile
};

/// The heights on which the roads of a network lie when its file knows no ground: along each road a profile
/// with bounded grade and continuous curvature, in each junction a plane. Roads have the profile of their
/// reference line right across, so none leans with the hillside; within runInM of a junction they turn into
/// its plane, so roads that are linked or meet in a junction have one height at every point they share. Bends
/// in height have a radius of runInM / grade or more: (10 % up, then 10 % down) 300 m. Roads between
/// junctions that are less than 4 · runInM apart have a shorter run-in, and sharper bends.
/// Method: heights of the smoothed ground, fitted to the limits over the whole network (HeightFit.h),
/// averaged over ± runInM, which keeps straight lines and grades, as coefficients of uniform cubic B-splines.
/// Limits that a file makes impossible are exceeded as little as the fit can do.
/// Frame: the network's plan. Units: metres. Threads: const, any. Memory: 8 B for each stepM of road.
class GroundProfiles
{
public:
    GroundProfiles(std::shared_ptr<const osgRoads::core::RoadNetwork> network, BaseSurface ground,
                   const GroundProfileLimits& limits = {});

    /// Returns the height of the road's base at a place on it. `plan`: that place; beside the road the
    /// cross-section goes on.
    double heightM(const osgRoads::core::RoadPosition& position, const glm::dvec2& plan) const;

    const BaseSurface& ground() const { return _ground; }

private:
    /// The plane in which the roads of an area meet.
    struct Plane
    {
        glm::dvec2 middle{0.0}, gradient{0.0};
        double heightM = 0.0; ///< in the middle

        double at(const glm::dvec2& plan) const { return heightM + glm::dot(gradient, plan - middle); }
    };
    /// The profile of a chain of roads.
    struct Profile
    {
        HeightSpline spline;
        double runInM = 0.0;
        int startPlane = -1, endPlane = -1;
    };
    /// Where the heights of a road come from.
    struct Source
    {
        int plane = -1;   ///< the road lies in it wholly
        int profile = -1; ///< else it has a part of one
        double startM = 0.0;
        bool isReversed = false;
    };
    /// Coefficients of a chain before they are fitted.
    struct Draft;

    Plane planeOf(const MeetingArea& area, double steepest) const;
    Draft draftOf(const RoadChain& chain, const GroundProfileLimits& limits) const;
    osgRoads::core::ValueRange ownGrades(const RoadChain& chain, double fromM, double stepM) const;
    static void limitRises(Draft& draft, const std::vector<osgRoads::core::ValueRange>& own, double grade);
    void fit(const std::vector<RoadChain>& chains, std::vector<Draft>& drafts);
    Profile profileOf(const RoadChain& chain, Draft draft) const;
    void index(const RoadChains& parts);

    const osgRoads::core::Road& road(int index) const
    {
        return _network->roads[static_cast<std::size_t>(index)];
    }

    std::shared_ptr<const osgRoads::core::RoadNetwork> _network;
    BaseSurface _ground;
    std::vector<Plane> _planes;
    std::vector<Profile> _profiles;
    std::vector<Source> _sources; ///< of each road
};

} // namespace scenery
