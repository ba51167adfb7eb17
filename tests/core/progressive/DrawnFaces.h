// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>

#include "ClosedMeshes.h"
#include "SimplifyMeshes.h"

namespace testsupport
{

struct ProgressiveSubject
{
    std::string name;
    osgPMObjects::core::Mesh mesh;
};

inline std::vector<ProgressiveSubject> progressiveSubjects()
{
    return {{"open", waves(14, 11)},
            {"closed", torus(17, 9)},
            {"seam", texturedInHalves(12, 10)},
            {"two materials", together(waves(9, 7), torus(12, 8), {20.0, 0.0, 0.0})},
            {"soup", faceSoup(3, 60, 90)}};
}

/// Returns settings with small blocks, so that small meshes have many.
inline osgPMObjects::core::ArrangementSettings smallBlocks(osgPMObjects::core::Arrangement arrangement)
{
    return {.arrangement = arrangement,
            .blockFaces = arrangement == osgPMObjects::core::Arrangement::windows ? 40u : 8u};
}

/// A corner without its number: position and attributes.
using SeenCorner = std::array<double, 5>;
using SeenFace = std::array<SeenCorner, 3>;
using SeenFaces = std::vector<std::pair<std::uint32_t, SeenFace>>; ///< with their materials, sorted

inline void addSeen(SeenFaces& faces, const osgPMObjects::core::Mesh& mesh, std::uint32_t material,
                    const osgPMObjects::core::Triangle& wedges)
{
    SeenFace face;
    std::transform(wedges.begin(), wedges.end(), face.begin(),
                   [&](std::uint32_t wedge) -> SeenCorner
                   {
                       const osgPMObjects::core::Wedge w = wedgeOf(mesh, wedge);
                       const glm::dvec3& at = mesh.positions[w.position];
                       return {at.x, at.y, at.z, w.texCoords[0].x, w.texCoords[0].y};
                   });
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.emplace_back(material, face);
}

inline SeenFaces seenOf(const osgPMObjects::core::Mesh& level)
{
    SeenFaces faces;
    for (const osgPMObjects::core::Face& face : level.faces)
        addSeen(faces, level, face.material, face.wedges);
    std::sort(faces.begin(), faces.end());
    return faces;
}

} // namespace testsupport
