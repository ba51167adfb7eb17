// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include <foundation/XmlSource.h>
#include <pugixml.hpp>

#include "simulation/track/TrackBuilder.h"

/// Elements by their names without the prefix of a namespace.
namespace simulation
{

inline std::string_view plainName(pugi::xml_node node)
{
    const std::string_view name = node.name();
    const std::size_t colon = name.rfind(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

/// Returns the first child of a name, or none.
inline pugi::xml_node childOf(pugi::xml_node parent, std::string_view name)
{
    for (pugi::xml_node child : parent.children())
        if (plainName(child) == name) return child;
    return {};
}

inline std::string_view textOf(pugi::xml_node parent, std::string_view name)
{
    return trimmed(childOf(parent, name).text().get());
}

/// Notes what the text has that is not in its encoding.
inline void tellNote(TrackBuilder& builder, const foundation::XmlSource& source)
{
    if (!source.note().empty()) builder.note(source.noteLine(), source.note());
}

} // namespace simulation
