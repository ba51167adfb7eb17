// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/CoordinateText.h"

#include <array>
#include <cctype>
#include <cmath>
#include <utility>
#include <vector>

#include "simulation/parser/Expression.h"

namespace simulation
{
namespace
{

constexpr std::size_t kLongestCoordinate = 64;

/// What stands for degrees, minutes and seconds: signs and their look-alikes, then words.
constexpr std::array<std::pair<std::string_view, char>, 22> kCoordinateSigns{
    {{"\xC2\xB0", 'd'}, // °
     {"\xC2\xBA", 'd'}, // º
     {"\xCB\x9A", 'd'}, // ˚
     {"''", 's'},
     {"\xE2\x80\x99\xE2\x80\x99", 's'}, // ’’
     {"\xE2\x80\xB2\xE2\x80\xB2", 's'}, // ′′
     {"'", 'm'},
     {"\xE2\x80\xB2", 'm'}, // ′
     {"\xE2\x80\x99", 'm'}, // ’
     {"\xE2\x80\x98", 'm'}, // ‘
     {"\xC2\xB4", 'm'},     // ´
     {"`", 'm'},
     {"\"", 's'},
     {"\xE2\x80\xB3", 's'}, // ″
     {"\xE2\x80\x9D", 's'}, // ”
     {"\xE2\x80\x9C", 's'}, // “
     {"DEG", 'd'},
     {"MIN", 'm'},
     {"SEC", 's'},
     {":", ':'},
     {"\xE2\x88\x92", '-'}, // −
     {"\xC2\xA0", ' '}}};   // no-break space

/// The parts of a coordinate as they are written.
struct CoordinateParts
{
    std::vector<double> numbers;
    std::vector<bool> areWhole;
    std::vector<char> signs; ///< behind each number: d, m, s, or a blank
    std::string letters;     ///< of hemispheres
    bool hasSign = false, isNegative = false;
    bool isSound = true;
};

class CoordinateReader
{
public:
    explicit CoordinateReader(std::string_view cell) : _rest(cell) {}

    CoordinateParts parts()
    {
        if (_rest.size() > kLongestCoordinate) _parts.isSound = false;
        while (_parts.isSound && !_rest.empty())
            takeOne();
        return std::move(_parts);
    }

private:
    void takeOne()
    {
        if (isDigit(_rest.front())) return takeNumber();
        for (const auto& [text, sign] : kCoordinateSigns)
            if (startsWith(text))
            {
                _rest.remove_prefix(text.size());
                return takeSign(sign);
            }
        const char c = _rest.front();
        _rest.remove_prefix(1);
        takeSign(c);
    }

    void takeSign(char sign)
    {
        const auto capital = static_cast<char>(std::toupper(static_cast<unsigned char>(sign)));
        std::vector<char>& signs = _parts.signs;
        const bool isBehindBlank = std::exchange(_isBehindBlank, sign == ' ' || sign == '\t');
        if (_isBehindBlank) return;
        if (sign == 'd' || sign == 'm' || sign == 's')
            _parts.isSound = !signs.empty() && std::exchange(signs.back(), sign) == ' ';
        else if (sign == '-' || sign == '+')
        {
            // Ahead of all numbers it is the sign, right between them a mark.
            _parts.isSound = signs.empty() ? !_parts.hasSign : sign == '-' && !isBehindBlank;
            if (!signs.empty()) return;
            _parts.hasSign = true;
            _parts.isNegative = sign == '-';
        }
        else if (sign == ':')
            _parts.isSound = !signs.empty();
        else if (std::string_view("NSEWO").find(capital) != std::string_view::npos)
            _parts.letters += capital;
        else
            _parts.isSound = false;
    }

    void takeNumber()
    {
        std::size_t end = 0;
        bool isWhole = true;
        std::string text;
        for (; end < _rest.size(); ++end)
        {
            const char c = _rest[end];
            const bool isMark =
                (c == '.' || c == ',') && isWhole && end + 1 < _rest.size() && isDigit(_rest[end + 1]);
            if (!isDigit(c) && !isMark) break;
            isWhole = isWhole && !isMark;
            text += isMark ? '.' : c;
        }
        if (const std::size_t exponent = exponentLength(_rest.substr(end)); exponent > 0)
        {
            isWhole = false;
            text += _rest.substr(end, exponent);
            end += exponent;
        }
        _rest.remove_prefix(end);
        const auto value = parseNumber(text);
        _parts.isSound = value && _parts.numbers.size() < 3;
        _parts.numbers.push_back(value.value_or(0.0));
        _parts.areWhole.push_back(isWhole);
        _parts.signs.push_back(' ');
    }

