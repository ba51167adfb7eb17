// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace osgTerrainROAM::core
{

/// A rectangle in the plan. Frame: the tile's, x and y. Units: metres.
struct PlanBox
{
    glm::dvec2 low{0.0}, high{0.0};

    PlanBox grownBy(double metres) const { return {low - metres, high + metres}; }
};

/// A region of the ground in the plan: a circle or a polygon without self-intersections.
/// Frame: the tile's, x and y. Units: metres.
class Region
{
public:
    static Region circle(const glm::dvec2& centre, double radiusM);
    static Region polygon(std::vector<glm::dvec2> corners); ///< three or more, in either direction

    /// From the border: positive inside, negative outside.
    double insideM(const glm::dvec2& place) const;
    PlanBox box() const;
    bool isEmpty() const { return _corners.size() < 3 && _radiusM <= 0.0; }

private:
    std::vector<glm::dvec2> _corners; ///< empty: a circle
    glm::dvec2 _centre{0.0};
    double _radiusM = 0.0;
};

/// A line in the plan with something that changes along it.
class PlanLine
{
public:
    explicit PlanLine(std::vector<glm::dvec2> points);

    /// The nearest place of the line. At bends the way along it goes on without a jump on the inner side, too: it is shared out
    /// between the lines that halve the bends at either end of a stretch.
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

    /// Boxes that together hold all within `reachM` of the line, none much longer than that.
    std::vector<PlanBox> boxes(double reachM) const;

private:
    std::vector<glm::dvec2> _points;
    std::vector<glm::dvec2>
        _ways; ///< at the points, of unit length: across them lie the lines that halve the bends
    std::vector<double> _alongM;
};

} // namespace osgTerrainROAM::core
