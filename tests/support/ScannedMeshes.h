// SPDX-License-Identifier: Apache-2.0
// Closed meshes as scanners make them: a curved surface with edges in all directions and vertices of many
// valences.
#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "MadeMeshes.h"
#include "Random.h"

namespace testsupport
{

/// Turns edges of a closed mesh at random: the two triangles at an edge get the other diagonal of their
/// quadrangle.
class EdgeTurner
{
public:
    EdgeTurner(const std::vector<glm::dvec3>& positions, std::vector<std::array<std::uint32_t, 3>>& faces)
        : _positions(positions), _faces(faces), _valence(positions.size(), 0)
    {
        for (std::uint32_t f = 0; f < faces.size(); ++f)
            for (int c = 0; c < 3; ++c)
            {
                ++_valence[faces[f][c]];
                enter(f, c);
            }
    }

    void turn(std::uint32_t face, int corner)
    {
        const std::uint32_t a = _faces[face][corner], b = _faces[face][(corner + 1) % 3],
                            c = _faces[face][(corner + 2) % 3];
        const std::uint32_t other = _faceAt.at(key(b, a));
        std::uint32_t d = 0;
        for (const std::uint32_t v : _faces[other])
            if (v != a && v != b) d = v;
        if (_valence[a] < 5 || _valence[b] < 5 || _valence[c] > 8 || _valence[d] > 8) return;
        if (_faceAt.contains(key(c, d)) || _faceAt.contains(key(d, c))) return;
        const glm::dvec3 up = normalOf(a, b, c) + normalOf(b, a, d);
        if (glm::dot(normalOf(a, d, c), up) <= 0.0 || glm::dot(normalOf(d, b, c), up) <= 0.0) return;
        _faceAt.erase(key(a, b));
        _faceAt.erase(key(b, a));
        --_valence[a];
        --_valence[b];
        ++_valence[c];
        ++_valence[d];
        _faces[face] = {a, d, c};
        _faces[other] = {d, b, c};
        for (int i = 0; i < 3; ++i)
        {
            enter(face, i);
            enter(other, i);
        }
    }

private:
    static std::uint64_t key(std::uint32_t from, std::uint32_t to) { return std::uint64_t{from} << 32 | to; }

    void enter(std::uint32_t f, int c) { _faceAt[key(_faces[f][c], _faces[f][(c + 1) % 3])] = f; }

    glm::dvec3 normalOf(std::uint32_t a, std::uint32_t b, std::uint32_t c) const
    {
        return glm::cross(_positions[b] - _positions[a], _positions[c] - _positions[a]);
    }

    const std::vector<glm::dvec3>& _positions;
    std::vector<std::array<std::uint32_t, 3>>& _faces;
    std::vector<std::uint32_t> _valence;
    std::unordered_map<std::uint64_t, std::uint32_t> _faceAt; ///< by directed edge
};

/// A closed blob with bumps, of radius about 1: an octahedron whose edges are divided by `divisions`, so it
/// has 8 divisions² faces; a third of the edges are turned.
inline Mesh scannedBlob(std::int32_t divisions)
{
    std::vector<glm::dvec3> positions;
    std::map<std::array<std::int32_t, 3>, std::uint32_t> numbers;
    Random random(7);
    const auto at = [&](const std::array<std::int32_t, 3>& p)
    {
        const auto [entry, isNew] = numbers.try_emplace(p, static_cast<std::uint32_t>(positions.size()));
        if (isNew)
        {
            const glm::dvec3 way = glm::normalize(glm::dvec3(p[0], p[1], p[2]));
            const double bumps =
                std::sin(5.0 * way.x + 1.0) * std::cos(7.0 * way.y) + 0.5 * std::sin(19.0 * way.z);
            const double noise = random.below(1000) / 1000.0;
            positions.push_back(way * (1.0 + 0.12 * bumps + 0.15 * noise / divisions));
        }
        return entry->second;
    };
    std::vector<std::array<std::uint32_t, 3>> faces;
    for (int octant = 0; octant < 8; ++octant)
    {
        const std::array<int, 3> sign{octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1};
        const bool isTurned = sign[0] * sign[1] * sign[2] < 0;
        const auto corner = [&](std::int32_t i, std::int32_t j) {
            return at({sign[0] * (divisions - i - j), sign[1] * i, sign[2] * j});
        };
        const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            faces.push_back(isTurned ? std::array{a, c, b} : std::array{a, b, c});
        };
        for (std::int32_t i = 0; i < divisions; ++i)
            for (std::int32_t j = 0; i + j < divisions; ++j)
            {
                add(corner(i, j), corner(i + 1, j), corner(i, j + 1));
                if (i + j + 1 < divisions) add(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
            }
    }
    EdgeTurner turner(positions, faces);
    const auto count = static_cast<std::uint32_t>(faces.size());
    for (std::uint32_t i = 0; i < count; ++i)
        turner.turn(random.below(count), static_cast<int>(random.below(3)));
    return meshOf(std::move(positions), faces);
}

} // namespace testsupport
