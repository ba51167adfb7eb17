// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include <osgRoads/core/surface/RoadView.h>
#include <osgTerrainROAM/core/features/OpeningCells.h>
#include <osgTerrainROAM/core/roam/DiamondTree.h>

namespace scenery
{

/// What one view draws of ground and roads. Frame: the scene's.
struct DrawnScene
{
    const osgTerrainROAM::core::DiamondTree& ground; ///< as refined for this view
    const osgRoads::core::RoadMesh& roads;
    std::vector<osgRoads::core::ChunkChoice> choices; ///< of the roads for this view
    osgRoads::core::RoadViewSettings settings;
    viewlod::ViewState view;
    const osgTerrainROAM::core::OpeningCells* openings = nullptr; ///< where no ground is drawn; null: nowhere
};

/// A point at which something touches the surface, against the surface that is drawn there.
struct DrawnContact
{
    static constexpr double kNearM = 20.0, kMostNearM = 0.01, kMostFarPx = 1.0;

    glm::dvec3 place{0.0};
    double gapM = 0.0;      ///< of the drawn surface above the place, at right angles to the surface
    double distanceM = 0.0; ///< from the eye
    double gapPx = 0.0; ///< the same in the image, at its middle; at most 1.4 times as much in its corners

    /// Whether the gap is within 1 cm up to 20 m from the eye, within a pixel beyond.
    bool isKept() const
    {
        return distanceM <= kNearM ? std::abs(gapM) <= kMostNearM : std::abs(gapPx) <= kMostFarPx;
    }
};

/// Compares a place with the drawn surface: the highest of ground and roads that is not more than kHeadroomM
/// above it, so that a bridge is not what a car below it stands on. Nothing: nothing is drawn there.
std::optional<DrawnContact> contactAt(const DrawnScene& scene, const glm::dvec3& place);

inline constexpr double kHeadroomM = 2.0;

} // namespace scenery
