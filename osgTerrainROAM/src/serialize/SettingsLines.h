// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <osg/Vec3d>
#include <osg/Vec3f>

#include <viewlod/Budget.h>

#include <osgTerrainROAM/Atmosphere>
#include <osgTerrainROAM/RoamDrawableSettings>
#include <osgTerrainROAM/RoamTechnique>

namespace osgTerrainROAM
{

/// Calls visit(name, field) for every field of the settings: the same for writing and reading.
template<class Visit>
void visitFields(auto& settings, Visit& visit)
{
    using Settings = std::remove_cvref_t<decltype(settings)>;
    if constexpr (std::is_same_v<Settings, AtmosphereSettings>)
    {
        visit("sunDirectionWorld", settings.sunDirectionWorld);
        visit("visibilityM", settings.visibilityM);
        visit("hazeBaseM", settings.hazeBaseM);
        visit("sunIntensity", settings.sunIntensity);
        visit("cloudCover", settings.cloudCover);
        visit("moonlight", settings.moonlight);
        visit("fogColour", settings.fogColour);
    }
    else
    {
        visit("errorTolerancePx", settings.errorTolerancePx);
        visit("maxTriangles", settings.maxTriangles);
        visit("morphing", settings.morphing);
    }
    if constexpr (std::is_same_v<Settings, RoamDrawableSettings>)
    {
        visit("maxAdaptTimeUs", settings.maxAdaptTimeUs);
        visit("adaptClock", settings.adaptClock);
        visit("skirtM", settings.skirtM);
        visit("patchExponent", settings.patchExponent);
        visit("nearestM", settings.nearestM);
        visit("defaultErrorM", settings.defaultErrorM);
    }
}

/// Writes fields as lines without spaces, "name=number,number". Numbers are as short as they can be and are read back as they
/// were, infinity too. An absent value has no line.
class SettingsWriter
{
public:
    template<class Value>
    void operator()(const char* name, const Value& value)
    {
        _text.clear();
        put(value);
        if (!_text.empty()) lines.push_back(std::string(name) + "=" + _text.substr(1));
    }
    std::vector<std::string> lines;

private:
    template<class Number>
    void put(const Number& number)
    {
        char text[40];
        _text += ',' + std::string(text, std::to_chars(text, text + sizeof text, number).ptr);
    }
    void put(bool value) { put(value ? 1 : 0); }
    void put(viewlod::Budget::Clock clock) { put(static_cast<int>(clock)); }
    void put(const osg::Vec3d& v) { putThree(v); }
    void put(const osg::Vec3f& v) { putThree(v); }
    void putThree(const auto& v)
    {
        for (int i = 0; i < 3; ++i)
            put(v[i]);
    }
    template<class Value>
    void put(const std::optional<Value>& value)
    {
        if (value) put(*value);
    }

    std::string _text; ///< each number after a comma
};

/// Reads the lines of a SettingsWriter. A field without a line becomes absent, or stays as it was.
class SettingsReader
{
public:
    explicit SettingsReader(const std::vector<std::string>& lines)
    {
        for (const std::string& line : lines)
        {
            const std::size_t end = line.find('=');
            _values[line.substr(0, end)] = end == std::string::npos ? "" : line.substr(end + 1);
        }
    }

    template<class Value>
    void operator()(const char* name, Value& value)
    {
        const auto found = _values.find(name);
        if (found == _values.end()) return;
        _next = found->second.data();
        _end = _next + found->second.size();
        if ((!get(value) || _next != _end) && _wrong.empty())
            _wrong = std::string(name) + " cannot be \"" + found->second + "\"";
        _values.erase(found);
    }

    /// The first value that is wrong, or a name that no field has; empty: none.
    std::string complaint() const
    {
        return _wrong.empty() && !_values.empty() ? "\"" + _values.begin()->first + "\" is not known"
                                                  : _wrong;
    }

private:
    template<class Number>
    bool get(Number& number)
    {
        const auto read = std::from_chars(_next, _end, number);
        _next = read.ptr;
        return read.ec == std::errc();
    }
    bool get(bool& value)
    {
        int number = 0;
        if (!get(number)) return false;
        value = number != 0;
        return number == 0 || number == 1;
    }
    bool get(viewlod::Budget::Clock& clock)
    {
        bool isSecond = false;
        if (!get(isSecond)) return false;
        clock = static_cast<viewlod::Budget::Clock>(isSecond ? 1 : 0);
        return true;
    }
    bool get(osg::Vec3d& v) { return getThree(v); }
    bool get(osg::Vec3f& v) { return getThree(v); }
    bool getThree(auto& v)
    {
        for (int i = 0; i < 3; ++i)
        {
            if (i > 0 && (_next == _end || *_next++ != ',')) return false;
            if (!get(v[i])) return false;
        }
        return true;
    }
    template<class Value>
    bool get(std::optional<Value>& value)
    {
        return get(value.emplace());
    }

    std::map<std::string, std::string> _values;
    std::string _wrong;
    const char* _next = nullptr;
    const char* _end = nullptr;
};

} // namespace osgTerrainROAM
