// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/parser/ParseContext.h"

namespace simulation
{

/// Reports everything below an element, and in it, that no parser has asked for, one problem for each:
/// elements that are not in effect, elements and attributes that the standard has not, or not there. Content
/// of what is reported already is left out. Counts the elements. Call it when the element has been read.
void reportUnread(ParseContext& context, pugi::xml_node element);

} // namespace simulation
