// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <glm/glm.hpp>

#include <osgRoads/core/place/PlacedNetwork.h>
#include <osgRoads/core/place/RoadBed.h>
#include <osgTerrainROAM/core/heightfield/TileFrame.h>

#include "scenery/roads/TornRoads.h"

namespace scenery
{

/// The cross-section of the ground that carries roads. Units: metres.
struct RoadCutShape
{
    osgRoads::core::RoadBed bed;
    double slope = 1.0 / 1.5;     ///< of the ground that is kept off bridges and portals
    double reachM = 40.0;         ///< from the lanes; at it any ground is left as it is
    double structureM = 12.0;     ///< the same of bridges
    double vergeEndM = 0.1;       ///< the ground meets the mesh's skirt so far below the verge's outer edge
    double riseM = 1.0;           ///< width over which the bed comes up to there
    double sampleM = 2.0;         ///< between the samples of the ground
    double abutmentSamples = 1.2; ///< so far into a bridge the bed of the road before it goes on
    double deckM = 1.5;           ///< from a bridge's road down to where ground may be
    double portalSlope = 2.0;     ///< of the ground that rises behind a portal, over its tube
    double portalBackM = 3.0;     ///< from the portal to where it begins; more than a sample
    std::shared_ptr<const TornRoads> torn; ///< where roads ask nothing of the ground; null: nowhere
};

/// The heights that the ground may have at a place. A low above the high yields: no road is buried.
/// Units: metres in the samples' datum.
struct HeightBand
{
    double lowM = -1e9, highM = 1e9;
    bool isBed = false; ///< the place lies under lanes or a verge

    bool isOpen() const { return lowM < -1e8 && highM > 1e8; }
    double nearestTo(double heightM) const
    {
        const double raised = heightM > lowM ? heightM : lowM;
        return raised < highM ? raised : highM;
    }
};

/// Returns what the roads at a point of the scene ask of the ground there: a bed under lanes and verge, of
/// which the lowest wins; so does that of a lower road whose lanes are as near as a sample, since a triangle
/// of the ground from here to there must not lie over them. Elsewhere ground is kept below the decks of
/// bridges, and behind portals it rises in a slope; over a tunnel it is left as it is (tunnelOpenings() has
/// its inside). What lies between roads is RoadEdges' business. `scene`: on the ground as it was.
/// Threads: const, any. Cost: some microseconds.
HeightBand roadBand(const osgRoads::core::PlacedNetwork& roads, const osgTerrainROAM::core::TileFrame& frame,
                    const RoadCutShape& shape, const glm::dvec3& scene, double withinM);

/// The same for the reach of a portal, which is the farthest.
inline HeightBand roadBand(const osgRoads::core::PlacedNetwork& roads,
                           const osgTerrainROAM::core::TileFrame& frame, const RoadCutShape& shape,
                           const glm::dvec3& scene)
{
    return roadBand(roads, frame, shape, scene, shape.reachM);
}

} // namespace scenery
