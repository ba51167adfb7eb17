// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <osgPMObjects/core/polish/PolishByImages.h>

namespace osgPMObjects::core
{

/// The drawing state of a material.
struct SeenMaterial
{
    const MaterialLook* look = nullptr;
    bool isTwoSided = false;
    bool isLitFromBothSides = false;
    bool isTransparent = false;
};

/// A face with all that drawing needs.
/// Frame: as the views; a model of diagonal 1 at the origin fits into every image.
struct SeenFace
{
    std::uint32_t number = 0; ///< identifies its fragments
    std::array<glm::dvec3, 3> corners{};
    std::array<glm::vec3, 3> normals{}; ///< 0: not lit
    std::array<glm::vec2, 3> texCoords{};
    std::array<float, 3> luminances{}; ///< of the corners' vertex colours
    SeenMaterial material;
};

} // namespace osgPMObjects::core
