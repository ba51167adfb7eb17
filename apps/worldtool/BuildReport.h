// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "worldmaking/earth/Airfields.h"
#include "worldmaking/earth/WaterWorks.h"
#include "worldmaking/land/Houses.h"
#include "worldmaking/land/LandUse.h"
#include "worldmaking/land/Structures.h"
#include "worldmaking/land/Trees.h"
#include "worldmaking/madeup/MadeUpMap.h"
#include "worldmaking/streets/BuildStreets.h"

namespace worldtool
{

/// The counts of a world's parts, as docs/reference/json-tables.md has them.
nlohmann::ordered_json rowOf(const worldmaking::StreetReport& report);
nlohmann::ordered_json rowOf(const worldmaking::HouseReport& report);
nlohmann::ordered_json rowOf(const worldmaking::LandReport& report, std::size_t unusedRunways);
nlohmann::ordered_json rowOf(const worldmaking::TreeReport& report);
nlohmann::ordered_json rowOf(const worldmaking::MadeUpReport& report);
nlohmann::ordered_json rowOf(const worldmaking::WaterReport& report);
nlohmann::ordered_json rowOf(const worldmaking::AirfieldReport& report);
nlohmann::ordered_json rowOf(const worldmaking::StructureReport& report);

/// Returns a line for each part of a report, of the counts that are not 0, and one for each of its notes.
std::string summaryOf(const nlohmann::ordered_json& report);

} // namespace worldtool
