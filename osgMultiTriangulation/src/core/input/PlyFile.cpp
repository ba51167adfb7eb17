// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <sstream>

#include <osgMultiTriangulation/core/input/TinFile.h>

#include "CountedSink.h"
#include "TinCollector.h"

namespace osgMultiTriangulation::core
{

namespace
{

enum class PlyScalar
{
    int8,
    uint8,
    int16,
    uint16,
    int32,
    uint32,
    float32,
    float64,
};

constexpr std::array<std::array<const char*, 2>, 8> kScalarNames{{{"char", "int8"},
                                                                  {"uchar", "uint8"},
                                                                  {"short", "int16"},
                                                                  {"ushort", "uint16"},
                                                                  {"int", "int32"},
                                                                  {"uint", "uint32"},
                                                                  {"float", "float32"},
                                                                  {"double", "float64"}}};

std::optional<PlyScalar> scalarOf(const std::string& name)
{
    for (std::size_t i = 0; i < kScalarNames.size(); ++i)
        if (name == kScalarNames[i][0] || name == kScalarNames[i][1]) return static_cast<PlyScalar>(i);
    return std::nullopt;
}

struct PlyProperty
{
    std::string name;
    PlyScalar type = PlyScalar::float32;
    std::optional<PlyScalar> countType{}; ///< of a list
};

struct PlyElement
{
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

/// The values behind the header, as text or in binary.
class PlyValues
{
public:
    enum class Form
    {
        text,
        little,
        big,
    };

    PlyValues(std::string_view bytes, Form form) : _bytes(bytes), _form(form) {}

    /// Takes the next value. Returns whether it is there and a finite number.
    bool take(PlyScalar type, double& value)
    {
        if (_form == Form::text) return takeWord(value);
        switch (type)
        {
        case PlyScalar::int8:
            return takeBytes<std::int8_t>(value);
        case PlyScalar::uint8:
            return takeBytes<std::uint8_t>(value);
        case PlyScalar::int16:
            return takeBytes<std::int16_t>(value);
        case PlyScalar::uint16:
            return takeBytes<std::uint16_t>(value);
        case PlyScalar::int32:
            return takeBytes<std::int32_t>(value);
        case PlyScalar::uint32:
            return takeBytes<std::uint32_t>(value);
        case PlyScalar::float32:
            return takeBytes<float>(value);
        case PlyScalar::float64:
            return takeBytes<double>(value);
        }
        return false;
    }

    std::size_t left() const { return _bytes.size(); }

private:
    bool takeWord(double& value)
    {
        const std::size_t first = _bytes.find_first_not_of(" \t\r\n");
        if (first == std::string_view::npos) return false;
        _bytes.remove_prefix(first);
        if (_bytes.front() == '+') _bytes.remove_prefix(1);
        const auto [end, failed] = std::from_chars(_bytes.data(), _bytes.data() + _bytes.size(), value);
        if (failed != std::errc() || !std::isfinite(value)) return false;
        _bytes.remove_prefix(static_cast<std::size_t>(end - _bytes.data()));
        return _bytes.empty() || std::string_view(" \t\r\n").find(_bytes.front()) != std::string_view::npos;
    }

    template<class T>
    bool takeBytes(double& value)
    {
        if (_bytes.size() < sizeof(T)) return false;
        std::array<char, sizeof(T)> raw;
        std::copy_n(_bytes.begin(), sizeof(T), raw.begin());
        _bytes.remove_prefix(sizeof(T));
        if ((_form == Form::big) != (std::endian::native == std::endian::big)) std::ranges::reverse(raw);
        T number;
        std::memcpy(&number, raw.data(), sizeof number);
        value = static_cast<double>(number);
        return std::isfinite(value);
    }

    std::string_view _bytes;
    Form _form;
};

class PlyReader
{
public:
    PlyReader(std::string_view bytes, std::string name, TinSink& sink)
        : _rest(bytes), _name(std::move(name)), _sink(sink)
    {
    }

