// SPDX-License-Identifier: Apache-2.0
#include "OpenEdges.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "EdgesWithoutTwin.h"

namespace osgTerrainROAM::core
{

namespace
{

/// An edge from one point of the grid to another; it runs along a row, a column or a diagonal.
struct GridEdge
{
    GridPoint from, to;
};

/// The position of an edge on its line.
struct Piece
{
    int direction = 0; ///< of the line: along a row, a column, either diagonal
    int line = 0;
    int begin = 0, end = 0;
    bool isForward = false;

    explicit Piece(const GridEdge& e)
    {
        const int columns = e.to.column - e.from.column, rows = e.to.row - e.from.row;
        direction = rows == 0 ? 0 : columns == 0 ? 1 : (columns > 0) == (rows > 0) ? 2 : 3;
        const int lines[] = {e.from.row, e.from.column, e.from.column - e.from.row,
                             e.from.column + e.from.row};
        line = lines[direction];
        const int a = direction == 1 ? e.from.row : e.from.column,
                  b = direction == 1 ? e.to.row : e.to.column;
        isForward = a < b;
        std::tie(begin, end) = std::minmax(a, b);
    }
    auto key() const { return std::tuple(direction, line, begin, end, isForward); }
};

bool isAtDataBorder(const PlacedTile& tile, const GridEdge& e)
{
    const auto both = [&](auto holds) { return holds(e.from) && holds(e.to); };
    return both([](GridPoint p) { return p.column == 0; }) || both([](GridPoint p) { return p.row == 0; }) ||
           both([&](GridPoint p) { return p.column >= tile.grid().dataColumns() - 1; }) ||
           both([&](GridPoint p) { return p.row >= tile.grid().dataRows() - 1; });
}

/// Keeps the edges along which an edge of the opposite sense runs.
std::size_t countOpposed(const std::vector<GridEdge>& open)
{
    std::vector<Piece> pieces(open.begin(), open.end());
    std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.key() < b.key(); });
    std::vector<bool> isOpposed(pieces.size(), false);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (std::size_t j = i + 1; j < pieces.size() && pieces[j].direction == pieces[i].direction &&
                                    pieces[j].line == pieces[i].line && pieces[j].begin < pieces[i].end;
             ++j)
            if (pieces[j].isForward != pieces[i].isForward) isOpposed[i] = isOpposed[j] = true;
    return static_cast<std::size_t>(std::count(isOpposed.begin(), isOpposed.end(), true));
}

} // namespace

std::size_t tJunctions(const PlacedTile& tile, const DrawnMesh& mesh)
{
    std::vector<GridEdge> open;
    for (const auto& [from, to] : edgesWithoutTwin(mesh.triangles, firstAtPlace(mesh.grid)))
    {
        const GridEdge edge{mesh.grid[from], mesh.grid[to]};
        if (!isAtDataBorder(tile, edge)) open.push_back(edge);
    }
    return tile.samples().hasHoles() ? countOpposed(open) : open.size();
}

} // namespace osgTerrainROAM::core
