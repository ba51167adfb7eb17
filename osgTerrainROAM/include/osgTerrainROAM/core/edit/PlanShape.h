// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace osgTerrainROAM::core
{

/// A horizontal rectangle. Frame: the tile's, x and y. Units: metres.
struct PlanBox
{
    glm::dvec2 low{0.0}, high{0.0};

    PlanBox grownBy(double metres) const { return {low - metres, high + metres}; }
};

/// A horizontal region of the ground: a circle, or a polygon without self-intersections.
/// Frame: the tile's, x and y. Units: metres.
class Region
{
public:
    static Region circle(const glm::dvec2& centre, double radiusM);
    static Region polygon(std::vector<glm::dvec2> corners); ///< three or more, in either direction

    /// Signed distance from the border, metres: positive inside, negative outside.
    double insideM(const glm::dvec2& place) const;
    PlanBox box() const;
    bool isEmpty() const { return _corners.size() < 3 && _radiusM <= 0.0; }

private:
    std::vector<glm::dvec2> _corners; ///< empty: a circle
    glm::dvec2 _centre{0.0};
    double _radiusM = 0.0;
};

/// A horizontal polyline, parametrised by its length.
class PlanLine
{
public:
    explicit PlanLine(std::vector<glm::dvec2> points);

    /// The foot of a point is the nearest point of the line. alongM has no jump at bends: within each segment
    /// it is interpolated between the bisectors of the bends at its two ends.
    struct Foot
    {
        double alongM;    ///< from the beginning
        double distanceM; ///< from the line
    };
    Foot footOf(const glm::dvec2& place) const;

    glm::dvec2 at(double alongM) const;
    double lengthM() const { return _alongM.back(); }
    std::size_t size() const { return _points.size(); }
    double alongM(std::size_t point) const { return _alongM[point]; }

    /// Boxes that together contain all points within `reachM` of the line; each is about as long as `reachM`.
    std::vector<PlanBox> boxes(double reachM) const;

private:
    std::vector<glm::dvec2> _points;
    std::vector<glm::dvec2>
        _ways; ///< unit directions at the points; the bisectors of the bends are perpendicular to them
    std::vector<double> _alongM;
};

} // namespace osgTerrainROAM::core
