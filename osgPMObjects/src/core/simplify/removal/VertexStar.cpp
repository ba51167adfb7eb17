// SPDX-License-Identifier: Apache-2.0
#include "VertexStar.h"

#include <algorithm>
#include <array>

#include <foundation/NearestOnSegment.h>
#include <glm/geometric.hpp>

#include <osgPMObjects/core/simplify/RemoveVertices.h>

namespace osgPMObjects::core
{

namespace
{

/// The least length of a mean normal, as a share of the averaged areas; below, the mean plane is undefined.
constexpr double kLeastMeanNormal = 1e-6;

void collect(const LiveFaces& live, VertexStar& star)
{
    live.visit(star.position,
               [&](std::uint32_t slot, int corner)
               {
                   const Triangle& t = live.triangle(slot);
                   const Face& face = live.face(slot);
                   const int next = (corner + 1) % 3, last = (corner + 2) % 3;
                   const glm::dvec3& p = live.at(star.position);
                   star.faces.push_back({slot, t[next], t[last], face.wedges[next], face.wedges[last],
                                         face.wedges[corner],
                                         glm::cross(live.at(t[next]) - p, live.at(t[last]) - p)});
               });
}

/// Whether the faces are fans: no position begins two sides of the contours, or ends two.
bool areFans(const VertexStar& star)
{
    for (std::size_t i = 0; i < star.faces.size(); ++i)
    {
        const StarFace& a = star.faces[i];
        if (a.from == star.position || a.to == star.position || a.from == a.to) return false;
        for (std::size_t j = i + 1; j < star.faces.size(); ++j)
            if (a.from == star.faces[j].from || a.to == star.faces[j].to) return false;
    }
    return true;
}

/// Sorts the faces of each fan by adjacency, and makes each fan a sector. An open fan begins at its open end.
void orderFans(VertexStar& star)
{
    std::vector<StarFace>& faces = star.faces;
    const auto ordered = [&](std::size_t count)
    { return faces.begin() + static_cast<std::ptrdiff_t>(count); };
    for (std::size_t done = 0; done < faces.size();)
    {
        const auto isBegin = [&](const StarFace& f)
        { return std::none_of(ordered(done), faces.end(), [&](const auto& g) { return g.to == f.from; }); };
        const auto begin = std::find_if(ordered(done), faces.end(), isBegin);
        StarSector fan{static_cast<std::uint32_t>(done), 1, begin == faces.end()};
        if (!fan.isClosed) std::iter_swap(ordered(done), begin);
        for (++done; done < faces.size(); ++done, ++fan.count)
        {
            const auto next = std::find_if(ordered(done), faces.end(),
                                           [&](const StarFace& f) { return f.from == faces[done - 1].to; });
            if (next == faces.end()) break;
            std::iter_swap(ordered(done), next);
        }
        star.sectors.push_back(fan);
    }
}

/// Whether attributes, material or part change between two consecutive faces of a fan.
bool isSeam(const LiveFaces& live, const StarFace& before, const StarFace& behind)
{
    const Face &a = live.face(before.slot), &b = live.face(behind.slot);
    return before.ownWedge != behind.ownWedge || before.toWedge != behind.fromWedge ||
           a.material != b.material || a.part != b.part;
}

bool isCrease(const StarFace& a, const StarFace& b, double creaseCosine)
{
    return glm::dot(a.area, b.area) < creaseCosine * glm::length(a.area) * glm::length(b.area);
}

/// The edges of a fan for which `is(before, behind)` holds: the faces behind the first two, and the number of
/// all.
struct FanEdges
{
    std::array<std::uint32_t, 2> at{};
    std::uint32_t count = 0;

    template<class Is>
    FanEdges(const VertexStar& star, const StarSector& fan, const Is& is)
    {
        for (std::uint32_t i = fan.isClosed ? 0 : 1; i < fan.count; ++i)
        {
            const StarFace& before = star.faces[fan.first + (i > 0 ? i : fan.count) - 1];
            if (!is(before, star.faces[fan.first + i])) continue;
            if (count < 2) at[count] = i;
            ++count;
        }
    }
};

/// Divides a closed fan in two before the faces `edges.at`.
void cut(VertexStar& star, std::size_t fan, const FanEdges& edges)
{
    StarSector& first = star.sectors[fan];
    const auto begin = star.faces.begin() + first.first;
    std::rotate(begin, begin + edges.at[0], begin + first.count);
    const std::uint32_t count = edges.at[1] - edges.at[0];
    const StarSector second{first.first + count, first.count - count, false};
    first = {first.first, count, false};
    star.sectors.push_back(second);
}

RemovalRefusal cutAlongSeams(const LiveFaces& live, double creaseCosine, VertexStar& star)
{
    const auto seam = [&](const StarFace& a, const StarFace& b) { return isSeam(live, a, b); };
    const auto crease = [&](const StarFace& a, const StarFace& b) { return isCrease(a, b, creaseCosine); };
    const std::size_t fans = star.sectors.size();
    for (std::size_t i = 0; i < fans; ++i)
    {
        const FanEdges seams(star, star.sectors[i], seam);
        if (seams.count != 0 && !(seams.count == 2 && star.sectors[i].isClosed))
            return RemovalRefusal::seamCorner;
        if (!star.sectors[i].isClosed) continue;
        const FanEdges edges = seams.count == 2 ? seams : FanEdges(star, star.sectors[i], crease);
        if (edges.count == 2) cut(star, i, edges);
    }
    return RemovalRefusal::none;
}

double lineDistance(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b)
{
    return glm::length(p - a - foundation::nearestShare(p, a, b) * (b - a));
}

RemovalRefusal measure(const LiveFaces& live, VertexStar& star)
{
    const glm::dvec3& p = live.at(star.position);
    for (const StarSector& sector : star.sectors)
    {
        glm::dvec3 normal(0.0), centre(0.0);
        double areas = 0.0;
        for (std::uint32_t i = sector.first; i < sector.first + sector.count; ++i)
        {
            const StarFace& f = star.faces[i];
            const double area = glm::length(f.area);
            normal += f.area;
            centre += area * (live.at(f.from) - p + live.at(f.to) - p) / 3.0;
            areas += area;
        }
        const double length = glm::length(normal);
        if (!(length > kLeastMeanNormal * areas)) return RemovalRefusal::folds;
        star.distance = std::max(star.distance, std::abs(glm::dot(normal, centre)) / (length * areas));
        if (sector.isClosed) continue;
        const StarFace &first = star.faces[sector.first], &last = star.faces[sector.first + sector.count - 1];
        star.distance = std::max(star.distance, lineDistance(p, live.at(first.from), live.at(last.to)));
    }
    return RemovalRefusal::none;
}

} // namespace

RemovalRefusal gatherStar(const LiveFaces& live, std::uint32_t position, double creaseCosine,
                          VertexStar& star)
{
    star.position = position;
    star.faces.clear();
    star.sectors.clear();
    star.distance = 0.0;
    if (live.degree(position) > kMostStarFaces) return RemovalRefusal::crowdedStar;
    collect(live, star);
    if (!areFans(star)) return RemovalRefusal::nonManifold;
    orderFans(star);
    if (const auto refusal = cutAlongSeams(live, creaseCosine, star); refusal != RemovalRefusal::none)
        return refusal;
    return measure(live, star);
}

} // namespace osgPMObjects::core
