// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "pmtool/polygons/ReadPolygons.h"

namespace pmtool
{

namespace
{

using Words = std::vector<std::string_view>;

Words wordsOf(std::string_view line)
{
    constexpr std::string_view kBlanks = " \t\r";
    Words words;
    for (std::size_t at = line.find_first_not_of(kBlanks); at != line.npos;
         at = line.find_first_not_of(kBlanks, at))
    {
        const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
        words.push_back(line.substr(at, end - at));
        at = end;
    }
    return words;
}

template<class Number>
bool readNumber(std::string_view word, Number& value)
{
    const auto [end, failed] = std::from_chars(word.data(), word.data() + word.size(), value);
    return failed == std::errc() && end == word.data() + word.size();
}

/// Reads an index of the format: from 1, or from -1 backwards.
std::optional<std::uint32_t> readIndex(std::string_view word, std::size_t count)
{
    long long index = 0;
    if (!readNumber(word, index)) return std::nullopt;
    const auto size = static_cast<long long>(count);
    if (index < 0 && index >= -size) return static_cast<std::uint32_t>(size + index);
    if (index > 0 && index <= size) return static_cast<std::uint32_t>(index - 1);
    return std::nullopt;
}

/// Reads lines into a set. Each function returns what is wrong with its line, or an empty string.
class ObjReader
{
public:
    std::string read(std::string_view line, std::size_t number)
    {
        const Words words = wordsOf(line);
        if (words.empty()) return {};
        if (words[0] == "v") return readPosition(words);
        if (words[0] == "vt") return readTexCoord(words);
        if (words[0] == "f") return readFace(words, number);
        return {};
    }

    PolygonSet finish()
    {
        if (!_isTextured) _set.texCoords.clear();
        return std::move(_set);
    }

private:
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    static bool readNumbers(const Words& words, int count, double* numbers)
    {
        for (int i = 0; i < count; ++i)
            if (!readNumber(words[i + 1], numbers[i]) || !std::isfinite(numbers[i])) return false;
        return true;
    }

    std::string readPosition(const Words& words)
    {
        double at[3];
        if (words.size() < 4 || !readNumbers(words, 3, at)) return "v needs three finite numbers";
        _positions.push_back({at[0], at[1], at[2]});
        return {};
    }

    std::string readTexCoord(const Words& words)
    {
        double at[2] = {0.0, 0.0};
        const int count = words.size() > 2 ? 2 : 1;
        if (words.size() < 2 || !readNumbers(words, count, at)) return "vt needs one or two finite numbers";
        _texCoords.push_back({at[0], at[1]});
        return {};
    }

    std::string readFace(const Words& words, std::size_t number)
    {
        if (words.size() < 4) return "a face needs at least three corners";
        Polygon polygon;
        polygon.location = "line " + std::to_string(number);
        polygon.isTextured = true;
        for (std::size_t i = 1; i < words.size(); ++i)
        {
            const std::size_t slash = std::min(words[i].find('/'), words[i].size());
            const auto position = readIndex(words[i].substr(0, slash), _positions.size());
            std::string_view rest = words[i].substr(std::min(slash + 1, words[i].size()));
            rest = rest.substr(0, rest.find('/'));
            const auto texCoord = rest.empty() ? std::optional(kNone) : readIndex(rest, _texCoords.size());
            if (!position || !texCoord) return "no vertex '" + std::string(words[i]) + "' stands before it";
            polygon.isTextured = polygon.isTextured && *texCoord != kNone;
            polygon.corners.push_back(vertexOf(*position, *texCoord));
        }
        _isTextured = _isTextured || polygon.isTextured;
        polygon.contourSizes = {static_cast<std::uint32_t>(polygon.corners.size())};
        _set.polygons.push_back(std::move(polygon));
        return {};
    }

    std::uint32_t vertexOf(std::uint32_t position, std::uint32_t texCoord)
    {
        const auto next = static_cast<std::uint32_t>(_set.positions.size());
        const auto [found, isNew] = _vertices.try_emplace({position, texCoord}, next);
        if (isNew)
        {
            _set.positions.push_back(_positions[position]);
            _set.texCoords.push_back(texCoord != kNone ? _texCoords[texCoord] : glm::dvec2(0.0));
        }
        return found->second;
    }

    PolygonSet _set;
    bool _isTextured = false;
    std::vector<glm::dvec3> _positions;
    std::vector<glm::dvec2> _texCoords;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> _vertices;
};

/// Takes a line off the text; a backslash at its end joins the next one to it. Adds to `lines`.
std::string takeLine(std::string_view& text, std::size_t& lines)
{
    std::string line;
    while (!text.empty())
    {
        const std::size_t end = std::min(text.find('\n'), text.size());
        line += text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        ++lines;
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (line.empty() || line.back() != '\\') break;
        line.back() = ' ';
    }
    return line;
}

} // namespace

foundation::Result<PolygonSet> parseObj(std::string_view text, const std::string& file)
{
    ObjReader reader;
    for (std::size_t lines = 0; !text.empty();)
    {
        const std::size_t number = lines + 1;
        const std::string line = takeLine(text, lines);
        if (const std::string wrong = reader.read(line, number); !wrong.empty())
            return foundation::Error{file + ", line " + std::to_string(number), wrong,
                                     "repair the line, or export the model again"};
    }
    return reader.finish();
}

} // namespace pmtool
