// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <osgRoads/core/query/PaintedItem.h>
#include <osgRoads/core/surface/Decal.h>

namespace osgRoads::core
{

/// Makes decals in the frame of one item on a road: u ahead, v to the left of it. Units: metres.
class DecalMaker
{
public:
    /// `headingRad`: of u to the road.
    DecalMaker(const PlacedNetwork& network, int road, double s, double t, double headingRad,
               std::vector<Decal>& into);

    /// Returns a point of the scene in the item's frame.
    glm::dvec2 toItem(const glm::dvec3& scene) const;

    /// Returns a corner of an outline in the item's frame.
    glm::dvec2 cornerOf(const OutlineCorner& corner) const;

    void setPaint(const glm::vec3& paint) { _paint = paint; }

    /// Adds a bar of one width between two points.
    void bar(glm::dvec2 from, glm::dvec2 to, double width);
    /// Adds a bar of stripes. It begins `phase` after the start of one.
    void stripedBar(glm::dvec2 from, glm::dvec2 to, double width, double dash, double period,
                    double phase = 0.0);
    /// Adds an arrow of 5 m times `scale` around the origin.
    void arrow(const ArrowHeads& heads, double scale);
    /// Adds a polygon, with stripes at right angles to `axis`; period 0: without. Cuts it into trapezoids at
    /// its corners.
    void area(std::span<const glm::dvec2> corners, glm::dvec2 axis, double dash, double period);

private:
    Decal decal(glm::dvec2 from, glm::dvec2 along) const;
    void add(Decal decal, double length, double widthStart, double widthEnd, double shift);
    void sideHead(int side, double u, double scale);

    const PlacedNetwork& _network;
    int _road;
    glm::dvec3 _origin;
    glm::dvec2 _ahead;
    glm::vec3 _paint;
    std::vector<Decal>& _into;
};

} // namespace osgRoads::core
