// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <glm/glm.hpp>
#include <glm/trigonometric.hpp>

#include "measurement/light/view/DrawnFigures.h"
#include "measurement/light/view/LampPictures.h"
#include "scenery/nodes/EntityLamps.h"

namespace measurement
{

using scenery::LightGroup;
using scenery::LightPoint;

namespace
{

using Pictures = foundation::Result<std::unique_ptr<LampPictures>>;

Pictures picturesOf(const LightPoint& lamp, const Spoiler& spoil)
{
    Pictures made = LampPictures::create({lamp});
    if (made) (*made)->spoilBy(spoil);
    return made;
}

using LampKind = scenery::models::EntityLamp::Kind;

LightPoint entityLamp(LampKind kind)
{
    scenery::models::EntityLamp lamp;
    lamp.kind = kind;
    lamp.looksAhead = kind != LampKind::navigationWhite;
    return scenery::lightPointOf(lamp);
}

/// The largest deviation of ranges that pictures show, a lamp of each intensity and threshold; a share.
foundation::Result<double> worstDrawnRange(const Spoiler& spoil)
{
    double worst = 0.0;
    for (const KnownRange& known :
         {KnownRange{1000, kNightLx, 1.5, 2.61}, KnownRange{1000, kNightLx, 50, 19.6},
          KnownRange{10000, kNightLx, 5, 8.57}, KnownRange{10000, 1e-5, 10, 8.65},
          KnownRange{20000, 1e-4, 50, 10.4}})
    {
        LightPoint lamp;
        lamp.candela = known.candela;
        const Pictures pictures = picturesOf(lamp, spoil);
        if (!pictures) return pictures.error();
        const double rangeM = rangeInPictureM(**pictures, 1000.0 * known.visibilityKm, known.leastLx);
        worst = std::max(worst, std::abs(rangeM / (1000.0 * known.rangeKm) - 1.0));
    }
    return worst;
}

/// What lamps do from pixel to pixel and from step to step.
struct Flux
{
    double places = 0.0; ///< the largest deviation from the mean over 64 places in a pixel, a share
    double steps = 0.0;  ///< the largest deviation of a step's light, a share
    int lit = 0;         ///< pixels that are not black though no lamp shines there
};

foundation::Result<Flux> drawnFlux(const LampParts& parts, const Spoiler& spoil)
{
    LightPoint lamp;
    lamp.candela = 700.0;
    lamp.group = LightGroup::approach;
    const Pictures pictures = picturesOf(lamp, spoil);
    if (!pictures) return pictures.error();
    Flux flux;
    const auto [least, most] =
        spreadOverPlaces(**pictures, [](const osg::Image& image) { return lightIn(image); });
    flux.places = std::max(1.0 - least, most - 1.0);
    LampSight sight;
    sight.visibilityM = 1e7;
    const auto lightOfStep = [&](int step)
    {
        sight.levels[static_cast<std::size_t>(lamp.group)] =
            static_cast<float>(parts.shareOfStep(lamp.group, step));
        return lightIn(*(*pictures)->picture(sight));
    };
    // A quarter of the light from half of the way is the same.
    sight.eye = {-1500.0, 0.0, 0.0};
    const double full = lightOfStep(5);
    sight.eye = {-750.0, 0.0, 0.0};
    flux.steps = std::abs(lightOfStep(4) / full - 1.0);
    sight.eye = {-1000.0, 0.0, 0.0};
    const auto countLit = [&](const osg::Image& image, int fromMiddlePx)
    {
        for (int y = 0; y < image.t(); ++y)
            for (int x = 0; x < image.s(); ++x)
            {
                const bool isBeside =
                    std::max(std::abs(2 * x - image.s()), std::abs(2 * y - image.t())) >= 2 * fromMiddlePx;
                const unsigned char* const pixel =
                    image.data(static_cast<unsigned>(x), static_cast<unsigned>(y));
                flux.lit += isBeside && pixel[0] + pixel[1] + pixel[2] > 0;
            }
    };
    constexpr int kSpreadPx = 8;
    static_cast<void>(lightOfStep(0));
    countLit(*(*pictures)->picture(sight), 0);
    static_cast<void>(lightOfStep(5));
    countLit(*(*pictures)->picture(sight), kSpreadPx);
    return flux;
}

/// The largest deviation of a drawn position lamp from the sectors of 14 CFR 23.1391, a share: against a lamp
/// of that intensity that shines everywhere.
foundation::Result<double> worstDrawnSector(const LampParts& parts, const Spoiler& spoil)
{
    struct Look
    {
        const LightPoint* lamp;
        double deg, candela;
    };
    const PositionLamps& lamps = parts.position;
    double worst = 0.0;
    for (const Look& look :
         {Look{&lamps.left, 5, 40}, Look{&lamps.left, 15, 30}, Look{&lamps.left, 60, 5},
          Look{&lamps.left, 105, 5}, Look{&lamps.right, -5, 40}, Look{&lamps.right, -15, 30},
          Look{&lamps.right, -60, 5}, Look{&lamps.rear, 120, 20}, Look{&lamps.rear, 180, 20},
          Look{&lamps.rear, -120, 20}})
    {
        LightPoint lamp = *look.lamp, plain;
        lamp.place = plain.place = glm::dvec3(0.0);
        plain.colour = lamp.colour;
        plain.group = lamp.group;
        plain.candela = look.candela;
        constexpr double kAwayM = 400.0, kTimesSeen = 600.0; // bright enough for 8-bit levels
        LampSight sight;
        sight.leastLx = look.candela / (kAwayM * kAwayM) / kTimesSeen;
        const double a = glm::radians(look.deg);
        sight.eye = kAwayM * glm::dvec3(std::cos(a), std::sin(a), 0.0);
        const int channel = lamp.colour.y > lamp.colour.x ? 1 : 0;
        double light[2];
        for (const LightPoint* const one : {&lamp, &plain})
        {
            const Pictures pictures = picturesOf(*one, spoil);
            if (!pictures) return pictures.error();
            light[one == &lamp ? 0 : 1] = lightIn(*(*pictures)->picture(sight), channel);
        }
        worst = std::max(worst, std::abs(light[0] / light[1] - 1.0));
    }
    return worst;
}

/// The worst of four units: width of the change and deviation from where it has to be, minutes of arc.
foundation::Result<ColourChange> worstPapi(const LampParts& parts, const Spoiler& spoil)
{
    constexpr std::array<double, 4> kMinutes{210.0, 190.0, 170.0, 150.0};
    const auto units = parts.papi({0.0, 0.0}, {1.0, 0.0}, 1500.0, 30.0);
    if (units.size() != kMinutes.size()) return ColourChange{std::nan(""), std::nan("")};
    ColourChange worst;
    for (std::size_t i = 0; i < units.size(); ++i)
    {
        LightPoint lamp = scenery::lampOf(units[i]);
        lamp.place = glm::dvec3(0.0);
        const Pictures pictures = picturesOf(lamp, spoil);
        if (!pictures) return pictures.error();
        const ColourChange change = colourChange(**pictures, kMinutes[i] / 60.0);
        worst.widthDeg = std::max(worst.widthDeg, 60.0 * change.widthDeg);
        worst.middleDeg = std::max(worst.middleDeg, std::abs(60.0 * change.middleDeg - kMinutes[i]));
    }
    return worst;
}

} // namespace

PositionLamps drawnPositionLamps()
{
    return {entityLamp(LampKind::navigationRed), entityLamp(LampKind::navigationGreen),
            entityLamp(LampKind::navigationWhite)};
}

LightPoint drawnLowBeam()
{
    return entityLamp(LampKind::head);
}

foundation::Result<LightFigures> drawnLampFigures(const LampParts& parts, const Spoiler& spoil)
{
    const auto range = worstDrawnRange(spoil);
    if (!range) return range.error();
    const auto flux = drawnFlux(parts, spoil);
    if (!flux) return flux.error();
    const auto sector = worstDrawnSector(parts, spoil);
    if (!sector) return sector.error();
    const auto papi = worstPapi(parts, spoil);
    if (!papi) return papi.error();
    return LightFigures{
        atMost("N4", "lamps in pictures: range, worst of 5", kPercent * *range, "%", 3.0,
               "Allard 1876; thresholds of ICAO Annex 3, attachment D"),
        atMost("N4", "lamps in pictures: light over 64 places in a pixel", kPercent * flux->places, "%", 2.0,
               "goal of this project"),
        atMost("N4", "lamps in pictures: light of step 4 over that of 5", kPercent * flux->steps, "%", 2.0,
               "ICAO Doc 9157, part 4"),
        atMost("N4", "lamps in pictures: pixels beside them that are not black", flux->lit, "", 0.0,
               "FAA bulletin FSTD 06-02"),
        atMost("N4", "position lamps in pictures: sectors", kPercent * *sector, "%", 5.0, "14 CFR 23.1391"),
        atMost("N4", "PAPI in pictures: width of the change", papi->widthDeg, "'", 3.0,
               "ICAO Annex 14, 5.3.5.31"),
        atMost("N4", "PAPI in pictures: angle of the change", papi->middleDeg, "'", 0.5,
               "ICAO Annex 14, 5.3.5")};
}

} // namespace measurement
