// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/vec2.hpp>

namespace osgTerrainROAM::core
{

/// An outline with holes whose edges are sorted into rows, so that long shores are asked quickly. Units:
/// metres.
class OutlineRows
{
public:
    explicit OutlineRows(const std::vector<std::vector<glm::dvec2>>& rings);

    /// By the even-odd rule.
    bool contains(const glm::dvec2& place) const;

    /// The distance from the nearest edge; `withinM` where none is nearer.
    double distanceM(const glm::dvec2& place, double withinM) const;

private:
    struct Edge
    {
        glm::dvec2 a, b;
    };

    int rowOf(double y) const;

    double _lowY = 0.0;
    std::vector<std::vector<Edge>> _rows; ///< each edge in every row that it touches
};

} // namespace osgTerrainROAM::core
