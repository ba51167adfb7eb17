// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "scenery/models/trees/TreeForm.h"

namespace scenery::models
{

namespace
{

double dome(double t)
{
    return std::pow(std::max(1.0 - std::pow(std::abs(2.0 * t - 0.85) / 1.15, 2.3), 0.02), 0.5);
}

double egg(double t)
{
    return std::sqrt(std::max(t + 0.05, 0.0)) * std::pow(std::max(1.02 - t, 0.0), 0.72) * 1.66;
}

double column(double t)
{
    return std::pow(std::max(t + 0.06, 0.0), 0.3) * std::pow(std::max(1.03 - t, 0.0), 0.55) * 1.25;
}

double cone(double t)
{
    return std::pow(std::max(1.0 - t, 0.0), 0.85) * (t < 0.06 ? 0.75 + 4.0 * t : 1.0) + 0.02;
}

// By TreeKind: oak, birch, poplar, spruce, bush.
constexpr std::array kForms{TreeForm{.heightM = {11.0, 17.0},
                                     .crownFrom = {0.17, 0.25},
                                     .crownRadius = {0.34, 0.42},
                                     .trunkRadius = 0.026,
                                     .trunkTo = 0.84,
                                     .trunkWander = 0.018,
                                     .stems = 1,
                                     .profile = dome,
                                     .boughs = 25,
                                     .boughElevationDeg = {14.0, 72.0},
                                     .boughBend = 0.20,
                                     .twigsPerBough = 7,
                                     .twigSpreadDeg = 48.0,
                                     .cardsPerTwig = 8,
                                     .cardM = {1.15, 1.75},
                                     .cardWidth = 0.95,
                                     .cardHang = 0.0,
                                     .flatCards = false,
                                     .bark = Painting::oakBark,
                                     .leaves = Painting::oakLeaves,
                                     .barkRepeats = {3.0, 0.55},
                                     .leafTint = {0.90F, 0.90F, 0.84F}},
                            TreeForm{.heightM = {11.0, 17.0},
                                     .crownFrom = {0.20, 0.30},
                                     .crownRadius = {0.18, 0.23},
                                     .trunkRadius = 0.0115,
                                     .trunkTo = 0.97,
                                     .trunkWander = 0.022,
                                     .stems = 1,
                                     .profile = egg,
                                     .boughs = 42,
                                     .boughElevationDeg = {32.0, 68.0},
                                     .boughBend = -0.25,
                                     .twigsPerBough = 5,
                                     .twigSpreadDeg = 40.0,
                                     .cardsPerTwig = 5,
                                     .cardM = {0.85, 1.35},
                                     .cardWidth = 0.8,
                                     .cardHang = 0.6,
                                     .flatCards = false,
                                     .bark = Painting::birchBark,
                                     .leaves = Painting::birchLeaves,
                                     .barkRepeats = {1.0, 0.9},
                                     .leafTint = {0.95F, 0.94F, 0.90F}},
                            TreeForm{.heightM = {18.0, 26.0},
                                     .crownFrom = {0.06, 0.10},
                                     .crownRadius = {0.085, 0.11},
                                     .trunkRadius = 0.016,
                                     .trunkTo = 0.97,
                                     .trunkWander = 0.008,
                                     .stems = 1,
                                     .profile = column,
                                     .boughs = 58,
                                     .boughElevationDeg = {62.0, 82.0},
                                     .boughBend = 0.10,
                                     .twigsPerBough = 4,
                                     .twigSpreadDeg = 24.0,
                                     .cardsPerTwig = 6,
                                     .cardM = {1.2, 1.8},
                                     .cardWidth = 0.75,
                                     .cardHang = -0.35,
                                     .flatCards = false,
                                     .bark = Painting::oakBark,
                                     .leaves = Painting::poplarLeaves,
                                     .barkRepeats = {3.0, 0.5},
                                     .leafTint = {0.88F, 0.90F, 0.88F}},
                            TreeForm{.heightM = {16.0, 26.0},
                                     .crownFrom = {0.05, 0.13},
                                     .crownRadius = {0.17, 0.215},
                                     .trunkRadius = 0.0135,
                                     .trunkTo = 0.985,
                                     .trunkWander = 0.003,
                                     .stems = 1,
                                     .profile = cone,
                                     .boughs = 128,
                                     .boughElevationDeg = {-16.0, 34.0},
                                     .boughBend = 0.16,
                                     .twigsPerBough = 0,
                                     .twigSpreadDeg = 0.0,
                                     .cardsPerTwig = 10,
                                     .cardM = {1.1, 1.6},
                                     .cardWidth = 0.80,
                                     .cardHang = 0.42,
                                     .flatCards = true,
                                     .bark = Painting::pineBark,
                                     .leaves = Painting::spruceNeedles,
                                     .barkRepeats = {2.0, 0.7},
                                     .leafTint = {1.0F, 1.0F, 1.0F}},
                            TreeForm{.heightM = {1.8, 3.4},
                                     .crownFrom = {0.05, 0.10},
                                     .crownRadius = {0.52, 0.66},
                                     .trunkRadius = 0.020,
                                     .trunkTo = 0.85,
                                     .trunkWander = 0.06,
                                     .stems = 5,
                                     .profile = dome,
                                     .boughs = 30,
                                     .boughElevationDeg = {15.0, 75.0},
                                     .boughBend = 0.12,
                                     .twigsPerBough = 4,
                                     .twigSpreadDeg = 45.0,
                                     .cardsPerTwig = 6,
                                     .cardM = {0.42, 0.68},
                                     .cardWidth = 0.95,
                                     .cardHang = 0.0,
                                     .flatCards = false,
                                     .bark = Painting::oakBark,
                                     .leaves = Painting::bushLeaves,
                                     .barkRepeats = {1.0, 2.0},
                                     .leafTint = {0.95F, 0.94F, 0.90F}}};

} // namespace

const TreeForm& treeForm(TreeKind kind)
{
    return kForms[static_cast<std::size_t>(kind)];
}

} // namespace scenery::models
