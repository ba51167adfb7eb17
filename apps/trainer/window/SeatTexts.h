// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "hud/TextOverlay.h"
#include "simulation/clock/RealTimePace.h"
#include "window/PictureTimes.h"

namespace trainer
{

/// What a window says: the last message for some seconds, then what stands until it is taken back, or the
/// pace where it is not the usual; and its statistics.
class SeatTexts
{
public:
    void tell(const std::string& text, double wallS)
    {
        _told = text;
        _toldAtS = wallS;
    }

    /// Says this whenever there is no message; empty: nothing.
    void setStanding(std::string text) { _standing = std::move(text); }

    /// Says who has the vehicle where there is nothing else to say; empty: nothing.
    void setOwner(std::string text) { _owner = std::move(text); }

    /// `phase`: what whoever controls is about. `tolerancePx`: of the terrain.
    void show(TextOverlay& overlay, double wallS, const simulation::RealTimePace& pace,
              const PictureTimes& times, double tolerancePx, std::string_view phase) const;

private:
    std::string _told, _standing, _owner;
    double _toldAtS = -1e9;
};

/// Prints how a play in a window ended.
void printEnd(const simulation::RealTimePace& pace, const PictureTimes& times);

} // namespace trainer
