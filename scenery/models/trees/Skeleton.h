// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "scenery/models/Dice.h"
#include "scenery/models/trees/TreeForm.h"

namespace scenery::models
{

/// A limb of a tree: a line with a radius at each point, from where it grows to its tip.
struct Limb
{
    std::vector<glm::dvec3> line;
    std::vector<double> radiiM;
};

/// The space that a crown fills: a body of revolution about the vertical through `middle`.
struct Crown
{
    double baseM = 0.0, topM = 1.0, radiusM = 1.0;
    double (*profile)(double) = nullptr;

    double shareOf(double zM) const { return (zM - baseM) / (topM - baseM); }
    /// Distance from its axis as a share of its width there: below 1 inside.
    double depthOf(const glm::dvec3& place) const;
    /// Outwards, as on a smooth body of that size.
    glm::vec3 normalAt(const glm::dvec3& place) const;
};

/// The limbs of a tree: trunks out of one root, boughs in a spiral of the golden angle about them, twigs on both sides of
/// the boughs; boughs grow until they leave the crown.
/// Source: the branching after Weber and Penn, "Creation and rendering of realistic trees" (1995), §4, with their curvature
/// and tapering; their lengths by shape are replaced with growth until the envelope is met, which keeps every seed's outline.
struct Skeleton
{
    Crown crown;
    double heightM = 0.0;
    std::vector<Limb> trunks, boughs, twigs;
};
Skeleton growSkeleton(const TreeForm& form, Dice& dice);

/// How far trunks reach into the ground.
constexpr double kRootM = 0.4;

} // namespace scenery::models
