// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/json/JsonFields.h"
#include "scenery/models/vehicles/VehicleLook.h"

namespace scenery::models
{

/// Reads the member `paint` of a look: what is painted on its views.
void readLookPaint(JsonFields& root, VehicleLook& look);

/// Reads a list of three or four shares.
/// Errors: another number of them.
template<class Colour>
void readColour(const nlohmann::json& list, const std::string& place, Complaint& complaint, Colour& colour)
{
    constexpr std::size_t kParts = static_cast<std::size_t>(Colour::length());
    bool isSound = list.is_array() && list.size() == kParts;
    for (std::size_t i = 0; isSound && i < kParts; ++i)
    {
        isSound = list[i].is_number() && list[i].get<double>() >= 0.0 && list[i].get<double>() <= 1.0;
        if (isSound) colour[static_cast<int>(i)] = static_cast<float>(list[i].get<double>());
    }
    if (!isSound)
        complaint.say(place, "is no colour",
                      kParts == 3
                          ? "write [red, green, blue], each from 0 to 1"
                          : "write [red, green, blue, share of the vehicle's colour], each from 0 to 1");
}

} // namespace scenery::models
