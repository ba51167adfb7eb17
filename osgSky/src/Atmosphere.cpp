// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>

#include <foundation/Daylight.h>
#include <glm/common.hpp>

#include <osg/Math>
#include <osg/Notify>
#include <osg/Uniform>
#include <osgSky/Atmosphere>
#include <osgSky/MixedColour>

#include <shaders/osgSky.h>

#include "SkyKeys.h"
#include "SunThroughAir.h"

namespace osgSky
{

namespace
{

/// Sunlight above the air. With it, level ground under a sun of 60 degrees is lit in white, as a camera that
/// is set to daylight shows it: warm by the sun, blue by the sky.
const osg::Vec3f kSunAboveAir(2.36f, 2.29f, 2.20f);
/// Haze thins out over this height by 1/e; the sun's light comes through as much as if it were even up to it.
/// Source: Elterman, UV, visible, and IR attenuation for altitudes to 50 km (1968): aerosols by 1.2 km.
constexpr float kHazeLayerM = 1200.0f;
/// What the ground reflects: grass and soil.
const osg::Vec3f kGroundAlbedo(0.150f, 0.150f, 0.105f);
/// What level ground gets of the glow about a low sun, which the colours of the sky leave out.
constexpr float kGlowOnGround = 0.12f;
/// Level ground under a full moon, high up. Source: Brown, *Natural illumination charts* (1952).
constexpr double kFullMoonLx = 0.108;

float luminance(const osg::Vec3f& c)
{
    return 0.30f * c.x() + 0.59f * c.y() + 0.11f * c.z();
}

osg::Vec3f grey(float value)
{
    return {value, value, value};
}

} // namespace

osg::Vec3d sunDirectionFromAngles(double azimuthDeg, double elevationDeg)
{
    const double azimuth = osg::DegreesToRadians(azimuthDeg);
    const double elevation = osg::DegreesToRadians(elevationDeg);
    return {std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation),
            std::sin(elevation)};
}

namespace
{

osg::Vec3d unitSun(const AtmosphereSettings& settings)
{
    osg::Vec3d direction = settings.sunDirectionWorld;
    if (direction.normalize() == 0.0) direction.set(0.0, 0.0, 1.0);
    return direction;
}

double elevationDegOf(const osg::Vec3d& direction)
{
    return osg::RadiansToDegrees(std::asin(std::clamp(direction.z(), -1.0, 1.0)));
}

/// 1 up to 5 degrees, 0 from 15 on, steadily between.
double lowSunShare(double elevationDeg)
{
    constexpr double kLowDeg = 5.0, kHighDeg = 15.0;
    return 1.0 - glm::smoothstep(kLowDeg, kHighDeg, elevationDeg);
}

/// What sun and sky give to level ground.
osg::Vec3f levelLight(const AtmosphereLight& light, const osg::Vec3d& towardsSun)
{
    return light.sun * static_cast<float>(std::max(towardsSun.z(), 0.0)) + light.sky;
}

/// The light as it is shown: of a sun up to 15 degrees more than in nature. Its exposure is that of eyes used
/// to the day.
AtmosphereLight shownLight(const AtmosphereSettings& settings)
{
    const osg::Vec3d direction = unitSun(settings);
    const double elevationDeg = elevationDegOf(direction);
    const SkyKey key = skyAt(elevationDeg);
    const float cloud = static_cast<float>(std::clamp(settings.cloudCover, 0.0, 1.0));

    AtmosphereLight light;
    // -ln(0.05) over the visibility; shorter waves are scattered more, which makes distant hills blue.
    const double green = 2.995732 / std::max(settings.visibilityM, 1.0);
    // In dense fog (large drops) all waves fare alike.
    const float blueness = static_cast<float>(std::clamp((settings.visibilityM - 1000.0) / 9000.0, 0.0, 1.0));
    light.extinction = mixed({1.0f, 1.0f, 1.0f}, {0.82f, 1.0f, 1.30f}, blueness) * static_cast<float>(green);

    // Haze thins out with height; fog fills the valleys up to any height the eye is at.
    light.hazeScaleHeightM =
        static_cast<float>(kHazeLayerM / std::clamp((settings.visibilityM - 2000.0) / 18000.0, 1e-5, 1.0));

    const float clear = static_cast<float>(std::exp(-green * kHazeLayerM));
    const float direct = (1.0f - 0.92f * cloud) * static_cast<float>(settings.sunIntensity);
    const osg::Vec3f through = sunThroughAir(elevationDeg, light.extinction * kHazeLayerM);
    light.sun = direction.z() > -0.02 ? osg::componentMultiply(kSunAboveAir, through) * direct : osg::Vec3f();
    light.glow = key.glow * (clear * (1.0f - 0.9f * cloud));

    const osg::Vec3f overcast = mixed(grey(0.62f * luminance(key.horizon)), key.horizon * 0.62f, 0.25f);
    const osg::Vec3f fog =
        settings.fogColour.value_or(mixed(grey(luminance(key.horizon)), key.horizon, 0.3f));
    light.zenith = mixed(fog, mixed(key.zenith, overcast * 0.9f, cloud), clear);
    light.horizon = mixed(fog, mixed(key.horizon, overcast, cloud), clear);
    light.sky = light.zenith * 0.65f + light.horizon * 0.25f;
    // The bright side of a twilit sky. The ground gets little of its colour: red air is only near the sun.
    const auto twilight = static_cast<float>(lowSunShare(elevationDeg));
    light.sky += mixed(grey(luminance(light.glow)), light.glow, 0.3f) * (kGlowOnGround * twilight);
    // Brighter than it measures: a pilot's eyes get used to the dark, and a picture's exposure does not.
    const float moon = static_cast<float>(std::clamp((-2.0 - elevationDeg) / 8.0, 0.0, 1.0) *
                                          std::clamp(settings.moonlight, 0.0, 1.0) * (1.0 - 0.8 * cloud));
    light.sky += osg::Vec3f(0.050f, 0.062f, 0.088f) * moon;
    const osg::Vec3f level = levelLight(light, direction);
    light.ground = osg::componentMultiply(level, kGroundAlbedo);
    light.exposure = exposureOf(luminance(level));
    return light;
}

/// How much more light is shown than there is, in clear air: 1 with the sun at 15 degrees and higher.
float adaptationTo(const AtmosphereSettings& settings)
{
    const double elevationDeg = elevationDegOf(unitSun(settings));
    const double share = lowSunShare(elevationDeg);
    if (share == 0.0) return 1.0f;
    AtmosphereSettings clear;
    clear.sunDirectionWorld = settings.sunDirectionWorld;
    clear.moonlight = settings.moonlight;
    constexpr double kNoonDeg = 60.0, kShownAtNoon = 1.93;
    const double shown = luminance(levelLight(shownLight(clear), unitSun(clear))) / kShownAtNoon;
    const double natural =
        (foundation::daylightLx(elevationDeg) + kFullMoonLx * std::clamp(settings.moonlight, 0.0, 1.0)) /
        foundation::daylightLx(kNoonDeg);
    return static_cast<float>(std::max(std::pow(shown / natural, share), 1.0));
}

/// The light as it is in nature, of the light that is shown for the same settings.
AtmosphereLight naturalLight(AtmosphereLight light, const AtmosphereSettings& settings)
{
    light.adaptation = adaptationTo(settings);
    for (osg::Vec3f* const part :
         {&light.sun, &light.sky, &light.ground, &light.zenith, &light.horizon, &light.glow})
        *part /= light.adaptation;
    light.exposure *= light.adaptation;
    // At this adaptation the light that is drawn for lamps is what they give.
    constexpr float kLampsAdaptation = 1e4f;
    light.lampShare = std::min(light.adaptation / kLampsAdaptation, 1.0f);
    return light;
}

} // namespace

