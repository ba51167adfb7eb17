// SPDX-License-Identifier: Apache-2.0
#include "FaceCutter.h"

#include <utility>

#include <osgPMObjects/core/mesh/Wedge.h>

namespace osgPMObjects::core
{

namespace
{

float rescaled(float along, float from, float to)
{
    return to > from ? (along - from) / (to - from) : 0.5f;
}

} // namespace

std::uint32_t EdgeWedges::between(std::uint32_t from, std::uint32_t to, const OnSide& at)
{
    const bool isTurned = from > to;
    if (isTurned) std::swap(from, to);
    const auto [place, isNew] = _known.try_emplace(std::tuple(from, to, at.position), 0);
    if (isNew)
    {
        const float along = isTurned ? 1.0f - at.along : at.along;
        place->second =
            appendWedge(_mesh, interpolated(wedgeOf(_mesh, from), wedgeOf(_mesh, to), along, at.position));
    }
    return place->second;
}

void cutFace(const CrowdedFace& face, const Face& pattern, EdgeWedges& wedges, std::vector<Face>& into)
{
    std::size_t side = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (face.onSide[i].size() > face.onSide[side].size()) side = i;
    const std::vector<OnSide>& crowd = face.onSide[side];
    if (crowd.empty())
    {
        into.push_back(pattern);
        into.back().wedges = face.wedges;
        return;
    }
    const std::size_t next = (side + 1) % 3, last = (side + 2) % 3, middle = crowd.size() / 2;
    const OnSide at = crowd[middle];
    const std::uint32_t wedge = wedges.between(face.wedges[side], face.wedges[next], at);
    CrowdedFace before{{face.wedges[side], wedge, face.wedges[last]}, {{{}, {}, face.onSide[last]}}};
    CrowdedFace after{{wedge, face.wedges[next], face.wedges[last]}, {{{}, face.onSide[next], {}}}};
    for (std::size_t i = 0; i < crowd.size(); ++i)
        if (i < middle)
            before.onSide[0].push_back({crowd[i].position, rescaled(crowd[i].along, 0.0f, at.along)});
        else if (i > middle)
            after.onSide[0].push_back({crowd[i].position, rescaled(crowd[i].along, at.along, 1.0f)});
    cutFace(before, pattern, wedges, into);
    cutFace(after, pattern, wedges, into);
}

} // namespace osgPMObjects::core
