// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "measurement/light/view/AirPictures.h"
#include "measurement/light/view/DrawnFigures.h"

namespace measurement
{

namespace
{

constexpr double kContrast = 0.05, kWithin = 0.0025;

/// Whichever is farther from what is wanted; no number wins.
double worse(double a, double b, double wanted)
{
    return std::abs(b - wanted) <= std::abs(a - wanted) ? a : b;
}

} // namespace

foundation::Result<LightFigures> drawnAirFigures(const SceneParts& scenes, const Spoiler& spoil)
{
    struct Named
    {
        SeenSurface surface;
        const char* name;
        double farthestM;
    };
    // The surface of a road is drawn up to some kilometres; farther away the ground is painted with it.
    constexpr std::array kSurfaces{Named{SeenSurface::ground, "ground, 0.1 to 50 km", 50000.0},
                                   Named{SeenSurface::road, "road, 0.1 to 1.5 km", 1500.0},
                                   Named{SeenSurface::object, "object, 0.1 to 50 km", 50000.0},
                                   Named{SeenSurface::aircraft, "aircraft, 0.1 to 50 km", 50000.0}};
    constexpr std::array kVisibilitiesM{100.0, 400.0, 1500.0, 5000.0, 15000.0, 50000.0};
    constexpr std::array kSunsDeg{45.0, -3.0, -20.0}; // day, dusk, night
    constexpr const char* kSource = "Koschmieder 1924; ICAO Annex 3: 5 % over the visibility";
    LightFigures figures;
    // By visibility and sun, of all surfaces.
    std::array<std::array<double, 2>, kVisibilitiesM.size() * kSunsDeg.size()> between;
    between.fill({1.0, 0.0});
    for (const Named& named : kSurfaces)
    {
        const auto made = AirPictures::create(named.surface);
        if (!made) return made.error();
        AirPictures& pictures = **made;
        pictures.spoilBy(spoil);
        double worst = kContrast;
        std::size_t row = 0;
        for (const double visibilityM : kVisibilitiesM)
        {
            if (visibilityM > named.farthestM) break;
            for (const double sunDeg : kSunsDeg)
            {
                const double left = pictures.contrastLeft(visibilityM, visibilityM, sunDeg);
                worst = worse(worst, left, kContrast);
                between[row] = {std::min(between[row][0], left), std::max(between[row][1], left)};
                ++row;
            }
        }
        LightFigure figure = atMost("N3", std::string("contrast at the visibility: ") + named.name, worst, "",
                                    kContrast + kWithin, kSource);
        figure.least = kContrast - kWithin;
        figures.push_back(figure);
        if (named.surface != SeenSurface::object) continue;
        for (const auto& [type, mmPerHour] : {std::pair{"rain", 50.0}, std::pair{"snow", 2.5}})
        {
            const double visibilityM = scenes.visibilityM(type, mmPerHour);
            figure.name = std::string("contrast at the visibility in ") + type + " of " +
                          (mmPerHour > 10.0 ? "50" : "2.5") + " mm/h";
            figure.value = pictures.contrastLeft(visibilityM, visibilityM, kSunsDeg[0]);
            figures.push_back(figure);
        }
    }
    double apart = 0.0;
    for (const auto& [least, most] : between)
        apart = std::max(apart, most / least - 1.0);
    figures.push_back(
        atMost("N3", "contrast: most that surfaces differ", 100.0 * apart, "%", 1.0, "one air for all"));
    return figures;
}

} // namespace measurement
