// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "scenery/models/cockpit/Readings.h"

namespace scenery::models
{

/// A value and where it stands on a dial. Angles clockwise from the top, degrees.
struct DialPoint
{
    double value = 0.0, angleDeg = 0.0;
};

/// What a hand does with its reading.
enum class DialMotion
{
    scale, ///< goes between the points of its scale, and stays at its ends
    round, ///< goes round once while the reading grows by the second point's value
};

/// A pointer, or a part of the dial that turns as one.
struct DialHand
{
    enum class Shape
    {
        needle,
        card,      ///< the face itself turns
        aeroplane, ///< seen from behind, as in a turn coordinator
        ball,      ///< in a bent tube below the middle
    };
    Reading reading = Reading::airspeedKt;
    std::vector<DialPoint> scale; ///< ascending; at least two
    DialMotion motion = DialMotion::scale;
    Shape shape = Shape::needle;
    double reach = 0.78, width = 0.07; ///< shares of the dial's radius
};

/// Returns where a hand stands, clockwise from the top; at the nearer end for a value outside, at the first
/// for none. Units: degrees.
double handAngleDeg(const DialHand& hand, double value);

/// A coloured arc of a scale.
struct DialArc
{
    double from = 0.0, to = 0.0;
    glm::vec3 colour{1.0F};
};

/// A round instrument: its face by the scale of its first hand, and its hands from the lowest to the
/// uppermost.
struct Dial
{
    std::string_view label;
    std::vector<DialHand> hands;
    double minorStep = 1.0, majorStep = 1.0, numberStep = 1.0; ///< 0: none
    double numberDivisor = 1.0;
    std::vector<DialArc> arcs{};
    std::string_view ends{}; ///< letters at the ends of a scale without numbers: "EF"
};

} // namespace scenery::models
