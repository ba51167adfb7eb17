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

/// Returns for each material what its faces are drawn with.
std::vector<SeenMaterial> seenMaterials(const Mesh& mesh, std::span<const MaterialLook> looks);

/// Sets a corner of a face from a wedge.
void setCorner(SeenFace& face, int corner, const glm::dvec3& at, const Wedge& wedge,
               const Material& material);

/// Returns all faces of a mesh for drawing, with their numbers.
std::vector<SeenFace> seenFaces(const Mesh& mesh, const ImageFrame& frame,
                                std::span<const SeenMaterial> materials);

/// A level during polishing, with its images. Positions are in the image frame of the original.
struct PolishState
{
    Mesh mesh; ///< the level at the start; its wedges change when positions move
    std::vector<SeenMaterial> materials;
    std::vector<glm::dvec3> positions;
    Extent box;
    StarMesh stars;
    std::vector<LevelError> errors;             ///< by position, in units of the frame
    std::vector<std::uint32_t> facesOfMaterial; ///< number of faces left
    AreaWeight weight;
    double shapeScale = 0.0; ///< weight of a quadric's cost, in squared luminance of pixels
    PictureRing ring;

    PolishState(const Mesh& original, Mesh level, std::span<const MaterialLook> looks,
                const PolishSettings& settings);

    SeenFace seen(std::uint32_t face) const;
};

} // namespace osgPMObjects::core
