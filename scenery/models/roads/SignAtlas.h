// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include <glm/vec2.hpp>

#include "scenery/models/Model.h"

namespace scenery::models
{

/// The faces of road signs, and the other cells of the texture plain. Speed limits and letters stand in
/// cells of their own. Shapes, colours and meanings: Convention on Road Signs and Signals (Vienna, 1968, with
/// the amendments of 2006), annex 1.
enum class SignFace
{
    plain,         ///< white, takes the tint: posts, frames, boxes
    back,          ///< grey metal
    stop,          ///< B 2a
    giveWay,       ///< B 1
    priority,      ///< B 3
    priorityEnd,   ///< B 4
    noEntry,       ///< C 1a
    noVehicles,    ///< C 2
    noOvertaking,  ///< C 13aa
    overtakingEnd, ///< C 17c
    allEnd,        ///< C 17a
    ahead,
    right,
    left,
    roundabout,
    keepRight, ///< D 1, D 3, D 2
    crossing,  ///< E 12a
    parking,   ///< E 14a
    motorway,  ///< E 5a
    danger,
    bendRight,
    bendLeft,
    roadWorks,
    slippery,
    pedestrians,
    lights,
    narrow,
    crossroads, ///< A
    limit,      ///< C 14 without its number
    least,      ///< D 7 without its number
    lampRed,
    lampAmber,
    lampGreen, ///< lenses that are off
    count,
};

/// Texture coordinates of a cell, slightly inside its edges.
struct SignCell
{
    glm::vec2 low, high;
};

SignCell cellOf(SignFace face);

/// The cell of a letter or digit: black on a ground that takes the tint. Others (Latin-1) than A to Z, Ä, Å,
/// É, Ö, Ü, 0 to 9 and - . / : , ( ) are blank.
SignCell cellOfGlyph(char glyph);

/// The cell of a digit or of C, L or R of a runway's designator: white on red. Others are plain.
SignCell cellOfRunwayGlyph(char glyph);

/// The cells of speed limits (5 to 140 by 5) and of least speeds (blue); others give those without a number.
SignCell cellOfLimit(int speed, bool isLeast);

constexpr int kSignColumns = 16; ///< of the atlas
constexpr int kSignRows = 8;
constexpr int kSignCellPx = 128;

/// The surface of all road furniture.
inline const Surface kPlain{Painting::plain, Coat::matt};
inline const Surface kLitPlain{Painting::plain, Coat::lit}; ///< of signs with lamps in them

} // namespace scenery::models
