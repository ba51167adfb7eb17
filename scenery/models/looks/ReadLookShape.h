// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/json/JsonFields.h"
#include "scenery/models/vehicles/VehicleLook.h"

namespace scenery::models
{

/// Reads a number that has to be there.
void readNeeded(JsonFields& fields, const char* name, double& value, double least, double most);

/// Complains that a member is missing.
void sayMissing(JsonFields& fields, const std::string& name);

/// Reads a member that is an object and has to be there: `read` takes its members.
template<class Read>
void readPart(JsonFields& parent, const char* name, Read read)
{
    const nlohmann::json* const found = parent.find(name);
    if (!found) return sayMissing(parent, name);
    JsonFields fields(*found, parent.at(name), parent.complaint());
    read(fields);
}

/// Reads the members `size`, `profile`, `wheels`, `stretch` and `bounds` of a look.
/// Errors: also of a shape of which no closed body can be made.
void readLookShape(JsonFields& root, VehicleLook& look);

} // namespace scenery::models
