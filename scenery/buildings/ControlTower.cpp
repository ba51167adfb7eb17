// SPDX-License-Identifier: Apache-2.0
#include "scenery/buildings/ControlTower.h"

#include <algorithm>
#include <cstddef>

#include "scenery/buildings/Outline.h"

namespace scenery
{

namespace
{

constexpr double kSlenderLeastM = 2.0, kSlenderMostM = 9.0; ///< of the outline's width
constexpr double kShaftInShare = 0.26;                      ///< of half the width: the shaft is narrower
constexpr double kGalleryOutM = 0.9, kRoofOutM = 0.6, kCabSlabM = 0.35;
constexpr double kCutShare = 0.29; ///< of a side, at each of its ends: a square becomes a regular octagon

/// The ring without its corners.
PlanRing octagonOf(const PlanRing& ring)
{
    PlanRing cut;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
        const glm::dvec2 &from = ring[i], &to = ring[(i + 1) % ring.size()];
        cut.push_back(glm::mix(from, to, kCutShare));
        cut.push_back(glm::mix(from, to, 1.0 - kCutShare));
    }
    return cut;
}

/// A part of the tower between two heights above its floor. Units: metres.
StandingBuilding partOf(const StandingBuilding& tower, PlanRing ring, double lowM, double highM)
{
    StandingBuilding part = tower;
    part.building.rings = {std::move(ring)};
    part.building.liftedM = lowM;
    part.building.eavesM = highM;
    part.building.roof = RoofForm::flat;
    part.building.roofM = 0.0;
    part.building.openings = Openings::none;
    part.groundM.clear();
    return part;
}

} // namespace

std::vector<StandingBuilding> partsOfControlTower(const StandingBuilding& tower)
{
    const Building& whole = tower.building;
    const PlanRing& outline = whole.rings.front();
    const double halfM = rectangleAround(outline).halfWidthM, insetM = kShaftInShare * halfM;
    const bool isSlender = whole.rings.size() == 1 && whole.storeys >= 3 && whole.liftedM == 0.0 &&
                           halfM >= kSlenderLeastM && halfM <= kSlenderMostM &&
                           grownRing(outline, kGalleryOutM) != outline;
    if (!isSlender) return {tower};
    const double storeyM = whole.eavesM / whole.storeys, cabM = whole.eavesM - storeyM;
    const PlanRing octagon = outline.size() == 4 ? octagonOf(outline) : outline;

    StandingBuilding shaft = partOf(tower, grownRing(outline, -insetM), 0.0, cabM);
    shaft.building.storeys = whole.storeys - 1;
    shaft.building.openings = Openings::house;
    shaft.groundM = tower.groundM;
    const StandingBuilding gallery = partOf(tower, grownRing(octagon, kGalleryOutM), cabM - kCabSlabM, cabM);
    StandingBuilding cab = partOf(tower, octagon, cabM, whole.eavesM);
    cab.building.openings = Openings::control;
    StandingBuilding roof =
        partOf(tower, grownRing(octagon, kRoofOutM), whole.eavesM - 0.1, whole.eavesM + kCabSlabM);
    roof.building.roof = whole.roof;
    roof.building.roofM = whole.roofM;
    roof.building.wall = whole.cover;
    roof.building.wallTint = whole.roofTint;
    return {shaft, gallery, cab, roof};
}

} // namespace scenery
