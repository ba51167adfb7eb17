// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <string>
#include <vector>

#include "SettingsFields.h"
#include "SettingsNames.h"

namespace osgPMObjects
{

/// Writes each value that it is called with as a line "name=value,value…".
class LineWriter
{
public:
    template<class Value>
    void operator()(const char* name, const Value& value)
    {
        _line = name;
        _separator = '=';
        put(value);
        lines.push_back(_line);
    }
    std::vector<std::string> lines;

private:
    template<class Number>
    void put(const Number& number)
    {
        char text[40];
        const auto end = std::to_chars(text, text + sizeof text, number).ptr;
        put(std::string(text, end));
    }
    void put(bool value) { put(value ? 1 : 0); }
    void put(core::SelectionMethod method) { put(std::string(core::nameOf(method))); }
    void put(core::SwitchMethod method) { put(std::string(kSwitchNames[static_cast<std::size_t>(method)])); }
    void put(core::BlendProfile profile)
    {
        put(std::string(kProfileNames[static_cast<std::size_t>(profile)]));
    }
    void put(const std::string& word)
    {
        _line += _separator + word;
        _separator = ',';
    }
    void put(const core::OverlapM& boundary)
    {
        put(boundary.nearM);
        put(boundary.farM);
    }
    void put(const glm::dvec3& vector)
    {
        for (int axis = 0; axis < 3; ++axis)
            put(vector[axis]);
    }
    void put(const FieldInstance& instance)
    {
        visitNumbers(instance, [this](const auto& number) { put(number); });
    }
    template<class Value>
    void put(const std::vector<Value>& values)
    {
        for (const Value& value : values)
            put(value);
    }

    std::string _line;
    char _separator = '=';
};

} // namespace osgPMObjects
