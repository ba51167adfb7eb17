// SPDX-License-Identifier: Apache-2.0
#include "AreaCost.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "../../mesh/Squared.h"

namespace osgPMObjects::core
{

namespace
{

constexpr double kLostArea = 20.0; ///< weight with optimal placement, of models that are not scattered
constexpr double kThinArea = 0.3;  ///< weight with subset placement
constexpr double kScattered = 0.2; ///< parts of a scattered model are smaller, by the diagonal
constexpr double kSwelling = 0.25; ///< of models that are not scattered
constexpr double kMostSwelling = 1.0;

} // namespace

AreaCost AreaCost::forModel(const SimplifySettings& settings, double sizeOfParts, bool hasFoliage)
{
    if (settings.placement == Placement::subset)
        return {settings.placement, hasFoliage ? 0.0 : kThinArea, 0.0};
    const double scattering = squared(std::max(1.0, kScattered / std::max(sizeOfParts, 1e-3)));
    if (settings.joinDistance > 0.0 || settings.envelope > 0.0)
        return {settings.placement, kLostArea * scattering, 0.0};
    return {settings.placement, kLostArea * squared(scattering),
            std::min(kMostSwelling, kSwelling * std::sqrt(scattering))};
}

double AreaCost::of(const Star& star, double change) const
{
    switch (placement)
    {
    case Placement::subset:
        return weight * squared(thinnessOf(star) * change);
    case Placement::optimal:
        return weight * squared(change) * std::abs(change);
    case Placement::quality:
        break;
    }
    return 0.0;
}

double thinnessOf(const Star& star)
{
    glm::dvec3 sum(0.0);
    double doubleArea = 0.0;
    for (const Star::Spoked& spoked : star.faces)
    {
        sum += spoked.doubleArea * spoked.normal;
        doubleArea += spoked.doubleArea;
    }
    return doubleArea > 0.0 ? std::max(0.0, 1.0 - glm::length(sum) / doubleArea) : 0.0;
}

} // namespace osgPMObjects::core
