// SPDX-License-Identifier: Apache-2.0
#include "EdgeCells.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <osgPMObjects/core/Parallel.h>

namespace osgPMObjects::core
{

namespace
{

/// The least number of faces for a thread.
constexpr std::size_t kLeastFacesAThread = 16384;
constexpr double kMostEdgeCells = 1 << 22;
constexpr double kMostOfASide = 1024;

} // namespace

EdgeCells::EdgeCells(const Extent& extent, double reach) : _reach(reach), _low(extent.low - reach)
{
    const glm::dvec3 size = extent.high - extent.low + 2.0 * reach;
    _cell = std::max(glm::length(size) / kMostOfASide, 1e-300);
    const auto counts = [&] { return glm::floor(size / _cell) + 1.0; };
    for (glm::dvec3 n = counts(); n.x * n.y * n.z > kMostEdgeCells; n = counts())
        _cell *= 1.25;
    _count = glm::ivec3(counts());
    const auto cells = static_cast<std::size_t>(_count.x) * static_cast<std::size_t>(_count.y) *
                       static_cast<std::size_t>(_count.z);
    _marks.assign(cells / 64 + 1, 0);
}

glm::ivec3 EdgeCells::cellOf(const glm::dvec3& p) const
{
    const glm::dvec3 cell = glm::clamp((p - _low) / _cell, 0.0, kMostOfASide);
    return glm::min(glm::ivec3(cell), _count - 1);
}

template<class Visit>
bool EdgeCells::visitRows(const Extent& box, const Visit& visit) const
{
    const glm::ivec3 from = cellOf(box.low), to = cellOf(box.high);
    for (int x = from.x; x <= to.x; ++x)
        for (int y = from.y; y <= to.y; ++y)
        {
            const std::size_t row = (static_cast<std::size_t>(x) * static_cast<std::size_t>(_count.y) +
                                     static_cast<std::size_t>(y)) *
                                    static_cast<std::size_t>(_count.z);
            if (visit(row + static_cast<std::size_t>(from.z), row + static_cast<std::size_t>(to.z)))
                return true;
        }
    return false;
}

/// Looks at 64 cells at a time: the box of a large face may have all cells of the grid.
bool EdgeCells::isAnyMarked(std::size_t first, std::size_t last) const
{
    constexpr std::uint64_t kAll = ~std::uint64_t(0);
    for (std::size_t word = first / 64; word <= last / 64; ++word)
    {
        const std::uint64_t from = word == first / 64 ? kAll << first % 64 : kAll;
        const std::uint64_t to = word == last / 64 ? kAll >> (63 - last % 64) : kAll;
        if ((_marks[word] & from & to) != 0) return true;
    }
    return false;
}

/// Marks cells in short boxes along the edge: a long diagonal edge crosses few of the cells in its own box.
void EdgeCells::markEdge(const glm::dvec3& a, const glm::dvec3& b)
{
    const int pieces = static_cast<int>(glm::length(b - a) / _cell) + 1;
    for (int i = 0; i < pieces; ++i)
    {
        const glm::dvec3 p = glm::mix(a, b, static_cast<double>(i) / pieces);
        const glm::dvec3 q = glm::mix(a, b, static_cast<double>(i + 1) / pieces);
        visitRows({glm::min(p, q) - _reach, glm::max(p, q) + _reach},
                  [this](std::size_t first, std::size_t last)
                  {
                      for (std::size_t cell = first; cell <= last; ++cell)
                          _marks[cell / 64] |= std::uint64_t(1) << cell % 64;
                      return false;
                  });
    }
}

void EdgeCells::markFace(const Mesh& mesh, const Face& face)
{
    for (int i = 0; i < 3; ++i)
        markEdge(mesh.at(face, i), mesh.at(face, (i + 1) % 3));
}

void EdgeCells::markAround(const Mesh& mesh, std::span<const std::uint32_t> positions)
{
    std::vector<std::uint8_t> isOne(mesh.positions.size(), 0);
    for (const std::uint32_t p : positions)
        isOne[p] = 1;
    for (const Face& face : mesh.faces)
        if (isOne[mesh.positionOf(face, 0)] || isOne[mesh.positionOf(face, 1)] ||
            isOne[mesh.positionOf(face, 2)])
            markFace(mesh, face);
}

void EdgeCells::markFaces(const Mesh& mesh, std::span<const std::uint8_t> isOne)
{
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
        if (isOne[f]) markFace(mesh, mesh.faces[f]);
}

std::vector<std::uint8_t> EdgeCells::facesTouching(const Mesh& mesh) const
{
    std::vector<std::uint8_t> isTouching(mesh.faces.size(), 0);
    const auto isMarked = [this](std::size_t first, std::size_t last) { return isAnyMarked(first, last); };
    parallelShares(mesh.faces.size(), kLeastFacesAThread,
                   [&](std::size_t first, std::size_t last, std::size_t)
                   {
                       for (std::size_t f = first; f < last; ++f)
                       {
                           Extent box;
                           for (int i = 0; i < 3; ++i)
                               box.add(mesh.at(mesh.faces[f], i));
                           isTouching[f] = visitRows(box, isMarked);
                       }
                   });
    return isTouching;
}

bool EdgeCells::isWithin(const EdgeCells& other) const
{
    return std::equal(_marks.begin(), _marks.end(), other._marks.begin(), other._marks.end(),
                      [](std::uint64_t mine, std::uint64_t others) { return (mine & ~others) == 0; });
}

} // namespace osgPMObjects::core
