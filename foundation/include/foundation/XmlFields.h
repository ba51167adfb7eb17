// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

#include <pugixml.hpp>

namespace foundation
{

/// Writes attributes of an XML element. Numbers have twelve significant digits: 1 µm at 1000 km. Whoever
/// includes this links pugixml.
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

inline void set(pugi::xml_node node, const char* name, std::string_view value)
{
    node.append_attribute(name).set_value(std::string(value).c_str());
}

} // namespace foundation
