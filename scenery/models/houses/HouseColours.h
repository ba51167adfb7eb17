// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace scenery::models
{

/// The colours of houses. Units: display values, multiplied with the light textures.
inline constexpr std::array kPlasterTints{glm::vec3(1.00F, 0.98F, 0.93F), glm::vec3(0.97F, 0.90F, 0.76F),
                                          glm::vec3(0.93F, 0.82F, 0.66F), glm::vec3(0.90F, 0.90F, 0.88F),
                                          glm::vec3(0.94F, 0.78F, 0.68F), glm::vec3(0.82F, 0.87F, 0.80F),
                                          glm::vec3(0.80F, 0.86F, 0.92F)};
inline constexpr std::array kTileTints{glm::vec3(0.70F, 0.42F, 0.32F), glm::vec3(0.60F, 0.35F, 0.28F),
                                       glm::vec3(0.50F, 0.30F, 0.25F), glm::vec3(0.42F, 0.42F, 0.44F)};
inline constexpr std::array kDoorTints{glm::vec3(0.42F, 0.26F, 0.16F), glm::vec3(0.20F, 0.32F, 0.25F),
                                       glm::vec3(0.22F, 0.28F, 0.40F), glm::vec3(0.50F, 0.16F, 0.14F),
                                       glm::vec3(0.85F, 0.85F, 0.83F)};
inline constexpr std::array kSheetTints{glm::vec3(0.80F, 0.83F, 0.85F), glm::vec3(0.62F, 0.70F, 0.78F),
                                        glm::vec3(0.86F, 0.84F, 0.76F), glm::vec3(0.66F, 0.74F, 0.66F)};

} // namespace scenery::models
