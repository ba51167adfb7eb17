// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "scenery/models/entities/Airframe.h"

/// The measures of the single-engined aeroplane that are seen from outside and from its seat. Origin: on the
/// ground below the axle of the main wheels. Units: metres.
namespace scenery::models
{

inline constexpr double kLightLengthM = 8.1;
inline constexpr double kLightRoundness = 2.78; ///< power of the fuselage's sections

/// From the tail to the nose; the cowling begins at kLightCowling.
inline constexpr std::array<FuselageSection, 15> kLightSections{{{-5.20, 1.52, 0.05, 0.13},
                                                                 {-4.00, 1.47, 0.17, 0.23},
                                                                 {-2.30, 1.43, 0.34, 0.40},
                                                                 {-1.60, 1.43, 0.43, 0.52},
                                                                 {-1.15, 1.42, 0.49, 0.63},
                                                                 {-0.40, 1.41, 0.545, 0.70},
                                                                 {-0.30, 1.41, 0.55, 0.70},
                                                                 {0.52, 1.41, 0.56, 0.70},
                                                                 {0.66, 1.40, 0.56, 0.69},
                                                                 {0.98, 1.28, 0.555, 0.58},
                                                                 {1.22, 1.20, 0.54, 0.50},
                                                                 {1.60, 1.20, 0.51, 0.47},
                                                                 {2.05, 1.21, 0.45, 0.41},
                                                                 {2.28, 1.22, 0.36, 0.31},
                                                                 {2.34, 1.22, 0.22, 0.20}}};
inline constexpr std::size_t kLightCowling = 10;

/// The left wing from its root to where the tip begins.
inline const std::array<AerofoilStation, 4> kLightWing{AerofoilStation{{0.95, 0.0, 2.06}, 1.62},
                                                       {{0.95, 0.45, 2.073}, 1.62},
                                                       {{0.95, 2.6, 2.13}, 1.62},
                                                       {{0.84, 4.9, 2.20}, 1.22}};

inline constexpr glm::dvec3 kLightStrutLow{0.42, 0.50, 0.92}, kLightStrutHigh{0.42, 2.55, 2.08};
inline constexpr double kLightStrutRadiusM = 0.035;
inline constexpr glm::dvec3 kLightPropellerHub{2.42, 0.0, 1.22};
inline constexpr double kLightPropellerRadiusM = 0.95, kLightPropellerChordM = 0.17;

} // namespace scenery::models
