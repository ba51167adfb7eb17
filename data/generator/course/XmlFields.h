// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/XmlFields.h>

namespace islandgen
{

using foundation::set;

inline pugi::xml_node addLane(pugi::xml_node side, int id, const char* type)
{
    pugi::xml_node lane = side.append_child("lane");
    set(lane, "id", id);
    set(lane, "type", type);
    set(lane, "level", "false");
    return lane;
}

} // namespace islandgen
