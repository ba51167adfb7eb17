// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <osgRoads/core/place/PlacedNetwork.h>

namespace osgRoads::core
{

/// A painted shape: a trapezoid in the plan view, solid or of stripes across its length. All that is painted
/// besides the marks along borders is made of these. Frame: the scene's. Units: metres.
struct Decal
{
    glm::dvec3 start{0.0};      ///< the middle of its first side; z: of the road there
    glm::dvec2 along{1.0, 0.0}; ///< unit vector
    double length = 0.0;        ///< along it
    double widthStart = 0.0,
           widthEnd = 0.0; ///< of the first and the last side, which stand at right angles to `along`
    double shift = 0.0;    ///< of the middle of the last side, to the left
    double dash = 0.0, period = 0.0;      ///< length of a stripe, and from one to the next; 0: solid
    double phase = 0.0;                   ///< of the pattern at `start`
    glm::vec3 paint{0.72F, 0.72F, 0.70F}; ///< linear reflectance

    /// Returns its corners in the plan view, counter-clockwise from the right one of its first side.
    std::array<glm::dvec2, 4> corners() const
    {
        const glm::dvec2 left(-along.y, along.x), from(start), to = from + along * length + left * shift;
        return {from - left * (0.5 * widthStart), to - left * (0.5 * widthEnd), to + left * (0.5 * widthEnd),
                from + left * (0.5 * widthStart)};
    }
};

/// Returns all that signals, objects and explicit lines of marks paint on the roads of a network: stop lines,
/// crosswalks, arrows, parking spaces, areas. Stop lines lie on the lanes of their <validity>, else they are
/// as wide as told and never reach over the reference line into the other direction. Crosswalks have stripes
/// along the road of 0.5 m. Of a parking space the side towards the road's middle is open.
/// Source: ASAM OpenDRIVE 1.8, 11.9.3 (explicit), 13, 14. Sizes that a file does not tell: German RMS
/// (Richtlinien für die Markierung von Straßen, 1993, part 1): stop line 0.5 m, arrows 5 m.
std::vector<Decal> roadDecals(const PlacedNetwork& network);

} // namespace osgRoads::core
