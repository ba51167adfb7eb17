// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "worldmaking/land/Runways.h"
#include "worldmaking/madeup/GroundGrid.h"
#include "worldmaking/madeup/MadeShapes.h"

namespace worldmaking
{

/// An airfield of a made-up map. Frame: the plane. Units: metres.
struct Airfield
{
    glm::dvec2 from{0.0}, to{0.0}; ///< ends of its runway
    glm::dvec2 apronSide{0.0};     ///< unit vector across the runway, towards the apron
    double unevenM = 0.0;          ///< the ground's greatest distance from a plane along the runway

    static constexpr double kLengthM = 1500.0, kWidthM = 30.0;

    glm::dvec2 along() const { return glm::normalize(to - from); }
    /// What stays free of everything: the strip, the aprons, and the way in over both ends.
    PlanRings ground() const;
    std::vector<PlanRings> approaches() const; ///< where no wood and no house stands
    glm::dvec2 gate() const;                   ///< where its road begins
    std::string designators() const;           ///< "09/27", by the heading in the plane
    MadeShapes shapes() const;                 ///< taxiways, apron, hangars, tower, windsock
};

/// Looks for the gentlest ground for a runway of 1500 m: everywhere, in twelve directions. Nothing: the
/// ground is nowhere within kMostUnevenM of a line of kMostGrade at most.
std::optional<Airfield> airfieldOn(const GroundGrid& ground);

inline constexpr double kMostUnevenM = 7.0, kMostGrade = 0.018;

} // namespace worldmaking
