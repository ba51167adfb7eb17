// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "simulation/road/RoadScene.h"
#include "simulation/scenario/Distance.h"
#include "simulation/scenario/Entity.h"
#include "simulation/state/EntityState.h"

namespace simulation
{

/// An entity, or a point without extent, whose distance is measured.
struct MeasuredBody
{
    const EntityState* state = nullptr;
    BoundingBox box;
};

/// Returns the distance from one body to another, in metres. Longitudinal distances are positive ahead of
/// `from`, lateral ones to its left; freespace ones are 0 where the boxes overlap in that direction. Nothing:
/// no road leads from one to the other. All are in the plan view, as in esmini. The frame `lane` measures
/// along the lanes, `trajectory` counts as `road`. Source: ASAM OpenSCENARIO XML 1.3, "Distances".
std::optional<double> distanceBetween(const MeasuredBody& from, const MeasuredBody& to,
                                      const DistanceMeasure& measure, const RoadScene* roads);

/// How far a box reaches around its reference point in the plan view, at most. Units: metres.
double reachOf(const BoundingBox& box);

/// Whether the boxes of two bodies overlap in the plan view, by the separating axis theorem.
bool overlap(const MeasuredBody& first, const MeasuredBody& second);

} // namespace simulation
