// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "worldmaking/plan/RoadRoom.h"

class OGRGeometry;

namespace worldmaking
{

/// Areas of the plane that are joined, grown and cut out of each other. A value that cannot be changed.
/// Units: metres.
/// Source: GEOS, through OGR.
class PlanArea
{
public:
    PlanArea() = default; ///< nothing
    explicit PlanArea(const PlanRings& rings);

    /// What lies within a distance of a line; corners rounded.
    static PlanArea around(const std::vector<glm::dvec2>& line, double radiusM);
    static PlanArea joined(const std::vector<PlanArea>& areas);

    PlanArea grown(double byM) const; ///< negative: shrunk
    PlanArea without(const PlanArea& other) const;
    PlanArea simpler(double byM) const;
    bool meets(const PlanArea& other) const;
    bool isEmpty() const { return !_shape; }

    /// The outlines of its parts of at least `leastM2`, in their order.
    std::vector<PlanRings> parts(double leastM2) const;

private:
    explicit PlanArea(std::shared_ptr<const OGRGeometry> shape);

    std::shared_ptr<const OGRGeometry> _shape; ///< null: nothing
};

/// An outline grown by a distance: its first part, or what it was where nothing is left.
PlanRings grownRings(const PlanRings& rings, double byM);

} // namespace worldmaking
