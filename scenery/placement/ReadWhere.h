// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/placement/JsonFields.h"
#include "scenery/placement/SceneryDescription.h"

namespace scenery
{

/// A member `[least, most]`, both within a range; what is not there stays as it is.
void readSpan(JsonFields& parent, const char* name, Span& span, double least, double most);

/// The member `where` of a field, likewise.
void readWhere(JsonFields& parent, Where& where);

} // namespace scenery
