// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>
#include <unordered_set>

#include <glm/geometric.hpp>

#include <osgTerrainROAM/core/bisection/BisectionCheck.h>

namespace osgTerrainROAM::core
{

namespace
{

using SideKey = std::pair<std::uint32_t, std::uint32_t>;

std::unordered_set<std::uint32_t> borderVertices(const BisectionSurface& surface)
{
    std::unordered_set<std::uint32_t> border;
    const CoarseMesh& mesh = surface.mesh();
    for (std::uint32_t side = 0; side < mesh.sides(); ++side)
    {
        if (mesh.twin(side) != kNoSide) continue;
        const CornerVertices corners = surface.rootCorners(side);
        border.insert({corners[0], corners[1]});
        surface.visitWeighted(neighboursOf(mesh, {side, 1}), kOwnCorners,
                              [&](const BisectorNeighbours&, std::uint32_t vertex, const CornerWeights& at)
                              {
                                  if (middleOf(at).z == 0.0) border.insert(vertex);
                                  return true;
                              });
    }
    return border;
}

/// Finds the greatest share of the tolerance among points in one triangle that is drawn.
class ShareMeter
{
public:
    ShareMeter(const BisectionMesh& mesh, const BisectionView& view)
        : _mesh(mesh), _view(view), _carriers(mesh.patches())
    {
    }

    void meetLeaf(const DrawnBisector& leaf)
    {
        const BisectionSurface& surface = _mesh.surface();
        const auto visit = [&](const BisectorNeighbours& at, std::uint32_t vertex, const CornerWeights& own)
        {
            const std::uint32_t patch = _carriers.at(at.self);
            if (patch == kNoSide)
                meet(leaf, middleOf(own), surface.point(vertex));
            else
                for (const PatchPoint& p : _mesh.patches()[patch].points)
                    meet(leaf, p.weights.x * own[0] + p.weights.y * own[1] + p.weights.z * own[2], p.point);
            return patch == kNoSide;
        };
        surface.visitWeighted(neighboursOf(surface.mesh(), leaf.leaf), kOwnCorners, visit);
    }

    double worst() const { return _worst; }

private:
    void meet(const DrawnBisector& leaf, const glm::dvec3& weights, const glm::dvec3& point)
    {
        const glm::dvec3 flat = weights.x * _mesh.point(leaf.vertices[0]) +
                                weights.y * _mesh.point(leaf.vertices[1]) +
                                weights.z * _mesh.point(leaf.vertices[2]);
        const double allowed = _view.tolerance * std::max(glm::distance(_view.eye, point), _view.nearest);
        _worst = std::max(_worst, glm::distance(point, flat) / allowed);
    }

    const BisectionMesh& _mesh;
    const BisectionView& _view;
    CarrierTable _carriers;
    double _worst = 0.0;
};

} // namespace

std::optional<std::string> checkDrawn(const BisectionSurface& surface, std::span<const DrawnBisector> drawn)
{
    std::set<SideKey> open;
    for (const DrawnBisector& t : drawn)
        for (std::size_t c = 0; c < 3; ++c)
        {
            const SideKey own{t.vertices[c], t.vertices[(c + 1) % 3]};
            if (own.first == own.second) return "a triangle has a corner twice";
            if (!open.insert(own).second)
                return "two triangles have the side from " + std::to_string(own.first) + " to " +
                       std::to_string(own.second);
        }
    const std::unordered_set<std::uint32_t> border = borderVertices(surface);
    for (const SideKey& side : open)
        if (!open.contains({side.second, side.first}) &&
            !(border.contains(side.first) && border.contains(side.second)))
            return "the side from " + std::to_string(side.first) + " to " + std::to_string(side.second) +
                   " has no neighbour";
    return std::nullopt;
}

double worstShare(const BisectionMesh& mesh, const BisectionView& view)
{
    ShareMeter meter(mesh, view);
    for (const DrawnBisector& triangle : mesh.drawn())
        if (triangle.patch == kNoSide) meter.meetLeaf(triangle);
    return meter.worst();
}

} // namespace osgTerrainROAM::core
