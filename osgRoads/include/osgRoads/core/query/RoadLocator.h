// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <osgRoads/core/query/RoadPosition.h>

namespace osgRoads::core
{

/// Where a point is with respect to a road.
struct RoadMatch
{
    RoadPosition position;
    double distance = 0.0; ///< metres from the nearest point of the road's lanes; 0 on them
};

/// Finds the roads at inertial positions, without a hint of where to look.
/// The distance of a road is that of its lanes, not of its reference line. Of roads at the same distance
/// (several lie over each other in a junction) the one with the nearest reference line counts, then the first
/// in the file.
/// Memory: about 150 bytes for each 20 m of road. Threads: any number may ask at the same time.
/// Errors of a position: 1e-9 m on lines and arcs, 1e-8 m on other curves, at any distance up to 1e7 m from
/// the origin.
class RoadLocator
{
public:
    /// `network` must stay as it is while the locator is used.
    explicit RoadLocator(const RoadNetwork& network);
    ~RoadLocator();
    RoadLocator(RoadLocator&&) noexcept;
    RoadLocator& operator=(RoadLocator&&) noexcept;

    /// Returns the nearest road in the plan view and the position on its surface. Nothing: no road within
    /// `withinM`.
    std::optional<RoadMatch> nearest(glm::dvec2 point, double withinM = kAnywhereM) const;

    /// Returns the nearest road in space: under a bridge the road below, on it the bridge. The position has
    /// the h of the point; its distance counts the height above or below the surface.
    std::optional<RoadMatch> nearest(const glm::dvec3& point, double withinM = kAnywhereM) const;

    /// Returns every road whose lanes are not farther from the point than `withinM` in the plan view, nearest
    /// first.
    std::vector<RoadMatch> within(glm::dvec2 point, double withinM) const;

    /// Tells whether `holds` says so of a place on any road but `road` whose lanes are not farther from the
    /// point than `withinM` in the plan view. It is asked for several places of a road, in any order, until
    /// it holds: cheaper than within() where the answer is often yes.
    bool holdsOnOther(glm::dvec2 point, double withinM, int road,
                      const std::function<bool(const RoadMatch&)>& holds) const;

    static constexpr double kAnywhereM = 1e9;

private:
    struct Index;

    std::unique_ptr<const Index> _index;
};

} // namespace osgRoads::core
