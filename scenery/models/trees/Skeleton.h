// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "scenery/models/Dice.h"
#include "scenery/models/trees/TreeForm.h"

namespace scenery::models
{

/// A limb of a tree: a line from its base to its tip with a radius at each point.
struct Limb
{
    std::vector<glm::dvec3> line;
    std::vector<double> radiiM;
};

/// The space of a crown: a body of revolution about the vertical through `middle`.
struct Crown
{
    double baseM = 0.0, topM = 1.0, radiusM = 1.0;
    double (*profile)(double) = nullptr;

    double shareOf(double zM) const { return (zM - baseM) / (topM - baseM); }
    /// Returns the distance from the axis as a share of the radius at that height; below 1 inside.
    double depthOf(const glm::dvec3& place) const;
    /// Returns the outward normal of a smooth body of that size.
    glm::vec3 normalAt(const glm::dvec3& place) const;
};

/// Grows the limbs of a tree: trunks from one root, boughs around them in a spiral of the golden angle, twigs
/// on both sides of the boughs. Boughs grow until they leave the crown.
/// Source: Weber & Penn, *Creation and Rendering of Realistic Trees*, 1995, section 4: branching, curvature
/// and taper. Differs: boughs grow to the envelope of the crown instead of a length by shape, which keeps the
/// outline for every seed.
struct Skeleton
{
    Crown crown;
    double heightM = 0.0;
    std::vector<Limb> trunks, boughs, twigs;
};
Skeleton growSkeleton(const TreeForm& form, Dice& dice);

/// The depth of trunks in the ground.
constexpr double kRootM = 0.4;

} // namespace scenery::models
