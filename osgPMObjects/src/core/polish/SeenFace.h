// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <osgPMObjects/core/polish/PolishByImages.h>

namespace osgPMObjects::core
{

/// What a material's faces are drawn with.
struct SeenMaterial
{
    const MaterialLook* look = nullptr;
    bool isTwoSided = false;
    bool isLitFromBothSides = false;
    bool isTransparent = false;
};

/// A face with all that pictures need of it.
/// Frame: as the views; a model of diagonal 1 about the origin fits into every picture.
struct SeenFace
{
    std::uint32_t number = 0; ///< what its fragments are known by
    std::array<glm::dvec3, 3> corners{};
    std::array<glm::vec3, 3> normals{}; ///< 0: not lit
    std::array<glm::vec2, 3> texCoords{};
    std::array<float, 3> luminances{}; ///< of the corners' own colours
    SeenMaterial material;
};

} // namespace osgPMObjects::core
