// SPDX-License-Identifier: Apache-2.0
#include "WedgePlan.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/TriangleTree.h>

#include "Shares.h"

namespace osgPMObjects::core
{

namespace
{

/// Returns how different two wedges look, in no particular unit.
float unlikeness(const Wedge& a, const Wedge& b)
{
    constexpr float kTexture = 16.0f; // a sixteenth of a texture's width counts as a normal turned by 60°
    float gap = glm::distance(a.normal, b.normal) + glm::distance(a.colour, b.colour);
    for (std::size_t set = 0; set < Mesh::kTexCoordSets; ++set)
        gap += kTexture * glm::distance(a.texCoords[set], b.texCoords[set]);
    return gap;
}

std::uint32_t wedgeAt(const StarMesh& stars, std::uint32_t face, std::uint32_t position)
{
    const Triangle& p = stars.positions(face);
    return stars.wedges(face)[p[0] == position ? 0 : p[1] == position ? 1 : 2];
}

/// Returns the wedge at `to` of a vanishing face that has `wedge` in the middle; `wedge` itself where there
/// is none.
std::uint32_t matchOf(const StarMesh& stars, const Star& star, std::uint32_t to, std::uint32_t wedge)
{
    for (const Star::Side& side : star.sidesTo(to))
    {
        const Star::Spoked& spoked = star.faces[side.spoked];
        if (spoked.wedge == wedge) return wedgeAt(stars, spoked.face, to);
    }
    return wedge;
}

/// Returns the most similar wedge of a position, first among those of the same material.
std::uint32_t mostAlike(const WedgedMesh& all, std::uint32_t position, const Star::Spoked& spoked)
{
    const Wedge looks = wedgeOf(all.mesh, spoked.wedge);
    std::uint32_t best = spoked.wedge;
    std::pair least{true, std::numeric_limits<float>::max()};
    all.stars.visitStar(position,
                        [&](std::uint32_t face, int corner)
                        {
                            const std::uint32_t wedge = all.stars.wedges(face)[corner];
                            const bool isOther =
                                all.mesh.faces[face].material != all.mesh.faces[spoked.face].material;
                            const std::pair gap{isOther, unlikeness(wedgeOf(all.mesh, wedge), looks)};
                            if (gap < least) least = gap, best = wedge;
                        });
    return best;
}

bool isPlanned(const std::vector<WedgeChange>& changes, std::uint32_t wedge)
{
    return std::any_of(changes.begin(), changes.end(),
                       [wedge](const WedgeChange& change) { return change.wedge == wedge; });
}

/// Finds the face of a group nearest to a point, and interpolates there.
class Sampler
{
public:
    Sampler(const WedgedMesh& all, const glm::dvec3& place) : _all(all), _place(place) {}

    void look(const Star& star, std::uint32_t wedge)
    {
        for (const Star::Spoked& spoked : star.faces)
        {
            if (spoked.wedge != wedge) continue;
            const Triangle& p = _all.stars.positions(spoked.face);
            const std::array corners{_all.positions[p[0]], _all.positions[p[1]], _all.positions[p[2]]};
            const glm::dvec3 at = nearestPoint(_place, corners[0], corners[1], corners[2]);
            const double squared = glm::dot(at - _place, at - _place);
            if (!(squared < _least)) continue;
            _least = squared;
            const Triangle& w = _all.stars.wedges(spoked.face);
            _found = mixtureOf({wedgeOf(_all.mesh, w[0]), wedgeOf(_all.mesh, w[1]), wedgeOf(_all.mesh, w[2])},
                               sharesOf(at, corners));
        }
    }

    /// Returns the interpolated wedge at a position, with a normal of the length of another one.
    Wedge found(std::uint32_t position, const glm::vec3& normal) const
    {
        Wedge wedge = _found;
        wedge.position = position;
        const float length = glm::length(wedge.normal);
        wedge.normal = length > 0.0f ? wedge.normal * (glm::length(normal) / length) : normal;
        return wedge;
    }

private:
    const WedgedMesh& _all;
    glm::dvec3 _place;
    double _least = std::numeric_limits<double>::infinity();
    Wedge _found;
};

/// Returns for each wedge around `star.middle` its match at the other position, or itself, with its group's
/// attributes at the point.
std::vector<WedgeChange> resampled(const WedgedMesh& all, const Star& star, const Star& other,
                                   const glm::dvec3& place)
{
    std::vector<WedgeChange> changes;
    for (const Star::Spoked& spoked : star.faces)
    {
        if (isPlanned(changes, spoked.wedge)) continue;
        const std::uint32_t match = matchOf(all.stars, star, other.middle, spoked.wedge);
        Sampler sampler(all, place);
        sampler.look(star, spoked.wedge);
        if (match != spoked.wedge) sampler.look(other, match);
        changes.push_back(
            {spoked.wedge, match, sampler.found(other.middle, wedgeOf(all.mesh, spoked.wedge).normal)});
    }
    return changes;
}

} // namespace

void WedgePlan::match(const WedgedMesh& all, const Star& star, std::uint32_t to)
{
    _from.clear();
    _to.clear();
    for (const Star::Spoked& spoked : star.faces)
    {
        if (isPlanned(_from, spoked.wedge)) continue;
        std::uint32_t becomes = matchOf(all.stars, star, to, spoked.wedge);
        if (becomes == spoked.wedge) becomes = mostAlike(all, to, spoked);
        _from.push_back({spoked.wedge, becomes, wedgeOf(all.mesh, becomes)});
    }
}

void WedgePlan::resample(const WedgedMesh& all, const Star& star, const Star& other, const glm::dvec3& place)
{
    _from = resampled(all, star, other, place);
    _to = resampled(all, other, star, place);
    for (WedgeChange& change : _to)
    {
        change.becomes = change.wedge;
        change.attributes.position = other.middle;
    }
    for (const WedgeChange& change : _from) // a wedge of several groups has to look like all of them
    {
        const auto same = std::find_if(_to.begin(), _to.end(),
                                       [&](const WedgeChange& c) { return c.wedge == change.becomes; });
        if (same == _to.end() && change.becomes != change.wedge)
            _to.push_back({change.becomes, change.becomes, change.attributes});
    }
}

} // namespace osgPMObjects::core
