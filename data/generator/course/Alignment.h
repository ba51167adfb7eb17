// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include <osgRoads/core/geometry/ReferenceLine.h>

namespace islandgen
{

/// The least and the largest radius of a bend, and the least straight between two of them, metres.
inline constexpr double kLeastRadiusM = 90.0, kLargestRadiusM = 600.0, kLeastStraightM = 40.0;

/// A bend of a closed course: spiral, arc, spiral, along the course from `startM` to `endM`.
struct Bend
{
    double startM = 0.0, endM = 0.0;
    double spiralM = 0.0; ///< length of each spiral
    double radiusM = 0.0; ///< of the arc
    bool isLeft = false;
};

/// A closed course in the plan view: straights and bends in turn, with curvature that has no jump. It begins
/// with the straight behind the last bend.
/// Frame: metres east and north of the terrain's middle.
struct Alignment
{
    std::vector<osgRoads::core::PlanElement> elements;
    std::vector<Bend> bends; ///< bend i comes behind straight i: its elements are 4·i + 1 … 4·i + 3
    double lengthM = 0.0;

    /// Returns the line to ask for points, from 0 to lengthM.
    osgRoads::core::ReferenceLine line() const { return osgRoads::core::ReferenceLine(elements); }
};

/// Rounds the corners of a closed polygon. The radius of each bend is the largest that its two edges allow,
/// kLargestRadiusM at most. Returns nothing where a bend would be tighter than kLeastRadiusM, or a corner
/// turns by less than 3° or more than 120°.
/// Source: Hickerson, Route Location and Design (1964), chapter 10: a spiral of length l before an arc of
/// radius r moves the arc inwards by its shift and lengthens the tangent.
std::optional<Alignment> alignmentOf(const std::vector<glm::dvec2>& corners);

} // namespace islandgen
