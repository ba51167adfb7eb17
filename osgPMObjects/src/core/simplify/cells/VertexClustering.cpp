// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/simplify/VertexClustering.h>

namespace osgPMObjects::core
{

namespace
{

using Cell = std::array<std::int64_t, 3>;

/// The most cells of a grid along an axis.
constexpr double kMostCells = 1e9;

Cell gridCell(const glm::dvec3& point, const glm::dvec3& low, double size)
{
    Cell cell;
    for (int axis = 0; axis < 3; ++axis)
        cell[axis] = static_cast<std::int64_t>(std::floor((point[axis] - low[axis]) / size));
    return cell;
}

/// Computes ClusteredMesh::representative and cells.
void choose(const Mesh& mesh, ClusteredMesh& clustered)
{
    const std::vector<double> grades = clusterGrades(mesh);
    const glm::dvec3 low = extentOfFaces(mesh).low;
    const auto count = static_cast<std::uint32_t>(mesh.positions.size());
    std::vector<bool> isUsed(count, false);
    for (const Face& face : mesh.faces)
        for (int corner = 0; corner < 3; ++corner)
            isUsed[mesh.positionOf(face, corner)] = true;
    std::map<Cell, std::uint32_t> chosen;
    for (std::uint32_t p = 0; p < count; ++p)
    {
        if (!isUsed[p]) continue;
        std::uint32_t& best =
            chosen.try_emplace(gridCell(mesh.positions[p], low, clustered.cellSize), p).first->second;
        if (grades[p] > grades[best]) best = p;
    }
    clustered.cells = chosen.size();
    clustered.representative.resize(count);
    for (std::uint32_t p = 0; p < count; ++p)
        clustered.representative[p] =
            isUsed[p] ? chosen[gridCell(mesh.positions[p], low, clustered.cellSize)] : p;
}

/// A face of the merged mesh for comparison: rotated so that the lowest corner comes first, with material and
/// part.
using FaceKey = std::tuple<Triangle, std::uint32_t, std::uint32_t>;

FaceKey keyOf(const Mesh& mesh, const Face& face)
{
    Triangle t = {mesh.positionOf(face, 0), mesh.positionOf(face, 1), mesh.positionOf(face, 2)};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return {t, face.material, face.part};
}

/// Keeps edges and points of degenerate faces, unless faces or edges contain them.
void keepRemains(ClusteredMesh& clustered, const std::vector<Triangle>& degenerate)
{
    std::set<std::array<std::uint32_t, 2>> ofFaces, edges;
    std::set<std::uint32_t> corners, points;
    const auto edge = [](std::uint32_t a, std::uint32_t b) {
        return std::array<std::uint32_t, 2>{std::min(a, b), std::max(a, b)};
    };
    for (const Triangle& t : positionTriangles(clustered.mesh))
        for (int c = 0; c < 3; ++c)
        {
            ofFaces.insert(edge(t[c], t[(c + 1) % 3]));
            corners.insert(t[c]);
        }
    for (const Triangle& t : degenerate)
    {
        const auto [low, high] = std::minmax_element(t.begin(), t.end());
        if (*low != *high && ofFaces.count({*low, *high}) == 0) edges.insert({*low, *high});
    }
    for (const auto& [a, b] : edges)
        corners.insert({a, b});
    for (const Triangle& t : degenerate)
        if (t[0] == t[1] && t[1] == t[2] && corners.count(t[0]) == 0) points.insert(t[0]);
    clustered.edges.assign(edges.begin(), edges.end());
    clustered.points.assign(points.begin(), points.end());
}

/// Moves corners to the representatives and drops degenerate and duplicate faces.
void synthesise(const Mesh& mesh, ClusteredMesh& clustered)
{
    clustered.mesh = mesh;
    for (std::uint32_t& position : clustered.mesh.wedgePositions)
        position = clustered.representative[position];
    std::set<FaceKey> known;
    std::vector<Triangle> degenerate;
    std::vector<Face> kept;
    for (const Face& face : mesh.faces)
    {
        const FaceKey key = keyOf(clustered.mesh, face);
        if (repeatsCorner(std::get<0>(key)))
            degenerate.push_back(std::get<0>(key));
        else if (known.insert(key).second)
            kept.push_back(face);
        else
            ++clustered.duplicateFaces;
    }
    clustered.mesh.faces = std::move(kept);
    clustered.degenerateFaces = degenerate.size();
    keepRemains(clustered, degenerate);
}

} // namespace

foundation::Result<ClusteredMesh> clusterVertices(const Mesh& mesh, double cellSize)
{
    if (!(cellSize > 0.0) || !std::isfinite(cellSize) || diagonalOf(mesh) > kMostCells * cellSize)
        return foundation::Error{"cell size", std::to_string(cellSize) + " is out of range for this mesh",
                                 "give a length above a billionth of its diagonal"};
    ClusteredMesh clustered;
    clustered.cellSize = cellSize;
    choose(mesh, clustered);
    synthesise(mesh, clustered);
    return clustered;
}

std::string clusteringDefectOf(const ClusteredMesh& clustered, const Mesh& mesh)
{
    const auto& representative = clustered.representative;
    if (representative.size() != mesh.positions.size()) return "the number of positions differs";
    if (clustered.mesh.positions != mesh.positions) return "positions have moved";
    const glm::dvec3 low = extentOfFaces(mesh).low;
    const double most = std::sqrt(3.0) * clustered.cellSize;
    for (std::size_t p = 0; p < representative.size(); ++p)
    {
        const std::uint32_t r = representative[p];
        if (r >= mesh.positions.size() || representative[r] != r)
            return "a representative does not represent itself";
        if (r == p) continue;
        if (glm::length(mesh.positions[p] - mesh.positions[r]) > most * (1.0 + 1e-12))
            return "a position is farther than a cell's diagonal from its representative";
        if (gridCell(mesh.positions[p], low, clustered.cellSize) !=
            gridCell(mesh.positions[r], low, clustered.cellSize))
            return "a representative lies in another cell";
    }
    ClusteredMesh expected;
    expected.representative = representative;
    synthesise(mesh, expected);
    const bool isSame = expected.mesh.faces == clustered.mesh.faces &&
                        expected.mesh.wedgePositions == clustered.mesh.wedgePositions &&
                        expected.edges == clustered.edges && expected.points == clustered.points &&
                        expected.degenerateFaces == clustered.degenerateFaces &&
                        expected.duplicateFaces == clustered.duplicateFaces;
    return isSame ? "" : "faces, edges or points do not match the merged positions";
}

} // namespace osgPMObjects::core
