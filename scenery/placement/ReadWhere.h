// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/json/JsonFields.h"
#include "scenery/placement/SceneryDescription.h"

namespace scenery
{

/// Reads a member `[least, most]`, both within a range; an absent one keeps its values.
void readSpan(JsonFields& parent, const char* name, Span& span, double least, double most);

/// Reads the member `where` of a field; an absent one keeps its values.
void readWhere(JsonFields& parent, Where& where);

} // namespace scenery
