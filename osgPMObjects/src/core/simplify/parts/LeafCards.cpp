// SPDX-License-Identifier: Apache-2.0
#include "LeafCards.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>

namespace osgPMObjects::core
{

namespace
{

constexpr std::uint32_t kMostFaces = 8;
constexpr std::size_t kFewestCards = 64;
constexpr double kLargest =
    0.2;                      ///< size of a card as a share of the diagonal: leaves of houseplants are large
constexpr double kBent = 0.1; ///< distance from its plane as a share of its own diagonal
constexpr double kLeastShareOfCards = 0.9;
constexpr double kMostUneven =
    32.0; ///< ratio of the areas of two cards, without the largest and smallest tenth
constexpr std::size_t kMostCuts = 16;       ///< distinct leaves in a texture
constexpr std::size_t kLeastDirections = 6; ///< at most a sixth of the cards has the same direction
constexpr float kCutSteps = 1024.0f;    ///< of a texture's width: coordinates nearer than a step are equal
constexpr double kDirectionSteps = 4.0; ///< of a unit normal's coordinates

/// The faces of a connected part, while it may be a card.
struct PartFaces
{
    std::vector<std::uint32_t> faces;
    std::uint32_t material = 0;
    bool isOneMaterial = true;
};

using Cut = std::vector<std::array<int, 2>>;
using Direction = std::array<int, 3>;

/// Returns the small parts with their faces.
std::vector<PartFaces> smallParts(const Mesh& mesh, std::span<const ConnectedPart> parts,
                                  std::span<const std::uint32_t> partOf)
{
    std::vector<PartFaces> found(parts.size());
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    {
        const Face& face = mesh.faces[f];
        const Triangle t{mesh.positionOf(face, 0), mesh.positionOf(face, 1), mesh.positionOf(face, 2)};
        if (repeatsCorner(t) || parts[partOf[t[0]]].faces > kMostFaces) continue;
        PartFaces& part = found[partOf[t[0]]];
        part.isOneMaterial &= part.faces.empty() || part.material == face.material;
        part.material = face.material;
        part.faces.push_back(f);
    }
    return found;
}

/// Returns the normal of a card's largest face; 0 where the part is not a card.
glm::dvec3 normalOfCard(const Mesh& mesh, std::span<const glm::dvec3> positions, const ConnectedPart& part,
                        const PartFaces& own)
{
    const glm::dvec3 none(0.0);
    if (own.faces.empty() || !own.isOneMaterial || part.positions.size() > LeafCard::kMostCorners)
        return none;
    Extent extent;
    for (const std::uint32_t p : part.positions)
        extent.add(positions[p]);
    glm::dvec3 normal(0.0);
    for (const std::uint32_t f : own.faces)
    {
        const glm::dvec3& a = positions[mesh.positionOf(mesh.faces[f], 0)];
        const glm::dvec3 n = glm::cross(positions[mesh.positionOf(mesh.faces[f], 1)] - a,
                                        positions[mesh.positionOf(mesh.faces[f], 2)] - a);
        if (glm::dot(n, n) > glm::dot(normal, normal)) normal = n;
    }
    if (!(glm::dot(normal, normal) > 0.0) || extent.diagonal() > kLargest) return none;
    normal = glm::normalize(normal);
    double low = 0.0, high = 0.0;
    for (const std::uint32_t p : part.positions)
    {
        const double off = glm::dot(normal, positions[p] - positions[part.positions[0]]);
        low = std::min(low, off);
        high = std::max(high, off);
    }
    return high - low > kBent * extent.diagonal() ? none : normal;
}

/// Returns the region of the texture that a card shows, in steps.
Cut cutOf(const Mesh& mesh, const PartFaces& part)
{
    std::set<std::array<int, 2>> cut;
    if (!mesh.texCoords[0].empty())
        for (const std::uint32_t f : part.faces)
            for (const std::uint32_t wedge : mesh.faces[f].wedges)
            {
                const glm::vec2 steps = glm::round(mesh.texCoords[0][wedge] * kCutSteps);
                cut.insert({static_cast<int>(steps.x), static_cast<int>(steps.y)});
            }
    return {cut.begin(), cut.end()};
}

/// Returns a direction in steps, the same for a vector and its negative.
Direction directionOf(const glm::dvec3& normal)
{
    const glm::dvec3 steps = glm::round(normal * kDirectionSteps);
    Direction direction{static_cast<int>(steps.x), static_cast<int>(steps.y), static_cast<int>(steps.z)};
    if (direction < Direction{0, 0, 0})
        for (int& d : direction)
            d = -d;
    return direction;
}

LeafCard cardOf(const Mesh& mesh, std::uint32_t number, const ConnectedPart& part, const PartFaces& own)
{
    LeafCard card{number, {}, {}};
    for (const std::uint32_t p : part.positions)
        card.corners.push_back({p, {}});
    for (const std::uint32_t f : own.faces)
    {
        LeafCard::Corners corners{};
        for (int c = 0; c < 3; ++c)
        {
            const std::uint32_t wedge = mesh.faces[f].wedges[c];
            const auto at =
                std::lower_bound(part.positions.begin(), part.positions.end(), mesh.wedgePositions[wedge]);
            corners[c] = static_cast<std::uint8_t>(at - part.positions.begin());
            std::vector<std::uint32_t>& wedges = card.corners[corners[c]].wedges;
            if (std::find(wedges.begin(), wedges.end(), wedge) == wedges.end()) wedges.push_back(wedge);
        }
        card.faces.push_back(corners);
    }
    return card;
}

/// The counts that decide whether the cards of a material are foliage.
struct Tally
{
    std::vector<std::uint32_t> parts;
    std::vector<double> areas;
    std::set<Cut> cuts;
    std::map<Direction, std::size_t> directions;
    double area = 0.0;