    bool startsWith(std::string_view text) const
    {
        if (_rest.size() < text.size()) return false;
        for (std::size_t i = 0; i < text.size(); ++i)
            if (static_cast<char>(std::toupper(static_cast<unsigned char>(_rest[i]))) != text[i])
                return false;
        return true;
    }

    /// The length of `e-05`; 0: there is none.
    static std::size_t exponentLength(std::string_view text)
    {
        if (text.empty() || (text[0] != 'e' && text[0] != 'E')) return 0;
        const std::size_t first = text.size() > 1 && (text[1] == '-' || text[1] == '+') ? 2 : 1;
        std::size_t end = first;
        while (end < text.size() && isDigit(text[end]))
            ++end;
        return end > first ? end : 0;
    }

    static bool isDigit(char c) { return c >= '0' && c <= '9'; }

    std::string_view _rest;
    CoordinateParts _parts;
    bool _isBehindBlank = false;
};

/// Whether the signs behind numbers are those of degrees, minutes and seconds, or none.
bool areInOrder(const std::vector<char>& signs)
{
    constexpr std::string_view kOrder = "dms";
    for (std::size_t i = 0; i < signs.size(); ++i)
        if (signs[i] != ' ' && signs[i] != kOrder[i]) return false;
    return true;
}

/// -1, 0 (not said) or 1; nothing, and the fault: the letter cannot be.
std::optional<int> sideOfLetter(const CoordinateParts& parts, bool isEast, SideOfO sideOfO,
                                std::string& fault)
{
    if (parts.letters.empty()) return 0;
    const char letter = parts.letters.front();
    if (parts.letters.size() > 1) return std::nullopt;
    if (letter == 'O' && isEast && sideOfO == SideOfO::unknown)
    {
        fault = "O is east in German and Dutch, and west in French, Spanish, Italian and Portuguese; write E "
                "or W";
        return std::nullopt;
    }
    const std::string_view known = isEast ? "EWO" : "NS";
    if (known.find(letter) == std::string_view::npos)
    {
        fault = std::string("the letter ") + letter + " is of the other coordinate";
        return std::nullopt;
    }
    if (parts.hasSign)
    {
        fault = std::string("a coordinate has a sign and the letter ") + letter + "; write one of them";
        return std::nullopt;
    }
    const bool isWest = letter == 'W' || letter == 'S' || (letter == 'O' && sideOfO == SideOfO::west);
    return isWest ? -1 : 1;
}

} // namespace

CoordinateReading readCoordinate(std::string_view cell, bool isEast, const CoordinateStyle& style)
{
    CoordinateReading reading;
    const CoordinateParts parts = CoordinateReader(cell).parts();
    if (!parts.isSound || parts.numbers.empty() || !areInOrder(parts.signs)) return reading;
    const auto side = sideOfLetter(parts, isEast, style.sideOfO, reading.fault);
    if (!side) return reading;
    double degrees = 0.0, unit = 1.0;
    for (std::size_t i = 0; i < parts.numbers.size(); ++i, unit /= 60.0)
    {
        const bool isLast = i + 1 == parts.numbers.size();
        if ((i > 0 && parts.numbers[i] >= 60.0) || (!isLast && !parts.areWhole[i]))
        {
            reading.fault =
                "a coordinate's minutes or seconds are 60 or more, or stand behind a part of a degree";
            return reading;
        }
        degrees += unit * parts.numbers[i];
    }
    if (style.unitDeg != 1.0 && (parts.numbers.size() > 1 || !parts.areWhole[0]))
    {
        reading.fault = "a coordinate is no whole number, although its heading says E7 or E6";
        return reading;
    }
    degrees *= style.unitDeg;
    reading.degrees = *side < 0 || (*side == 0 && parts.isNegative) ? -degrees : degrees;
    return reading;
}

} // namespace simulation
