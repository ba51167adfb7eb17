// SPDX-License-Identifier: Apache-2.0
#include "GroundPlacer.h"

#include <algorithm>
#include <cmath>

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kMetresPerDegree = 111320.0; ///< of latitude, and of longitude at the equator
constexpr double kPieceM = 250.0;
constexpr int kMostPieces = 4000; ///< of one segment: 1000 km

double metresApart(const glm::dvec2& a, const glm::dvec2& b)
{
    const double east = (b.x - a.x) * std::cos(glm::radians(0.5 * (a.y + b.y)));
    return kMetresPerDegree * std::hypot(east, b.y - a.y);
}

} // namespace

GroundPlacer::GroundPlacer(const PlacedTile& tile)
    : _tile(tile), _curved(tile.frame().placement() == Placement::curved)
{
    addBounds();
}

void GroundPlacer::addBounds()
{
    // 65 by 65 positions: the sides of a curved tile bulge by less than the margin of one sample.
    const double margin = std::max(_tile.field().spacingEastM, _tile.field().spacingNorthM);
    for (int j = 0; j <= 64; ++j)
        for (int i = 0; i <= 64; ++i)
        {
            const int column = static_cast<int>((_tile.grid().dataColumns() - 1LL) * i / 64);
            const int row = static_cast<int>((_tile.grid().dataRows() - 1LL) * j / 64);
            const glm::dvec2 place(_tile.position(column, row));
            _low = glm::min(_low, place - margin);
            _high = glm::max(_high, place + margin);
        }
}

glm::dvec2 GroundPlacer::placed(double x, double y) const
{
    if (!_curved) return {x, y};
    const glm::dvec3 onEllipsoid = _tile.frame().localFromGeodetic({y, x, 0.0});
    const glm::dvec2 grid = _tile.frame().gridAt(onEllipsoid);
    const glm::dvec2 last(_tile.grid().dataColumns() - 1, _tile.grid().dataRows() - 1);
    // There is no ground beyond the data.
    if (!(grid.x >= 0.0 && grid.y >= 0.0 && grid.x <= last.x && grid.y <= last.y))
        return glm::dvec2(onEllipsoid);
    const int column = static_cast<int>(grid.x), row = static_cast<int>(grid.y);
    const glm::dvec2 f = grid - glm::floor(grid);
    const double south = std::lerp(static_cast<double>(_tile.samples().heightM(column, row)),
                                   static_cast<double>(_tile.samples().heightM(column + 1, row)), f.x);
    const double north = std::lerp(static_cast<double>(_tile.samples().heightM(column, row + 1)),
                                   static_cast<double>(_tile.samples().heightM(column + 1, row + 1)), f.x);
    return glm::dvec2(_tile.frame().positionAt(grid.x, grid.y, std::lerp(south, north, f.y)));
}

std::vector<glm::dvec2> GroundPlacer::placedLine(const std::vector<glm::dvec2>& vertices, bool closed) const
{
    std::vector<glm::dvec2> line;
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
        const glm::dvec2& a = vertices[i];
        line.push_back(placed(a.x, a.y));
        if (!_curved || (i + 1 == vertices.size() && !closed)) continue;
        const glm::dvec2& b = vertices[(i + 1) % vertices.size()];
        const int pieces =
            std::clamp(static_cast<int>(std::ceil(metresApart(a, b) / kPieceM)), 1, kMostPieces);
        for (int k = 1; k < pieces; ++k)
        {
            const glm::dvec2 between = glm::mix(a, b, static_cast<double>(k) / pieces);
            line.push_back(placed(between.x, between.y));
        }
    }
    return line;
}

bool GroundPlacer::meetsTile(const std::vector<glm::dvec2>& places) const
{
    glm::dvec2 low(1e300), high(-1e300);
    for (const glm::dvec2& place : places)
    {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    return low.x <= _high.x && low.y <= _high.y && high.x >= _low.x && high.y >= _low.y;
}

} // namespace osgTerrainROAM::core