    bool isFoliage(double areaOfMaterial)
    {
        if (parts.size() < kFewestCards || area < kLeastShareOfCards * areaOfMaterial ||
            cuts.size() > kMostCuts)
            return false;
        std::sort(areas.begin(), areas.end());
        const std::size_t tenth = areas.size() / 10;
        if (areas[areas.size() - 1 - tenth] > kMostUneven * areas[tenth]) return false;
        return std::all_of(directions.begin(), directions.end(),
                           [&](const auto& d) { return kLeastDirections * d.second <= parts.size(); });
    }
};

std::vector<double> areasOfMaterials(const Mesh& mesh, std::span<const glm::dvec3> positions)
{
    std::vector<double> areas(mesh.materials.size(), 0.0);
    for (const Face& face : mesh.faces)
    {
        const glm::dvec3& a = positions[mesh.positionOf(face, 0)];
        areas[face.material] += glm::length(
            glm::cross(positions[mesh.positionOf(face, 1)] - a, positions[mesh.positionOf(face, 2)] - a));
    }
    return areas;
}

} // namespace

std::vector<std::vector<LeafCard>> leafCards(const Mesh& mesh, std::span<const glm::dvec3> positions,
                                             std::span<const ConnectedPart> parts,
                                             std::span<const std::uint32_t> partOf)
{
    if (parts.size() < kFewestCards) return {};
    const std::vector<PartFaces> faces = smallParts(mesh, parts, partOf);
    std::map<std::uint32_t, Tally> tallies;
    for (std::uint32_t i = 0; i < parts.size(); ++i)
    {
        const glm::dvec3 normal = normalOfCard(mesh, positions, parts[i], faces[i]);
        if (normal == glm::dvec3(0.0)) continue;
        Tally& tally = tallies[faces[i].material];
        tally.parts.push_back(i);
        tally.areas.push_back(parts[i].doubleArea);
        tally.area += parts[i].doubleArea;
        ++tally.directions[directionOf(normal)];
        if (tally.cuts.size() <= kMostCuts) tally.cuts.insert(cutOf(mesh, faces[i]));
    }
    const std::vector<double> areas = areasOfMaterials(mesh, positions);
    std::vector<std::vector<LeafCard>> foliage;
    for (auto& [material, tally] : tallies)
    {
        if (!tally.isFoliage(areas[material])) continue;
        std::vector<LeafCard>& cards = foliage.emplace_back();
        for (const std::uint32_t part : tally.parts)
            cards.push_back(cardOf(mesh, part, parts[part], faces[part]));
    }
    return foliage;
}

} // namespace osgPMObjects::core
