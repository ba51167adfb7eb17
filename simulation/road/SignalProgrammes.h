// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/road/RoadScene.h"
#include "simulation/scenario/TrafficSignals.h"

namespace simulation
{

/// Returns what the dynamic traffic lights of a network do where nobody else controls them: a controller for
/// each junction that has some, and for each place between junctions. Their phases have the words red,
/// attention (red and amber), green and yellow.
/// Those who come to a junction from opposite sides have green together, and so have all whose lanes do not
/// meet; each such stage has the same green. Yellow is 3 s up to 50 km/h, 4 s up to 60, else 5 s; red and
/// amber 1 s. Between two stages lies what the last one needs to clear the lanes of the next, in whole
/// seconds. The cycle is 60 s for two stages, 15 s more for each other one, 90 s at most, more where that
/// leaves less than 10 s of green. Where there is one stage alone, people on foot have the other one.
/// Lights for people on foot are green in the stages in which nobody has green who comes over the road that
/// they cross, or drives straight into it; they are red so early that the last one has crossed at 1.2 m/s
/// when the next stage begins.
/// Controllers of the network do not say which lights go together: programs write all lights of a junction
/// into one of them. But junctions that name the same one have one programme.
/// Source: Allgemeine Verwaltungsvorschrift zur Straßenverkehrs-Ordnung, § 37, IX (yellow, red and amber);
/// FGSV, *Richtlinien für Lichtsignalanlagen*, 2015 (times between greens: a vehicle crosses the line up to
/// 3 s after green, 2 s where it turns, and clears at 10 m/s, at 7 m/s where it turns; the next one comes at
/// 40 km/h). Greens and cycle: chosen.
std::vector<TrafficSignalController> signalProgrammes(const RoadScene& roads);

} // namespace simulation