AtmosphereLight atmosphereLight(const AtmosphereSettings& settings)
{
    return naturalLight(shownLight(settings), settings);
}

Atmosphere::Atmosphere(const AtmosphereSettings& settings) : _stateSet(new osg::StateSet)
{
    _stateSet->setDataVariance(osg::Object::DYNAMIC);
    if (const foundation::Outcome set = setSettings(settings); !set)
    {
        OSG_WARN << set.error().message() << '\n';
        update();
    }
}

foundation::Outcome Atmosphere::setSettings(const AtmosphereSettings& settings)
{
    foundation::Outcome checked = checkSettings(settings);
    if (!checked) return checked;
    _settings = settings;
    update();
    return checked;
}

/// Sets the uniforms from the settings.
void Atmosphere::update()
{
    // Shaders have what is shown: numbers of a like size by day and night.
    const AtmosphereLight shown = shownLight(_settings);
    _light = naturalLight(shown, _settings);
    osg::Vec3f direction(_settings.sunDirectionWorld);
    if (direction.normalize() == 0.0f) direction.set(0.0f, 0.0f, 1.0f);
    const auto set = [this](const char* name, const osg::Vec3f& value)
    { _stateSet->getOrCreateUniform(name, osg::Uniform::FLOAT_VEC3)->set(value); };
    set("atmosphereSunDirection", direction);
    set("atmosphereSun", shown.sun);
    set("atmosphereSky", shown.sky);
    set("atmosphereGround", shown.ground);
    set("atmosphereZenith", shown.zenith);
    set("atmosphereHorizon", shown.horizon);
    set("atmosphereGlow", shown.glow);
    set("atmosphereExtinction", shown.extinction);
    _stateSet->getOrCreateUniform("atmosphereExposure", osg::Uniform::FLOAT)->set(shown.exposure);
    _stateSet->getOrCreateUniform("atmosphereLampShare", osg::Uniform::FLOAT)->set(_light.lampShare);
    _stateSet->getOrCreateUniform("atmosphereLayer", osg::Uniform::FLOAT_VEC2)
        ->set(osg::Vec2f(static_cast<float>(_settings.hazeBaseM), 1.0f / shown.hazeScaleHeightM));
}

void Atmosphere::addUniformsTo(osg::StateSet& stateSet) const
{
    for (const auto& [name, entry] : _stateSet->getUniformList())
        stateSet.addUniform(entry.first.get(), entry.second);
    stateSet.setDataVariance(osg::Object::DYNAMIC);
}

void Atmosphere::applyTo(osg::Light& light) const
{
    const osg::Vec3d direction = _settings.sunDirectionWorld;
    light.setPosition(osg::Vec4(osg::Vec3f(direction), 0.0f));
    light.setAmbient(osg::Vec4f(displayColour(_light.sky * 0.5f, _light.exposure), 1.0f));
    light.setDiffuse(osg::Vec4f(displayColour(_light.sun * 0.6f, _light.exposure), 1.0f));
    light.setSpecular(osg::Vec4f(displayColour(_light.sun * 0.6f, _light.exposure), 1.0f));
}

const char* Atmosphere::glslFunctions()
{
    static const std::string functions = std::string(shaders::kAtmosphere) + shaders::kSurfaceWeather +
                                         shaders::kHeadLamps + shaders::kSunShadows;
    return functions.c_str();
}

} // namespace osgSky
