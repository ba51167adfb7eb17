// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <charconv>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "SettingsFields.h"
#include "SettingsNames.h"

namespace osgPMObjects
{

/// Reads each value that it is called with from the line of its name; a value without a line stays as it is.
class LineReader
{
public:
    explicit LineReader(const std::vector<std::string>& lines)
    {
        for (const std::string& line : lines)
        {
            const std::size_t end = line.find('=');
            std::string& words = _values[line.substr(0, end)];
            words = end == std::string::npos ? "" : line.substr(end + 1);
            std::replace(words.begin(), words.end(), ',', ' ');
        }
    }

    template<class Value>
    void operator()(const char* name, Value& value)
    {
        const auto found = _values.find(name);
        if (found == _values.end()) return;
        std::istringstream words(found->second);
        if ((!get(words, value) || !(words >> std::ws).eof()) && wrong.empty())
            wrong = std::string(name) + " cannot be \"" + found->second + "\"";
        _values.erase(found);
    }

    /// The first value that is wrong, or a name that is not known; empty: there is none.
    std::string complaint() const
    {
        return wrong.empty() && !_values.empty() ? "\"" + _values.begin()->first + "\" is not known" : wrong;
    }
    std::string wrong;

private:
    template<class Number>
    static bool get(std::istream& words, Number& number)
    {
        std::string word;
        words >> word;
        const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
        return read.ec == std::errc() && read.ptr == word.data() + word.size();
    }
    static bool get(std::istream& words, bool& value)
    {
        int number = 0;
        if (!get(words, number)) return false;
        value = number != 0;
        return number == 0 || number == 1;
    }
    template<class Choice, class NameOf>
    static bool getChoice(std::istream& words, Choice& choice, std::size_t count, const NameOf& nameAt)
    {
        std::string word;
        words >> word;
        for (std::size_t i = 0; i < count; ++i)
            if (word == nameAt(i))
            {
                choice = static_cast<Choice>(i);
                return true;
            }
        return false;
    }
    static bool get(std::istream& words, core::SelectionMethod& method)
    {
        return getChoice(words, method, core::kSelectionMethods,
                         [](std::size_t i) { return core::nameOf(static_cast<core::SelectionMethod>(i)); });
    }
    static bool get(std::istream& words, core::SwitchMethod& method)
    {
        return getChoice(words, method, kSwitchNames.size(), [](std::size_t i) { return kSwitchNames[i]; });
    }
    static bool get(std::istream& words, core::BlendProfile& profile)
    {
        return getChoice(words, profile, kProfileNames.size(),
                         [](std::size_t i) { return kProfileNames[i]; });
    }
    static bool get(std::istream& words, core::OverlapM& boundary)
    {
        return get(words, boundary.nearM) && get(words, boundary.farM);
    }
    static bool get(std::istream& words, glm::dvec3& vector)
    {
        return get(words, vector.x) && get(words, vector.y) && get(words, vector.z);
    }
    static bool get(std::istream& words, FieldInstance& instance)
    {
        bool isGood = true;
        visitNumbers(instance, [&](auto& number) { isGood = isGood && get(words, number); });
        return isGood;
    }
    template<class Value>
    static bool get(std::istream& words, std::vector<Value>& values)
    {
        for (values.clear(); !(words >> std::ws).eof();)
            if (!get(words, values.emplace_back())) return false;
        return true;
    }

    std::map<std::string, std::string> _values;
};

} // namespace osgPMObjects
