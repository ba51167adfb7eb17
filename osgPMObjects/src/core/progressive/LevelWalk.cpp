// SPDX-License-Identifier: Apache-2.0
#include "LevelWalk.h"

#include <algorithm>

namespace osgPMObjects::core
{

LevelWalk::LevelWalk(const SplitOrder& split)
    : _split(split),
      _isLive(split.mesh.faces.size(), true),
      _facesOf(split.mesh.wedgeCount()),
      _liveFaces(static_cast<std::uint32_t>(split.mesh.faces.size())),
      _wedgesLeft(static_cast<std::uint32_t>(split.mesh.wedgeCount()))
{
    _triangles.reserve(split.mesh.faces.size());
    for (std::uint32_t face = 0; face < split.mesh.faces.size(); ++face)
    {
        _triangles.push_back(split.mesh.faces[face].wedges);
        for (const std::uint32_t wedge : _triangles.back())
            _facesOf[wedge].push_back(face);
    }
}

bool LevelWalk::vanishes(std::uint32_t face, std::uint32_t from, std::uint32_t to) const
{
    const auto& positions = _split.mesh.wedgePositions;
    return std::any_of(_triangles[face].begin(), _triangles[face].end(),
                       [&](std::uint32_t wedge)
                       { return wedge != from && positions[wedge] == positions[to]; });
}

void LevelWalk::collapse(std::uint32_t from, std::uint32_t to)
{
    std::vector<std::uint32_t> faces;
    faces.swap(_facesOf[from]);
    std::sort(faces.begin(), faces.end());
    for (const std::uint32_t face : faces)
    {
        if (!_isLive[face]) continue;
        if (vanishes(face, from, to))
        {
            _isLive[face] = false;
            --_liveFaces;
            _vanished.push_back(face);
            continue;
        }
        std::replace(_triangles[face].begin(), _triangles[face].end(), from, to);
        _facesOf[to].push_back(face);
        _patches.push_back({face, from});
    }
    std::erase_if(_facesOf[to], [this](std::uint32_t face) { return !_isLive[face]; });
}

void LevelWalk::step()
{
    _patches.clear();
    _vanished.clear();
    const auto& positions = _split.mesh.wedgePositions;
    const std::uint32_t position = positions[_wedgesLeft - 1];
    while (_wedgesLeft > 0 && positions[_wedgesLeft - 1] == position)
    {
        const std::uint32_t wedge = --_wedgesLeft;
        collapse(wedge, _split.parents[wedge]);
    }
    ++_steps;
}

} // namespace osgPMObjects::core
