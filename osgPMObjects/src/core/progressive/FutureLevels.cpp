// SPDX-License-Identifier: Apache-2.0
#include "FutureLevels.h"

#include <algorithm>

namespace osgPMObjects::core
{

FutureLevels::FutureLevels(const LevelWalk& walk, std::uint32_t cacheSize)
    : _walk(walk),
      _lifetimes(walk.split()),
      _cache(static_cast<std::uint32_t>(walk.split().mesh.wedgeCount()), cacheSize),
      _numbers(walk.split().mesh.wedgeCount(), kNone)
{
}

void FutureLevels::take(std::span<const std::uint32_t> faces, double shareGone)
{
    forgetWedges();
    takePresent(faces);
    _ends.clear();
    for (const std::uint32_t face : faces)
        _ends.push_back(_lifetimes.end(face));
    std::sort(_ends.begin(), _ends.end());
    for (std::size_t level = 1; level < kLevels; ++level)
    {
        const auto gone =
            static_cast<std::size_t>(shareGone * static_cast<double>(faces.size() * level) / (kLevels - 1));
        takeLevel(level, std::min(_ends[std::min(gone, faces.size() - 1)], _walk.stepCount()), faces);
    }
}

std::uint64_t FutureLevels::costOf(std::span<const std::uint32_t> order)
{
    const std::uint64_t before = _cache.misses();
    for (const std::vector<Triangle>& level : _levels)
    {
        _cache.empty();
        for (const std::uint32_t face : order)
            if (level[face][0] != kNone)
                for (const std::uint32_t wedge : level[face])
                    _cache.transform(wedge);
    }
    return _cache.misses() - before;
}

std::uint32_t FutureLevels::numberOf(std::uint32_t wedge)
{
    std::uint32_t& number = _numbers[wedge];
    if (number == kNone)
    {
        number = static_cast<std::uint32_t>(_used.size());
        _used.push_back(wedge);
    }
    return number;
}

void FutureLevels::forgetWedges()
{
    for (const std::uint32_t wedge : _used)
        _numbers[wedge] = kNone;
    _used.clear();
}

void FutureLevels::takePresent(std::span<const std::uint32_t> faces)
{
    _wedges.clear();
    _levels[0].clear();
    for (const std::uint32_t face : faces)
    {
        const Triangle& t = _wedges.emplace_back(_walk.triangle(face));
        _levels[0].push_back({numberOf(t[0]), numberOf(t[1]), numberOf(t[2])});
    }
}

void FutureLevels::takeLevel(std::size_t level, std::uint32_t steps, std::span<const std::uint32_t> faces)
{
    std::vector<Triangle>& triangles = _levels[level];
    triangles.assign(faces.size(), {kNone, kNone, kNone});
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
        if (_lifetimes.end(faces[i]) <= steps) continue;
        for (int corner = 0; corner < 3; ++corner)
        {
            std::uint32_t& wedge = _wedges[i][corner];
            wedge = _lifetimes.wedgeAfter(wedge, steps);
            triangles[i][corner] = numberOf(wedge);
        }
    }
}

} // namespace osgPMObjects::core
