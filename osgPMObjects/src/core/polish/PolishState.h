// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/Extent.h>
#include <osgPMObjects/core/mesh/Mesh.h>

#include "../simplify/quadric/StarQuadric.h"
#include "../simplify/star/StarMesh.h"
#include "ImageFrame.h"
#include "PictureRing.h"

namespace osgPMObjects::core
{

/// How a mesh's faces are drawn.
std::vector<SeenMaterial> seenMaterials(const Mesh& mesh, std::span<const MaterialLook> looks);

/// A wedge as a corner of a face in pictures.
void setCorner(SeenFace& face, int corner, const glm::dvec3& at, const Wedge& wedge,
               const Material& material);

/// All faces of a mesh, numbered as they are.
std::vector<SeenFace> seenFaces(const Mesh& mesh, const ImageFrame& frame,
                                std::span<const SeenMaterial> materials);

/// A level on its way to a lower one, with its pictures. Positions in the unit frame of the original.
struct PolishState
{
    Mesh mesh; ///< of the level that it began with; wedges change when positions move
    std::vector<SeenMaterial> materials;
    std::vector<glm::dvec3> positions;
    Extent box;
    StarMesh stars;
    std::vector<LevelError> errors;             ///< by position, in units of the frame
    std::vector<std::uint32_t> facesOfMaterial; ///< that are left
    AreaWeight weight;
    double shapeScale = 0.0; ///< what a quadric's cost is worth in squared luminance of pixels
    PictureRing ring;

    PolishState(const Mesh& original, Mesh level, std::span<const MaterialLook> looks,
                const PolishSettings& settings);

    SeenFace seen(std::uint32_t face) const;
};

} // namespace osgPMObjects::core
