// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <pugixml.hpp>

#include "simulation/parser/Expression.h"
#include "simulation/scenario/Scenario.h"

namespace simulation
{

/// Builds an XML tree one element at a time and keeps the first error.
class ElementWriter
{
public:
    ElementWriter(pugi::xml_node node, std::string& unwritable) : _node(node), _unwritable(unwritable) {}

    ElementWriter child(const char* name) { return {_node.append_child(name), _unwritable}; }

    ElementWriter& set(const char* attribute, const std::string& value)
    {
        _node.append_attribute(attribute).set_value(value.c_str());
        return *this;
    }
    ElementWriter& set(const char* attribute, const char* value)
    {
        return set(attribute, std::string(value));
    }
    ElementWriter& set(const char* attribute, std::string_view value)
    {
        return set(attribute, std::string(value));
    }
    ElementWriter& set(const char* attribute, double value) { return set(attribute, formatNumber(value)); }
    ElementWriter& set(const char* attribute, int value) { return set(attribute, std::to_string(value)); }
    ElementWriter& set(const char* attribute, bool value) { return set(attribute, value ? "true" : "false"); }
    ElementWriter& set(const char* attribute, const std::optional<double>& value)
    {
        return value ? set(attribute, *value) : *this;
    }

    void refuse(const Unsupported& content)
    {
        if (_unwritable.empty()) _unwritable = content.element.empty() ? "an empty element" : content.element;
    }

private:
    pugi::xml_node _node;
    std::string& _unwritable;
};

/// Notes content that cannot be written, because the model keeps only its name.
inline void writeContent(ElementWriter parent, const Unsupported& content)
{
    parent.refuse(content);
}

/// Refuses content that is played, but that no tour has.
template<class Content>
requires requires
{
    Content::kElement;
}
void writeContent(ElementWriter parent, const Content&)
{
    parent.refuse({{}, std::string(Content::kElement)});
}

void writePosition(ElementWriter parent, const Position& position);           // WriteAction.cpp
void writePrivateAction(ElementWriter parent, const PrivateAction& action);   // WriteAction.cpp
void writeGlobalAction(ElementWriter parent, const GlobalAction& action);     // WriteAction.cpp
void writeScenarioObject(ElementWriter parent, const ScenarioObject& object); // WriteEntity.cpp
void writeStoryboard(ElementWriter parent, const Storyboard& storyboard);     // WriteStoryboard.cpp

} // namespace simulation
