// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>

#include "scenery/models/cockpit/Panel.h"
#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

/// A part of the picture `instruments`, in texture coordinates.
struct InstrumentCell
{
    glm::vec2 low{0.0F}, high{1.0F};

    /// `at`: (0, 0) in its middle, ±1 at the rim of a dial.
    glm::vec2 uvAt(const glm::vec2& at) const
    {
        return 0.5F * (low + high) + kRimShare * 0.5F * (high - low) * at;
    }

    static constexpr float kRimShare = 0.96F;
};

InstrumentCell cellOf(Instrument instrument);

/// Paints the faces of all dials, the ball of the attitude indicator and the drums, 1024 × 1024 pixels. Their
/// own colours: no tint.
Picture paintInstruments();

inline constexpr int kDrumFigures = 10;

/// The columns of the cell `digits`, each with ten figures from below: 0 to 9, and R N 1 to 8.
enum class DrumColumn
{
    digits,
    gears
};

} // namespace scenery::models
