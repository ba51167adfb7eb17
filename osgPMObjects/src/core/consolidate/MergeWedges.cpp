// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <tuple>
#include <vector>

#include <glm/vector_relational.hpp>

#include <osgPMObjects/core/consolidate/MergeWedges.h>
#include <osgPMObjects/core/mesh/Wedge.h>

namespace osgPMObjects::core
{

namespace
{

template<class Vector>
bool isNear(const Vector& a, const Vector& b, float tolerance)
{
    return glm::all(glm::lessThanEqual(glm::abs(a - b), Vector(tolerance)));
}

bool isSame(const Wedge& a, const Wedge& b, const WedgeTolerance& tolerance)
{
    return isNear(a.normal, b.normal, tolerance.normal) &&
           isNear(a.texCoords[0], b.texCoords[0], tolerance.texCoord) &&
           isNear(a.texCoords[1], b.texCoords[1], tolerance.texCoord) &&
           isNear(a.colour, b.colour, tolerance.colour);
}

/// Returns a wedge with only the attributes that its material has.
Wedge bare(Wedge wedge, const Material& material)
{
    if (!material.has(Material::normal)) wedge.normal = {};
    if (!material.has(Material::texCoord0)) wedge.texCoords[0] = {};
    if (!material.has(Material::texCoord1)) wedge.texCoords[1] = {};
    if (!material.has(Material::colour)) wedge.colour = {};
    return wedge;
}

/// A corner of a face, with the keys that decide whether its wedge can be merged with another.
struct Corner
{
    std::uint32_t material, wedge, number; ///< number: 3·face + corner
    auto operator<=>(const Corner&) const = default;
};

/// All corners by position, in order of material, wedge and number.
struct CornersByPosition
{
    std::vector<Corner> corners;
    std::vector<std::uint32_t> first; ///< by position; one more at the end

    explicit CornersByPosition(const Mesh& mesh)
        : corners(3 * mesh.faces.size()), first(mesh.positions.size() + 1, 0)
    {
        for (const Face& face : mesh.faces)
            for (int i = 0; i < 3; ++i)
                ++first[mesh.positionOf(face, i) + 1];
        for (std::size_t p = 1; p < first.size(); ++p)
            first[p] += first[p - 1];
        std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
        for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
            for (std::uint32_t i = 0; i < 3; ++i)
            {
                const Face& face = mesh.faces[f];
                corners[next[mesh.positionOf(face, static_cast<int>(i))]++] = {face.material, face.wedges[i],
                                                                               3 * f + i};
            }
        for (std::size_t p = 0; p + 1 < first.size(); ++p)
            std::sort(corners.begin() + first[p], corners.begin() + first[p + 1]);
    }
};

std::size_t dropUnseen(Mesh& mesh)
{
    std::size_t dropped = 0;
    for (Material& material : mesh.materials)
    {
        dropped += static_cast<std::size_t>(std::popcount(material.attributes & material.unseen));
        material.attributes &= ~material.unseen;
    }
    return dropped;
}

std::size_t countUsed(const Mesh& mesh)
{
    std::vector<bool> isUsed(mesh.wedgeCount(), false);
    for (const Face& face : mesh.faces)
        for (const std::uint32_t wedge : face.wedges)
            isUsed[wedge] = true;
    return static_cast<std::size_t>(std::count(isUsed.begin(), isUsed.end(), true));
}

} // namespace

MergedWedges mergeWedges(Mesh& mesh, const WedgeTolerance& tolerance)
{
    MergedWedges report;
    if (tolerance.dropUnseen) report.unseenAttributes = dropUnseen(mesh);
    const std::size_t before = countUsed(mesh);
    const CornersByPosition sorted(mesh);
    Mesh merged; // of wedges only
    std::vector<Wedge> candidates;
    for (std::size_t p = 0; p < mesh.positions.size(); ++p)
    {
        std::uint32_t material = ~0u;
        std::size_t firstOfMaterial = 0;
        for (std::uint32_t i = sorted.first[p]; i < sorted.first[p + 1]; ++i)
        {
            const Corner& corner = sorted.corners[i];
            if (corner.material != material)
            {
                material = corner.material;
                candidates.clear();
                firstOfMaterial = merged.wedgeCount();
            }
            const Wedge wedge = bare(wedgeOf(mesh, corner.wedge), mesh.materials[material]);
            const auto same = std::find_if(candidates.begin(), candidates.end(),
                                           [&](const Wedge& w) { return isSame(w, wedge, tolerance); });
            const auto number = static_cast<std::uint32_t>(firstOfMaterial + (same - candidates.begin()));
            if (same == candidates.end())
            {
                appendWedge(merged, wedge);
                candidates.push_back(wedge);
            }
            mesh.faces[corner.number / 3].wedges[corner.number % 3] = number;
        }
    }
    mesh.wedgePositions = std::move(merged.wedgePositions);
    mesh.normals = std::move(merged.normals);
    mesh.texCoords = std::move(merged.texCoords);
    mesh.colours = std::move(merged.colours);
    report.merged = before > mesh.wedgeCount() ? before - mesh.wedgeCount() : 0;
    return report;
}

} // namespace osgPMObjects::core
