// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace simulation
{

enum class DistanceFrame
{
    entity, ///< axes of the entity that measures
    road,   ///< along and across the reference line
    lane,   ///< along and across the lane
    trajectory,
    world, ///< axes of the scene
};

enum class DistanceKind
{
    euclidean,
    longitudinal,
    lateral,
};

/// How a distance between two entities is measured. Source: ASAM OpenSCENARIO XML 1.3, "Distances".
struct DistanceMeasure
{
    DistanceFrame frame = DistanceFrame::entity;
    DistanceKind kind = DistanceKind::euclidean;
    bool isFreespace = false; ///< between bounding boxes, not reference points

    bool operator==(const DistanceMeasure&) const = default;
};

} // namespace simulation
