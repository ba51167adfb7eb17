// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>

#include <osgPMObjects/core/mesh/Mesh.h>

#include "MadeMeshes.h"

/// Meshes with the defects that consolidation mends.
namespace brokenmeshes
{

using osgPMObjects::core::Face;
using osgPMObjects::core::Mesh;

/// A mesh without shared vertices: each corner has a position and a wedge of its own, displaced by up to
/// `noise`.
inline Mesh soup(const Mesh& whole, double noise, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> off(-noise, noise);
    Mesh mesh = whole;
    mesh.positions.clear();
    mesh.wedgePositions.clear();
    for (Face& face : mesh.faces)
        for (std::uint32_t& wedge : face.wedges)
        {
            mesh.positions.push_back(whole.positions[whole.wedgePositions[wedge]] +
                                     glm::dvec3(off(random), off(random), off(random)));
            wedge = static_cast<std::uint32_t>(mesh.wedgePositions.size());
            mesh.wedgePositions.push_back(wedge);
        }
    return mesh;
}

/// A soup with `breaks` defects: duplicated, reversed, flat and stray faces, and corners moved to the middle
/// of edges.
inline Mesh brokenSoup(unsigned seed, int breaks, unsigned side, double noise)
{
    std::mt19937 random(seed);
    Mesh mesh = soup(testsupport::grid(side + random() % 6, side + random() % 6), noise, seed);
    for (int i = 0; i < breaks; ++i)
    {
        Face face = mesh.faces[random() % mesh.faces.size()];
        if (i % 4 == 0) std::swap(face.wedges[0], face.wedges[1]);
        if (i % 4 == 1) face.wedges[0] = face.wedges[1];
        if (i % 4 == 2)
        {
            mesh.positions.push_back(0.5 * (mesh.at(face, 0) + mesh.at(face, 1)));
            face.wedges[2] = static_cast<std::uint32_t>(mesh.wedgeCount());
            mesh.wedgePositions.push_back(static_cast<std::uint32_t>(mesh.positions.size() - 1));
        }
        if (i % 4 == 3) face.wedges[1] = static_cast<std::uint32_t>(random() % mesh.wedgeCount());
        mesh.faces.push_back(face);
    }
    return mesh;
}

} // namespace brokenmeshes
