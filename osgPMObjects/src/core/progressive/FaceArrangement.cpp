// SPDX-License-Identifier: Apache-2.0
#include "FaceArrangement.h"

namespace osgPMObjects::core
{

std::unique_ptr<FaceArrangement> makeArrangement(const ArrangementSettings& settings)
{
    switch (settings.arrangement)
    {
    case Arrangement::plain:
        return plainArrangement();
    case Arrangement::tswap:
        return tswapArrangement(settings);
    case Arrangement::blocks:
        return blockArrangement(settings);
    case Arrangement::windows:
        break;
    }
    return windowArrangement(settings);
}

std::vector<std::vector<std::uint32_t>> liveFacesByMaterial(const LevelWalk& walk)
{
    const Mesh& mesh = walk.split().mesh;
    std::vector<std::vector<std::uint32_t>> faces(mesh.materials.size());
    for (std::uint32_t face = 0; face < walk.faceCount(); ++face)
        if (walk.isLive(face)) faces[mesh.faces[face].material].push_back(face);
    return faces;
}

LocalNumbers::LocalNumbers(const LevelWalk& walk) : _numbers(walk.split().mesh.wedgeCount(), kNone) {}

std::vector<Triangle> LocalNumbers::trianglesOf(const LevelWalk& walk, std::span<const std::uint32_t> faces)
{
    std::vector<Triangle> triangles;
    triangles.reserve(faces.size());
    std::vector<std::uint32_t> used;
    for (const std::uint32_t face : faces)
    {
        Triangle& triangle = triangles.emplace_back();
        for (int corner = 0; corner < 3; ++corner)
        {
            std::uint32_t& number = _numbers[walk.triangle(face)[corner]];
            if (number == kNone)
            {
                number = static_cast<std::uint32_t>(used.size());
                used.push_back(walk.triangle(face)[corner]);
            }
            triangle[corner] = number;
        }
    }
    for (const std::uint32_t wedge : used)
        _numbers[wedge] = kNone;
    _count = static_cast<std::uint32_t>(used.size());
    return triangles;
}

} // namespace osgPMObjects::core
