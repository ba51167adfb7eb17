// SPDX-License-Identifier: Apache-2.0
#include "scenery/lights/PapiUnits.h"

#include <array>
#include <cmath>

#include <glm/glm.hpp>

namespace scenery
{

namespace
{

constexpr double kFromEdgeM = 15.0, kApartM = 9.0, kAheadM = 0.6, kPapiLampM = 0.5, kCandela = 15000.0;
constexpr std::array<double, 4> kAnglesDeg{3.5, 3.0 + 1.0 / 6.0, 2.0 + 5.0 / 6.0,
                                           2.5}; ///< from the innermost

} // namespace

std::vector<PapiUnit> papiUnits(const glm::dvec2& threshold, const glm::dvec2& landing, double lengthM,
                                double widthM)
{
    const double aheadM = lengthM < 800.0    ? 150.0
                          : lengthM < 1200.0 ? 250.0
                          : lengthM < 2400.0 ? 300.0
                                             : 400.0;
    const glm::dvec2 left(-landing.y, landing.x);
    std::vector<PapiUnit> units;
    for (std::size_t i = 0; i < kAnglesDeg.size(); ++i)
    {
        const double outM = 0.5 * widthM + kFromEdgeM + kApartM * static_cast<double>(i);
        units.push_back({{threshold + aheadM * landing + outM * left, 0.0}, -landing, kAnglesDeg[i]});
    }
    return units;
}

LightPoint lampOf(const PapiUnit& unit)
{
    LightPoint lamp;
    lamp.place = unit.place + glm::dvec3(kAheadM * unit.towards, kPapiLampM);
    lamp.colour = {1.0F, 0.94F, 0.84F};
    lamp.candela = kCandela;
    lamp.headingDeg = glm::degrees(std::atan2(unit.towards.y, unit.towards.x));
    lamp.tiltDeg = unit.angleDeg;
    lamp.beam = BeamKind::papi;
    lamp.group = LightGroup::papi;
    lamp.below = ColourBelow{{1.0F, 0.04F, 0.02F}, unit.angleDeg};
    return lamp;
}

} // namespace scenery
