// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <unordered_map>

#include <osgPMObjects/core/tessellate/UniformMesh.h>

namespace osgPMObjects::core
{

namespace
{

/// Divides triangles until their edges are short enough. Source: see meshUniformly().
class Divider
{
public:
    Divider(std::span<const glm::dvec3> positions, double longestEdge) : _longest(longestEdge)
    {
        _mesh.positions.assign(positions.begin(), positions.end());
    }

    /// Adds the parts of a triangle; returns false if there would be too many triangles.
    bool add(const Triangle& triangle, std::uint32_t origin, std::uint32_t mostTriangles)
    {
        _open.push_back(triangle);
        while (!_open.empty())
        {
            if (_mesh.triangles.size() + _open.size() > mostTriangles) return false;
            const Triangle t = _open.back();
            _open.pop_back();
            if (divide(t)) continue;
            _mesh.triangles.push_back(t);
            _mesh.origin.push_back(origin);
        }
        return true;
    }

    UniformMesh& mesh() { return _mesh; }

private:
    /// Returns the length of an edge, equal to the last bit for both directions.
    double length(std::uint32_t a, std::uint32_t b) const
    {
        return glm::distance(_mesh.positions[a], _mesh.positions[b]);
    }

    std::uint32_t midpoint(std::uint32_t a, std::uint32_t b)
    {
        const auto [low, high] = std::minmax(a, b);
        const auto next = static_cast<std::uint32_t>(_mesh.positions.size());
        const auto [at, isNew] = _midpoints.try_emplace(std::uint64_t(low) << 32 | high, next);
        if (isNew)
        {
            _mesh.positions.push_back(_mesh.positions[a] * 0.5 + _mesh.positions[b] * 0.5);
            _mesh.midpointOf.push_back({low, high});
        }
        return at->second;
    }

    /// Puts the parts of a triangle with a long edge on the list. Returns whether it had one.
    bool divide(const Triangle& triangle)
    {
        bool isLong[3];
        for (int i = 0; i < 3; ++i)
            isLong[i] = length(triangle[i], triangle[(i + 1) % 3]) > _longest;
        const int count = isLong[0] + isLong[1] + isLong[2];
        if (count == 0) return false;
        // Rotated so that a single long edge comes first, or two come first and second.
        int first = 0;
        while (count < 3 && !(isLong[first] && !isLong[(first + 2) % 3]))
            ++first;
        const std::uint32_t a = triangle[first], b = triangle[(first + 1) % 3], c = triangle[(first + 2) % 3];
        const std::uint32_t ab = midpoint(a, b);
        if (count == 1)
            put({{a, ab, c}, {ab, b, c}});
        else if (const std::uint32_t bc = midpoint(b, c); count == 3)
        {
            const std::uint32_t ca = midpoint(c, a);
            put({{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        else if (length(a, bc) <= length(ab, c))
            put({{ab, b, bc}, {a, ab, bc}, {a, bc, c}});
        else
            put({{ab, b, bc}, {a, ab, c}, {ab, bc, c}});
        return true;
    }

    void put(std::initializer_list<Triangle> parts) { _open.insert(_open.end(), parts); }

    double _longest;
    UniformMesh _mesh;
    std::unordered_map<std::uint64_t, std::uint32_t> _midpoints; ///< by the numbers of the edge's ends
    std::vector<Triangle> _open;
};

} // namespace

foundation::Result<UniformMesh> meshUniformly(std::span<const glm::dvec3> positions,
                                              std::span<const Triangle> triangles, double longestEdge,
                                              std::uint32_t mostTriangles)
{
    if (!(longestEdge > 0.0))
        return foundation::Error{"uniform meshing", "an edge length of " + std::to_string(longestEdge),
                                 "give one above zero"};
    Divider divider(positions, longestEdge);
    for (std::size_t i = 0; i < triangles.size(); ++i)
        if (!divider.add(triangles[i], static_cast<std::uint32_t>(i), mostTriangles))
            return foundation::Error{"uniform meshing",
                                     "more than " + std::to_string(mostTriangles) +
                                         " triangles with edges up to " + std::to_string(longestEdge),
                                     "allow longer edges"};
    return std::move(divider.mesh());
}

} // namespace osgPMObjects::core
