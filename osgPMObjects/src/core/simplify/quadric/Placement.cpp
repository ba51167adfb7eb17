// SPDX-License-Identifier: Apache-2.0
#include "Placement.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace osgPMObjects::core
{

namespace
{

constexpr double kPull =
    1e-7; ///< towards the middle, as a share of the quadric's trace: affects flat directions only

/// Solves in a frame with its origin in the middle of the edge. Without the constraint the place x is where
/// sum · x = wanted.
glm::dvec3 leastKeepingVolume(const CollapsingEdge& edge, glm::dmat3 sum, const glm::dvec3& wanted)
{
    const glm::dvec3 half = 0.5 * (edge.to - edge.from);
    const double pull = kPull * (sum[0][0] + sum[1][1] + sum[2][2]);
    for (int i = 0; i < 3; ++i)
        sum[i][i] += pull;
    const double determinant = glm::determinant(sum);
    if (!(determinant > 0.0)) return glm::dvec3(0.0);
    const glm::dmat3 inverse = glm::inverse(sum);
    const glm::dvec3 least = inverse * wanted;
    // The planes of the faces beside the edge contain its middle, so they add nothing to the volume in this
    // frame.
    const glm::dvec3 area = edge.fromShape.areaVector + edge.toShape.areaVector - edge.sharedAreaVector;
    const double volume = glm::dot(edge.toShape.areaVector - edge.fromShape.areaVector, half);
    const glm::dvec3 towards = inverse * area;
    const double stiffness = glm::dot(area, towards);
    if (!(stiffness > 0.0)) return least;
    return least + (volume - glm::dot(area, least)) / stiffness * towards;
}

/// The middle of the edge where the place is farther from there than the edge is long.
glm::dvec3 placeNear(const CollapsingEdge& edge, glm::dvec3 offset)
{
    const glm::dvec3 half = 0.5 * (edge.to - edge.from);
    if (!(glm::length(offset) <= 2.0 * glm::length(half))) offset = glm::dvec3(0.0);
    return edge.from + half + offset;
}

} // namespace

glm::dvec3 sharedAreaVector(const Star& star, std::uint32_t to)
{
    glm::dvec3 shared(0.0);
    for (const Star::Side& side : star.sidesTo(to))
        shared += star.faces[side.spoked].doubleArea * star.faces[side.spoked].normal;
    return shared;
}

double costAt(const CollapsingEdge& edge, const glm::dvec3& at)
{
    return std::max(0.0, edge.fromShape.quadric.at(at - edge.from) + edge.toShape.quadric.at(at - edge.to));
}

glm::dvec3 bestPlace(const CollapsingEdge& edge)
{
    const glm::dvec3 half = 0.5 * (edge.to - edge.from);
    const glm::dmat3 from = edge.fromShape.quadric.matrix(), to = edge.toShape.quadric.matrix();
    return placeNear(edge, leastKeepingVolume(edge, from + to, to * half - from * half));
}

glm::dvec3 bestPlace(const CollapsingEdge& edge, const AccumulatedQuadric& aboutMiddle)
{
    return placeNear(edge, leastKeepingVolume(edge, aboutMiddle.planes.matrix(), -aboutMiddle.linear));
}

} // namespace osgPMObjects::core
