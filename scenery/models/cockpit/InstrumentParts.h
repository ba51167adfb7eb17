// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "scenery/models/cockpit/InteriorModel.h"
#include "scenery/models/cockpit/PaintInstruments.h"
#include "scenery/models/cockpit/Panel.h"
#include "scenery/models/mesh/ModelBuilder.h"

namespace scenery::models
{

/// How far faces and hands stand before the panel. Units: metres.
inline constexpr double kFaceLiftM = 0.002, kHandLiftM = 0.0035, kHandStepM = 0.0012;

/// The tip of a needle in its dial. Frame: the dial's, x to the right, y up, z to the eye; metres.
glm::dvec3 needleTip(const DialHand& hand, double radiusM, double value);

/// Adds the instruments of a panel. `entityFromPanel`: from x to the right, y up, z to the eye.
void addInstruments(InteriorModel& interior, std::span<const PlacedInstrument> panel,
                    const glm::dmat4& entityFromPanel);

/// A row of drums with figures behind a window. Units: metres.
struct DrumRow
{
    std::string name;
    glm::dvec3 middle{0.0}; ///< of the window, in the panel's frame
    double heightM = 0.008; ///< of the window
    int drums = 1;
    DrumColumn column = DrumColumn::digits;
    std::function<int(const Readings&)>
        number; ///< whose decimal figures they show; of gears: the figure itself
};
void addDrums(InteriorModel& interior, const DrumRow& row, const glm::dmat4& entityFromPanel);

/// Adds the ball of an attitude indicator (AttitudeBall.cpp).
void addAttitude(InteriorModel& interior, const PlacedInstrument& placed, const glm::dmat4& entityFromPanel);

/// How the ball of an attitude indicator lies. Frame: the dial's; at rest it shows its horizon level in the
/// middle.
glm::dmat4 attitudeTurn(double pitchDeg, double rollDeg);

/// The surface of the faces.
inline const Surface kInstrumentSurface{Painting::instruments, Coat::matt};

} // namespace scenery::models