    foundation::Outcome read()
    {
        if (const auto header = readHeader(); !header) return header.error();
        PlyValues values(_rest, _form);
        for (const PlyElement& element : _elements)
        {
            // An item takes a byte at least, if it has anything at all.
            if (element.properties.empty() || element.count > values.left())
                return failure("ends before its element " + element.name + " does");
            for (std::size_t item = 0; item < element.count; ++item)
                if (const auto taken = takeItem(values, element, item); !taken) return taken.error();
        }
        if (_sink.triangles() == 0) return failure("has no faces");
        return foundation::success();
    }

private:
    foundation::Outcome readHeader()
    {
        std::string line;
        if (!takeLine(line) || line != "ply") return failure("is no PLY file");
        bool hasForm = false;
        while (takeLine(line))
        {
            std::istringstream words(line);
            std::string keyword, first, second, third, fourth;
            words >> keyword >> first >> second >> third >> fourth;
            if (keyword == "end_header") return hasForm ? foundation::success() : failure("tells no format");
            if (keyword == "format")
                hasForm = takeForm(first);
            else if (keyword == "element")
                _elements.push_back({first, countOf(second), {}});
            else if (keyword == "property" && !takeProperty(first, second, third, fourth))
                return failure("has a property that cannot be read: " + line);
        }
        return failure("ends within its header");
    }

    bool takeForm(const std::string& form)
    {
        if (form == "ascii")
            _form = PlyValues::Form::text;
        else if (form == "binary_little_endian")
            _form = PlyValues::Form::little;
        else if (form == "binary_big_endian")
            _form = PlyValues::Form::big;
        else
            return false;
        return true;
    }

    /// "TYPE NAME", or "list COUNT TYPE NAME".
    bool takeProperty(const std::string& first, const std::string& second, const std::string& third,
                      const std::string& fourth)
    {
        if (_elements.empty()) return false;
        const bool isList = first == "list";
        const auto type = scalarOf(isList ? third : first), count = scalarOf(isList ? second : "int");
        if (!type || !count) return false;
        PlyProperty property{isList ? fourth : second, *type, std::nullopt};
        if (isList) property.countType = *count;
        _elements.back().properties.push_back(property);
        return true;
    }

    static std::size_t countOf(const std::string& word)
    {
        std::size_t count = 0;
        std::from_chars(word.data(), word.data() + word.size(), count);
        return count;
    }

    bool takeLine(std::string& line)
    {
        if (_rest.empty()) return false;
        const std::size_t end = std::min(_rest.find('\n'), _rest.size());
        line = _rest.substr(0, end);
        _rest.remove_prefix(std::min(end + 1, _rest.size()));
        while (!line.empty() && (line.back() == '\r' || line.back() == ' '))
            line.pop_back();
        return true;
    }

    foundation::Outcome takeItem(PlyValues& values, const PlyElement& element, std::size_t item)
    {
        const std::string place = element.name + " " + std::to_string(item);
        MeasuredPoint point{};
        for (const PlyProperty& property : element.properties)
        {
            double value = 0.0;
            if (!values.take(property.countType.value_or(property.type), value))
                return failure("ends at " + place + ", or has something there that is no finite number");
            if (property.countType)
            {
                const bool isFace = element.name == "face" && property.name.starts_with("vertex_ind");
                if (!takeList(values, property, value, isFace))
                    return failure("has a list at " + place +
                                   " that is cut off, or names a vertex that is not there");
                continue;
            }
            for (std::size_t axis = 0; axis < 3; ++axis)
                if (property.name.size() == 1 && property.name[0] == "xyz"[axis]) point[axis] = value;
        }
        if (element.name == "vertex") _sink.add(point);
        return foundation::success();
    }

    bool takeList(PlyValues& values, const PlyProperty& property, double count, bool isFace)
    {
        if (!(count >= 0.0) || (isFace && count < 3.0)) return false;
        Triangle fan{};
        for (double i = 0.0; i < count; ++i)
        {
            double value = 0.0;
            if (!values.take(property.type, value)) return false;
            if (!isFace) continue;
            if (!(value >= 0.0 && value < static_cast<double>(_sink.points()))) return false;
            fan[2] = static_cast<std::uint32_t>(value);
            if (i == 0.0) fan[0] = fan[2];
            if (i >= 2.0) _sink.add(fan);
            fan[1] = fan[2];
        }
        return true;
    }

    foundation::Error failure(const std::string& what) const
    {
        return {_name, what, "give a PLY file with elements vertex (x, y, z) and face (vertex_indices)"};
    }

    std::string_view _rest;
    std::string _name;
    PlyValues::Form _form = PlyValues::Form::text;
    std::vector<PlyElement> _elements;
    CountedSink _sink;
};

} // namespace

foundation::Outcome streamPly(std::string_view bytes, const std::string& name, TinSink& sink)
{
    return PlyReader(bytes, name, sink).read();
}

foundation::Result<MeasuredTin> parsePly(std::string_view bytes, const std::string& name)
{
    TinCollector collector;
    if (const auto read = streamPly(bytes, name, collector); !read) return read.error();
    return std::move(collector.tin);
}

} // namespace osgMultiTriangulation::core
