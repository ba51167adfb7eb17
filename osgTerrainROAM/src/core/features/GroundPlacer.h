// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM::core
{

/// Puts the vertices of maps on the ground of a tile. In the local frame the horizontal position of a
/// latitude and longitude depends on the ground's height: 60 km from the origin, a ground of 2000 m lies 19 m
/// farther out than the ellipsoid.
/// Frame: local east and north, metres. Threads: const, any.
class GroundPlacer
{
public:
    explicit GroundPlacer(const PlacedTile& tile);

    /// `x`, `y`: degrees east and north; planar tiles: metres.
    glm::dvec2 placed(double x, double y) const;

    /// A line through vertices, with points added so that no piece is longer than 250 m (planar: none are
    /// added).
    std::vector<glm::dvec2> placedLine(const std::vector<glm::dvec2>& vertices, bool closed) const;

    /// Tells whether the bounding box of some positions meets that of the tile's data.
    bool meetsTile(const std::vector<glm::dvec2>& places) const;

private:
    void addBounds();

    const PlacedTile& _tile;
    bool _curved;
    glm::dvec2 _low{1e300}, _high{-1e300};
};

} // namespace osgTerrainROAM::core
