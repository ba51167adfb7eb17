// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>

#include <pugixml.hpp>

namespace islandgen
{

/// Writes attributes of an XML element. Numbers have twelve significant digits: 1 µm at the size of the course.
inline void set(pugi::xml_node node, const char* name, double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.12g", value == 0.0 ? 0.0 : value);
    node.append_attribute(name).set_value(text);
}

inline void set(pugi::xml_node node, const char* name, int value)
{
    node.append_attribute(name).set_value(value);
}

inline void set(pugi::xml_node node, const char* name, const char* value)
{
    node.append_attribute(name).set_value(value);
}

inline pugi::xml_node addLane(pugi::xml_node side, int id, const char* type)
{
    pugi::xml_node lane = side.append_child("lane");
    set(lane, "id", id);
    set(lane, "type", type);
    set(lane, "level", "false");
    return lane;
}

} // namespace islandgen
