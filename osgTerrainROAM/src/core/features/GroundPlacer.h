// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM::core
{

/// Puts the vertices of maps on the ground of a tile. A place of given latitude and longitude lies, seen from above the
/// tile's origin, where its ground is: 60 km away a ground of 2000 m is 19 m farther out than the ellipsoid.
/// Frame: local east and north, metres. Threads: const, any.
class GroundPlacer
{
public:
    explicit GroundPlacer(const PlacedTile& tile);

    /// `x`, `y`: degrees east and north; planar tiles: metres.
    glm::dvec2 placed(double x, double y) const;

    /// A line through vertices, with points added so that no piece is longer than 250 m (planar: as it is).
    std::vector<glm::dvec2> placedLine(const std::vector<glm::dvec2>& vertices, bool closed) const;

    /// Whether the box around some places meets the box around the tile's data.
    bool meetsTile(const std::vector<glm::dvec2>& places) const;

private:
    void addBounds();

    const PlacedTile& _tile;
    bool _curved;
    glm::dvec2 _low{1e300}, _high{-1e300};
};

} // namespace osgTerrainROAM::core
