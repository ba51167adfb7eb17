// SPDX-License-Identifier: Apache-2.0
#include "Leaf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/Wedge.h>

namespace osgPMObjects::core
{

namespace
{

constexpr double kLeastExposure = 0.02; ///< of any card among others: it may be visible between them
constexpr double kFlattest = 0.5;       ///< cosine between the normals of a stretched leaf's faces: 60°
constexpr double kTurned = 0.2;         ///< cosine between a face's normals before and after

double squaredLength(const glm::dvec3& v)
{
    return glm::dot(v, v);
}

glm::dvec3 middleOf(std::span<const glm::dvec3> places)
{
    return std::accumulate(places.begin(), places.end(), glm::dvec3(0.0)) / double(places.size());
}

std::vector<glm::dvec3> placesOf(const CollapseState& state, const LeafCard& card)
{
    std::vector<glm::dvec3> places;
    for (const LeafCard::Corner& corner : card.corners)
        places.push_back(state.positions[corner.position]);
    return places;
}

glm::dvec3 doubleAreaVector(const LeafCard::Corners& c, std::span<const glm::dvec3> places)
{
    return glm::cross(places[c[1]] - places[c[0]], places[c[2]] - places[c[0]]);
}

/// The cost of moving both areas to `middle`.
double costOf(const CollapseState& state, const Leaf& gone, const Leaf& stays, const glm::dvec3& middle)
{
    return state.weight.of(gone.seenDoubleArea) * squaredLength(middle - gone.middle) +
           state.weight.of(stays.seenDoubleArea) * squaredLength(middle - stays.middle);
}

glm::dvec3 middleOfBoth(const Leaf& a, const Leaf& b)
{
    return (a.seenDoubleArea * a.middle + b.seenDoubleArea * b.middle) /
           (a.seenDoubleArea + b.seenDoubleArea);
}

/// Returns how much a leaf can be scaled about a point within a box, at most `most`.
double mostScale(const Extent& box, std::span<const glm::dvec3> places, const glm::dvec3& about, double most)
{
    for (const glm::dvec3& p : places)
        for (int axis = 0; axis < 3; ++axis)
        {
            const double off = std::abs(p[axis] - about[axis]);
            const double room =
                p[axis] > about[axis] ? box.high[axis] - about[axis] : about[axis] - box.low[axis];
            if (off * most > room) most = room / off;
        }
    return std::max(most, 1.0);
}

/// Returns the corner of a card with the same texture coordinates as a corner of another; kOwn where there is none.
std::uint8_t sameCorner(const CollapseState& state, const LeafCard& card, const LeafCard& other,
                        std::size_t corner)
{
    const glm::dvec3 off = state.positions[other.corners[corner].position];
    std::uint8_t best = LeafGrowth::kOwn;
    double least = std::numeric_limits<double>::infinity();
    const Wedge looks = wedgeOf(state.mesh, other.corners[corner].wedges.front());
    for (std::uint8_t c = 0; c < card.corners.size(); ++c)
    {
        const Wedge own = wedgeOf(state.mesh, card.corners[c].wedges.front());
        double drift = 0.0;
        for (std::size_t set = 0; set < Mesh::kTexCoordSets; ++set)
            drift = std::max(drift, double(glm::distance(own.texCoords[set], looks.texCoords[set])));
        if (state.settings.keepSeams && drift > state.settings.mostTexCoordDrift) continue;
        const double away = squaredLength(state.positions[card.corners[c].position] - off);
        if (away < least) least = away, best = c;
    }
    return best;
}

bool keepsItsSide(const LeafCard& card, std::span<const glm::dvec3> before, std::span<const glm::dvec3> after)
{
    glm::dvec3 first(0.0);
    for (const LeafCard::Corners& corners : card.faces)
    {
        const glm::dvec3 was = doubleAreaVector(corners, before), is = doubleAreaVector(corners, after);
        if (!(glm::dot(was, is) > kTurned * glm::length(was) * glm::length(is))) return false;
        // A card with two sides has faces of opposite normals.
        if (first == glm::dvec3(0.0)) first = is;
        if (!(std::abs(glm::dot(first, is)) >= kFlattest * glm::length(first) * glm::length(is)))
            return false;
    }
    return true;
}

/// Whether the wanted corners are left when the other card has collapsed, none of them wanted twice.
bool canBeTaken(std::span<const std::uint8_t> taken, const LeafClosing& closing)
{
    std::uint32_t used = 0;
    for (const std::uint8_t corner : taken)
    {
        if (corner == LeafGrowth::kOwn) continue;
        const bool isLeft = std::find(closing.left.begin(), closing.left.end(), corner) != closing.left.end();
        if (!isLeft || (used >> corner & 1u) != 0) return false;
        used |= 1u << corner;
    }
    return true;
}

} // namespace

double doubleAreaOf(const LeafCard& card, std::span<const glm::dvec3> places)
{
    double area = 0.0;
    for (const LeafCard::Corners& corners : card.faces)
        area += glm::length(doubleAreaVector(corners, places));
    return area;
}

Leaf::Leaf(const CollapseState& state, LeafCard given) : card(std::move(given))
{
    const auto places = placesOf(state, card);
    middle = middleOf(places);
    extent = extentOf(places);
    owedDoubleArea = doubleAreaOf(card, places);
    const double reach = state.parts[card.part].reach / (0.5 * extent.diagonal());
    exposure = std::max(kLeastExposure, reach * reach);
    seenDoubleArea = exposure * owedDoubleArea;
}

void Leaf::takeOver(const Leaf& gone)
{
    middle = middleOfBoth(*this, gone);
    owedDoubleArea += gone.owedDoubleArea;
    seenDoubleArea += gone.seenDoubleArea;
    extent.add(gone.extent.low);
    extent.add(gone.extent.high);
}

void LeafGrowth::weigh(const CollapseState& state, const Leaf& gone, const Leaf& stays)
{
    const double owed = gone.owedDoubleArea + stays.owedDoubleArea;
    cost = costOf(state, gone, stays, middleOf(places));
    loss = cost + state.weight.of(std::abs(owed - doubleAreaOf(stays.card, places))) * owed;
}

bool LeafGrowth::takesCorners() const
{
    return std::any_of(taken.begin(), taken.end(), [](std::uint8_t corner) { return corner != kOwn; });
}

LeafClosing closingOf(const LeafCard& card, bool isTurned)
{
    LeafClosing closing;
    std::vector<LeafCard::Corners> faces = card.faces;
    std::uint32_t gone = 0;
    while (!faces.empty())
    {
        std::array<std::array<std::uint32_t, LeafCard::kMostCorners>, LeafCard::kMostCorners> counts{};
        LeafClosing::Step best;
        for (const LeafCard::Corners& f : faces)
            for (int c = 0; c < 3; ++c)
            {
                const std::uint8_t low = std::min(f[c], f[(c + 1) % 3]),
                                   high = std::max(f[c], f[(c + 1) % 3]);
                if (++counts[low][high] > best.faces) best = {high, low, counts[low][high]};
            }
        if (isTurned && closing.steps.empty()) std::swap(best.from, best.to);
        for (LeafCard::Corners& f : faces)
            std::replace(f.begin(), f.end(), best.from, best.to);
        std::erase_if(faces, [](const LeafCard::Corners& f) { return repeatsCorner({f[0], f[1], f[2]}); });
        closing.steps.push_back(best);
        gone |= 1u << best.from;
    }
    for (std::uint8_t c = 0; c < card.corners.size(); ++c)
        if ((gone >> c & 1u) == 0) closing.left.push_back(c);
    return closing;
}

LeafGrowth scaledLeaf(const CollapseState& state, const Leaf& gone, const Leaf& stays)
{
    const auto before = placesOf(state, stays.card);
    const double area = doubleAreaOf(stays.card, before);
    const double wanted = std::min(gone.owedDoubleArea + stays.owedDoubleArea,
                                   (gone.seenDoubleArea + stays.seenDoubleArea) / stays.exposure);
    Leaf both = stays;
    both.takeOver(gone);
    LeafGrowth best;
    const auto look = [&](const glm::dvec3& from, const glm::dvec3& to)
    {
        LeafGrowth growth;
        for (const glm::dvec3& p : before)
            growth.places.push_back(from == to ? p : p - from + to);
        if (!state.box.contains(extentOf(growth.places))) return;
        const double scale =
            mostScale(both.extent, growth.places, to, std::sqrt(std::max(1.0, wanted / area)));
        for (glm::dvec3& p : growth.places)
            if (p != to) p = glm::clamp(to + scale * (p - to), state.box.low, state.box.high);
        growth.taken.assign(before.size(), LeafGrowth::kOwn);
        growth.weigh(state, gone, stays);
        if (growth.loss < best.loss) best = std::move(growth);
    };
    for (const glm::dvec3& corner : before)
        look(corner, corner);
    const std::size_t spares =
        closingOf(gone.card, false).left.size() + gone.spares.size() + stays.spares.size();
    if (spares >= before.size()) look(middleOf(before), both.middle);
    return best;
}

LeafGrowth stretchedLeaf(const CollapseState& state, const Leaf& gone, const Leaf& stays)
{
    const auto before = placesOf(state, stays.card);
    const std::array closings{closingOf(gone.card, false), closingOf(gone.card, true)};
    std::array<std::uint8_t, LeafCard::kMostCorners> same{};
    for (std::size_t c = 0; c < before.size(); ++c)
        same[c] = sameCorner(state, gone.card, stays.card, c);
    LeafGrowth best;
    for (std::uint32_t which = 0; which < 1u << before.size(); ++which)
    {
        LeafGrowth growth;
        growth.places = before;
        growth.taken.assign(before.size(), LeafGrowth::kOwn);
        bool isWhole = true;
        for (std::size_t c = 0; c < before.size() && isWhole; ++c)
        {
            if ((which >> c & 1u) == 0) continue;
            growth.taken[c] = same[c];
            isWhole = same[c] != LeafGrowth::kOwn;
            if (isWhole) growth.places[c] = state.positions[gone.card.corners[same[c]].position];
        }
        growth.isTurned = !canBeTaken(growth.taken, closings[0]);
        if (!isWhole || (growth.isTurned && !canBeTaken(growth.taken, closings[1])) ||
            !keepsItsSide(stays.card, before, growth.places))
            continue;
        growth.weigh(state, gone, stays);
        if (growth.loss < best.loss) best = std::move(growth);
    }
    return best;
}

} // namespace osgPMObjects::core
