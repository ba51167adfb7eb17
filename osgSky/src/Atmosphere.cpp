// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <osg/Math>
#include <osg/Notify>
#include <osg/Uniform>
#include <osgSky/Atmosphere>
#include <osgSky/MixedColour>

#include <shaders/osgSky.h>

#include "SunThroughAir.h"

namespace osgSky
{

namespace
{

/// The sky of clear air at one height of the sun.
struct SkyKey
{
    double elevationDeg;
    osg::Vec3f zenith, horizon, glow;
};

/// Sunlight above the air. With it, level ground under a sun of 60 degrees is lit in white, as a camera that
/// is set to daylight shows it: warm by the sun, blue by the sky.
const osg::Vec3f kSunAboveAir(2.36f, 2.29f, 2.20f);
/// Haze thins out over this height by 1/e; the sun's light comes through as much as if it were even up to it.
/// Source: Elterman, UV, visible, and IR attenuation for altitudes to 50 km (1968): aerosols by 1.2 km.
constexpr float kHazeLayerM = 1200.0f;
/// What the ground reflects: grass and soil.
const osg::Vec3f kGroundAlbedo(0.150f, 0.150f, 0.105f);

// Chosen by eye against photographs: blue by day, warm at the horizon, steel-blue dusk, dark but not black
// night.
constexpr int kKeys = 8;
const std::array<SkyKey, kKeys>& skyKeys()
{
    static const std::array<SkyKey, kKeys> keys{{
        {-18.0, {0.002f, 0.003f, 0.007f}, {0.003f, 0.004f, 0.008f}, {0.0f, 0.0f, 0.0f}},
        {-8.0, {0.010f, 0.017f, 0.040f}, {0.030f, 0.036f, 0.055f}, {0.04f, 0.02f, 0.02f}},
        {-3.0, {0.035f, 0.058f, 0.120f}, {0.130f, 0.120f, 0.140f}, {0.35f, 0.15f, 0.08f}},
        {0.0, {0.060f, 0.100f, 0.210f}, {0.270f, 0.230f, 0.230f}, {0.95f, 0.45f, 0.18f}},
        {5.0, {0.080f, 0.150f, 0.320f}, {0.420f, 0.420f, 0.450f}, {1.10f, 0.72f, 0.38f}},
        {15.0, {0.090f, 0.190f, 0.420f}, {0.480f, 0.560f, 0.670f}, {1.00f, 0.88f, 0.68f}},
        {35.0, {0.095f, 0.215f, 0.490f}, {0.510f, 0.640f, 0.800f}, {0.90f, 0.88f, 0.80f}},
        {90.0, {0.100f, 0.225f, 0.510f}, {0.520f, 0.660f, 0.830f}, {0.90f, 0.90f, 0.85f}},
    }};
    return keys;
}

SkyKey keyAt(double elevationDeg)
{
    const auto& keys = skyKeys();
    const double e = std::clamp(elevationDeg, keys.front().elevationDeg, keys.back().elevationDeg);
    int i = 0;
    while (i < kKeys - 2 && e > keys[i + 1].elevationDeg)
        ++i;
    const float t =
        static_cast<float>((e - keys[i].elevationDeg) / (keys[i + 1].elevationDeg - keys[i].elevationDeg));
    return {e, mixed(keys[i].zenith, keys[i + 1].zenith, t), mixed(keys[i].horizon, keys[i + 1].horizon, t),
            mixed(keys[i].glow, keys[i + 1].glow, t)};
}

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

AtmosphereLight atmosphereLight(const AtmosphereSettings& settings)
{
    osg::Vec3d direction = settings.sunDirectionWorld;
    if (direction.normalize() == 0.0) direction.set(0.0, 0.0, 1.0);
    const double elevationDeg = osg::RadiansToDegrees(std::asin(std::clamp(direction.z(), -1.0, 1.0)));
    const SkyKey key = keyAt(elevationDeg);
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
    // Brighter than it measures: a pilot's eyes get used to the dark, and a picture's exposure does not.
    const float moon = static_cast<float>(std::clamp((-2.0 - elevationDeg) / 8.0, 0.0, 1.0) *
                                          std::clamp(settings.moonlight, 0.0, 1.0) * (1.0 - 0.8 * cloud));
    light.sky += osg::Vec3f(0.050f, 0.062f, 0.088f) * moon;
    const osg::Vec3f level = light.sun * static_cast<float>(std::max(direction.z(), 0.0)) + light.sky;
    light.ground = osg::componentMultiply(level, kGroundAlbedo);
    light.exposure = exposureOf(luminance(level));
    return light;
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
    _light = atmosphereLight(_settings);
    osg::Vec3f direction(_settings.sunDirectionWorld);
    if (direction.normalize() == 0.0f) direction.set(0.0f, 0.0f, 1.0f);
    const auto set = [this](const char* name, const osg::Vec3f& value)
    { _stateSet->getOrCreateUniform(name, osg::Uniform::FLOAT_VEC3)->set(value); };
    set("atmosphereSunDirection", direction);
    set("atmosphereSun", _light.sun);
    set("atmosphereSky", _light.sky);
    set("atmosphereGround", _light.ground);
    set("atmosphereZenith", _light.zenith);
    set("atmosphereHorizon", _light.horizon);
    set("atmosphereGlow", _light.glow);
    set("atmosphereExtinction", _light.extinction);
    _stateSet->getOrCreateUniform("atmosphereExposure", osg::Uniform::FLOAT)->set(_light.exposure);
    _stateSet->getOrCreateUniform("atmosphereLayer", osg::Uniform::FLOAT_VEC2)
        ->set(osg::Vec2f(static_cast<float>(_settings.hazeBaseM), 1.0f / _light.hazeScaleHeightM));
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
