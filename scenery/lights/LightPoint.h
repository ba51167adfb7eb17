// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include <glm/vec3.hpp>

#include "scenery/lights/Beam.h"

namespace scenery
{

/// What one switch dims.
enum class LightGroup
{
    steady, ///< always in full
    runway, ///< edges, thresholds and ends
    centreLine,
    touchdownZone,
    approach,
    papi,
    taxiway,
    beacon,
    obstacle,
    street,
    window,  ///< its flashes are times of the day, and its light points fade near by, where panes are drawn
    vehicle, ///< of cars and aircraft; near by, where a glow is drawn, they fade
};
inline constexpr int kLightGroups = static_cast<int>(LightGroup::vehicle) + 1;

/// The shares of full intensity of all groups.
using LightLevels = std::array<float, kLightGroups>;

/// When a light shines: for `litS` from `startS` on, once in each period. Period 0: always. Seconds.
struct Flash
{
    double periodS = 0.0, startS = 0.0, litS = 0.0;

    bool operator==(const Flash&) const = default;
};

/// The second colour of a light that tells angles: seen below an angle above the horizon.
struct ColourBelow
{
    glm::vec3 colour{0.0F};
    double angleDeg = 3.0;
};

/// The width of the change between both colours, in degrees: 2.5 minutes of arc. Source: ICAO, *Annex 14*,
/// volume I, 5.3.5.31: at most three.
inline constexpr double kColourChangeDeg = 2.5 / 60.0;

/// A lamp as far eyes see it. Frame: of the scene, or of the vehicle that bears it. Units: metres, candela.
struct LightPoint
{
    glm::dvec3 place{0.0};
    glm::vec3 colour{1.0F};  ///< linear; its largest part is 1
    double candela = 100.0;  ///< greatest intensity
    double headingDeg = 0.0; ///< of the beam's axis, counter-clockwise from x
    double tiltDeg = 0.0;    ///< of the axis above the horizon
    BeamKind beam = BeamKind::everywhere;
    LightGroup group = LightGroup::steady;
    Flash flash{};
    std::optional<ColourBelow> below{};
};

/// Whether a light is within the lit part of its period.
bool isLit(const Flash& flash, double timeS);

/// Returns the intensity towards an eye, in candela: by beam and flash, without steps.
double candelaTowards(const LightPoint& light, const glm::dvec3& eye, double timeS);

/// Returns the colour towards an eye.
glm::vec3 colourTowards(const LightPoint& light, const glm::dvec3& eye);

} // namespace scenery
