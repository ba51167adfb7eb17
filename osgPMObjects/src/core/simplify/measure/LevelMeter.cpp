// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgPMObjects/core/mesh/SurfaceChange.h>
#include <osgPMObjects/core/mesh/UnionFind.h>
#include <osgPMObjects/core/simplify/LevelMeter.h>

namespace osgPMObjects::core
{

/// The small connected parts of a mesh, and the surface of all others.
class LevelMeter::Specks
{
public:
    Specks(const Mesh& original, double size, std::size_t samples)
        : _rest(splitOff(original, size)), _surface(_rest, samples)
    {
    }

    /// Returns the surface of all parts that are no specks.
    const MeasuredSurface& surface() const { return _surface; }

    /// Returns the number of specks with a corner farther than `distance` from a surface.
    std::uint32_t countBeyond(const MeasuredSurface& level, double distance) const
    {
        const auto isGone = [&](const std::vector<glm::dvec3>& corners)
        {
            return std::any_of(corners.begin(), corners.end(),
                               [&](const glm::dvec3& c) { return level.tree().distance(c) > distance; });
        };
        return static_cast<std::uint32_t>(std::count_if(_corners.begin(), _corners.end(), isGone));
    }

private:
    /// Notes the corners of the specks and returns the mesh without their faces.
    Mesh splitOff(const Mesh& original, double size)
    {
        UnionFind parts(original.positions.size());
        for (const Face& face : original.faces)
            for (int corner = 1; corner < 3; ++corner)
                parts.join(original.positionOf(face, 0), original.positionOf(face, corner));
        std::vector<Extent> boxes(original.positions.size());
        const auto partOf = [&](const Face& face) { return parts.root(original.positionOf(face, 0)); };
        for (const Face& face : original.faces)
            for (int corner = 0; corner < 3; ++corner)
                boxes[partOf(face)].add(original.at(face, corner));
        Mesh rest = original;
        std::erase_if(rest.faces, [&](const Face& face) { return boxes[partOf(face)].diagonal() <= size; });
        std::vector<std::uint32_t> numbers(original.positions.size(), kNone);
        for (const Face& face : original.faces)
        {
            const std::uint32_t part = partOf(face);
            if (boxes[part].diagonal() > size) continue;
            if (numbers[part] == kNone)
            {
                numbers[part] = static_cast<std::uint32_t>(_corners.size());
                _corners.emplace_back();
            }
            for (int corner = 0; corner < 3; ++corner)
                _corners[numbers[part]].push_back(original.at(face, corner));
        }
        return rest;
    }

    static constexpr std::uint32_t kNone = ~0u;

    std::vector<std::vector<glm::dvec3>> _corners; ///< by speck
    Mesh _rest;
    MeasuredSurface _surface;
};

LevelMeter::LevelMeter(const Mesh& original, std::size_t samples, double speckSize)
    : _samples(samples), _original(original, samples)
{
    if (speckSize > 0.0) _specks = std::make_unique<Specks>(original, speckSize, samples);
}

LevelMeter::~LevelMeter() = default;

MeasuredError LevelMeter::measure(const Mesh& level) const
{
    const MeasuredSurface surface(level, _samples);
    const MeasuredSurface& counted = _specks ? _specks->surface() : _original;
    const SurfaceDistance there = surfaceDistance(counted, surface),
                          back = surfaceDistance(surface, _original);
    double largest = farthestDistance(surface, _original, std::max(there.largest, back.largest));
    largest = farthestDistance(counted, surface, largest);
    return {static_cast<float>(largest),
            static_cast<float>(std::max(there.rootMeanSquare, back.rootMeanSquare))};
}

std::uint32_t LevelMeter::countVanished(const Mesh& level, double distance) const
{
    return _specks ? _specks->countBeyond(MeasuredSurface(level, 0), distance) : 0;
}

} // namespace osgPMObjects::core
