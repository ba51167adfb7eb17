// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <foundation/Units.h>

namespace foundation
{

/// A word for a unit in the tag of a map, and how much of the usual unit it is.
struct TagUnit
{
    std::string_view word;
    double factor;
    bool isFeet = false, isInches = false;
};

/// Reads a quantity as people write it into a map: a number with a unit, "6 ft 2 in", a range. Cyrillic and
/// typographic signs count as what they look like.
class TagQuantityReader
{
public:
    TagQuantityReader(std::string_view text, std::span<const TagUnit> units)
        : _text(plainSigns(text)), _units(units)
    {
        _rest = _text;
    }

    std::optional<double> read()
    {
        skipMarks();
        const auto first = quantity();
        if (!first) return std::nullopt;
        skipSpaces();
        if (take(";") || take("|")) return _rest.empty() ? std::nullopt : first; // a list: its first
        if (take("..") || take("-") || takeWord("to"))
        {
            const auto second = quantity();
            skipSpaces();
            if (!second || !_rest.empty()) return std::nullopt;
            // "3-4 ft": the unit stands once, and counts for both.
            const double from = _hasUnit[0] || !_hasUnit[1] ? *first : *first * _factor[1] / _factor[0];
            return 0.5 * (from + *second);
        }
        return _rest.empty() ? first : std::nullopt;
    }

private:
    static std::string plainSigns(std::string_view text)
    {
        struct Sign
        {
            std::string_view from, to;
        };
        static constexpr Sign kSigns[] = {
            {"\u00A0", " "}, {"\u202F", " "}, {"\u2009", " "},  {"\u2032", "'"},  {"\u2019", "'"},
            {"\u2018", "'"}, {"\u00B4", "'"}, {"\u2033", "\""}, {"\u201D", "\""}, {"\u201C", "\""},
            {"''", "\""},    {"\u2013", "-"}, {"\u2014", "-"},  {"\u2212", "-"},  {"\u2248", "~"},
            {"\u043C", "m"}, {"\u041C", "m"}, {"\u00B1", "~"}};
        std::string plain;
        while (!text.empty())
        {
            const auto sign = std::find_if(std::begin(kSigns), std::end(kSigns),
                                           [&](const Sign& s) { return text.starts_with(s.from); });
            if (sign != std::end(kSigns))
            {
                plain += sign->to;
                text.remove_prefix(sign->from.size());
                continue;
            }
            const char c = text.front();
            plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c == '\t' ? ' ' : c;
            text.remove_prefix(1);
        }
        return plain;
    }

    static bool isDigit(char c) { return c >= '0' && c <= '9'; }

    void skipSpaces()
    {
        while (_rest.starts_with(' '))
            _rest.remove_prefix(1);
    }

    bool take(std::string_view word)
    {
        skipSpaces();
        if (!_rest.starts_with(word)) return false;
        _rest.remove_prefix(word.size());
        return true;
    }

    /// Takes a word that no letter follows.
    bool takeWord(std::string_view word)
    {
        skipSpaces();
        if (!_rest.starts_with(word)) return false;
        const char next = _rest.size() > word.size() ? _rest[word.size()] : ' ';
        const bool isLetters = word.back() >= 'a' && word.back() <= 'z';
        if (isLetters && next >= 'a' && next <= 'z') return false;
        _rest.remove_prefix(word.size());
        return true;
    }

    /// Marks of what is about right.
    void skipMarks()
    {
        static constexpr std::string_view kMarks[] = {"~",     "<",     ">",   "=",  "approx.", "approx",
                                                      "about", "circa", "ca.", "ca", "c."};
        const auto takes = [this](std::string_view mark) { return take(mark); };
        while (std::any_of(std::begin(kMarks), std::end(kMarks), takes))
            continue;
    }

    const TagUnit* unit()
    {
        const TagUnit* best = nullptr;
        skipSpaces();
        for (const TagUnit& candidate : _units)
        {
            const std::string_view kept = _rest;
            const bool fits = takeWord(candidate.word);
            _rest = kept;
            if (fits && (!best || candidate.word.size() > best->word.size())) best = &candidate;
        }
        if (!best) return nullptr;
        takeWord(best->word);
        if (best->word.back() >= 'a' && !_rest.starts_with("..")) take(".");
        return best;
    }

    /// Digits with a decimal point or comma, and with signs between thousands.
    std::optional<std::string> digits()
    {
        skipSpaces();
        std::string number;
        if (_rest.starts_with('+') || _rest.starts_with('-'))
        {
            if (_rest.front() == '-') number = "-";
            _rest.remove_prefix(1);
        }
        const std::size_t sign = number.size();
        std::size_t length = 0;
        const auto digitAt = [&](std::size_t at) { return at < _rest.size() && isDigit(_rest[at]); };
        while (digitAt(length) || (length < _rest.size() && digitAt(length + 1) &&
                                   (_rest[length] == '.' || _rest[length] == ',' ||
                                    (_rest[length] == ' ' && length > 0 && isThousands(length)))))
            number += _rest[length++];
        _rest.remove_prefix(length);
        return number.size() > sign ? std::optional(number) : std::nullopt;
    }

    /// Whether exactly three digits follow a sign in the rest.
    bool isThousands(std::size_t at) const
    {
        std::size_t count = 0;
        while (at + 1 + count < _rest.size() && isDigit(_rest[at + 1 + count]))
            ++count;
        return count == 3;
    }

    /// `hasCommaThousands`: one comma before three digits parts thousands, as with feet and volts.
    static std::optional<double> valueOf(std::string text, bool hasCommaThousands)
    {
        std::erase(text, ' ');
        const auto points = std::count(text.begin(), text.end(), '.'),
                   commas = std::count(text.begin(), text.end(), ',');
        const std::size_t last = text.find_last_of(".,");
        const bool areThousands = commas == 1 && points == 0 && hasCommaThousands && text.size() - last == 4;
        if (points > 1 && commas == 0) return std::nullopt; // a date, a version
        char decimal = '.';
        if (commas == 1 && !areThousands && text[last] == ',') decimal = ',';
        std::string plain;
        for (const char c : text)
            if (c == decimal)
                plain += '.';
            else if (c != '.' && c != ',')
                plain += c;
        double number = 0.0;
        const auto [end, failure] = std::from_chars(plain.data(), plain.data() + plain.size(), number);
        return failure == std::errc() && end == plain.data() + plain.size() ? std::optional(number)
                                                                            : std::nullopt;
    }

    std::optional<double> quantity()
    {
        const auto text = digits();
        if (!text) return std::nullopt;
        const TagUnit* const found = unit();
        const auto number = valueOf(*text, found ? found->isFeet : _units.empty());
        if (!number) return std::nullopt;
        const std::size_t part = std::min<std::size_t>(_read++, 1);
        _hasUnit[part] = found != nullptr;
        _factor[part] = found ? found->factor : 1.0;
        double value = *number * _factor[part];
        if (found && found->isFeet) value += inches();
        return value;
    }

    /// The inches after feet: "2 in", "-2\"", a bare "2" at the end; 0 where none stand there.
    double inches()
    {
        const std::string_view kept = _rest;
        take("-");
        if (const auto text = digits())
        {
            const TagUnit* const found = unit();
            const auto number = valueOf(*text, false);
            const bool isBare = !found && _rest.empty() && !kept.starts_with('-');
            if (number && *number >= 0.0 && *number < 12.0 && (isBare || (found && found->isInches)))
                return *number * kMetresPerFoot / 12.0;
        }
        _rest = kept;
        return 0.0;
    }

    std::string _text;
    std::string_view _rest;
    std::span<const TagUnit> _units;
    std::size_t _read = 0;
    bool _hasUnit[2] = {false, false};
    double _factor[2] = {1.0, 1.0};
};

/// Reads a length, metres unless a unit stands with it: "22", "22 m", "22,5", "72 ft", "72'2\"", "6'", "~20",
/// "20-25" (the middle), "20;25" (the first). Nothing where it says something else, or anything besides.
/// Source: the OpenStreetMap wiki, *Map features/Units*.
inline std::optional<double> metresOfTag(std::string_view text)
{
    static constexpr TagUnit kUnits[] = {{"m", 1.0},
                                         {"metre", 1.0},
                                         {"metres", 1.0},
                                         {"meter", 1.0},
                                         {"meters", 1.0},
                                         {"mtr", 1.0},
                                         {"mtrs", 1.0},
                                         {"km", 1000.0},
                                         {"dm", 0.1},
                                         {"cm", 0.01},
                                         {"mm", 0.001},
                                         {"ft", kMetresPerFoot, true},
                                         {"feet", kMetresPerFoot, true},
                                         {"foot", kMetresPerFoot, true},
                                         {"'", kMetresPerFoot, true},
                                         {"\"", kMetresPerFoot / 12.0, false, true},
                                         {"in", kMetresPerFoot / 12.0, false, true},
                                         {"inch", kMetresPerFoot / 12.0, false, true},
                                         {"inches", kMetresPerFoot / 12.0, false, true},
                                         {"yd", 3.0 * kMetresPerFoot},
                                         {"yds", 3.0 * kMetresPerFoot},
                                         {"mi", 5280.0 * kMetresPerFoot},
                                         {"mile", 5280.0 * kMetresPerFoot},
                                         {"miles", 5280.0 * kMetresPerFoot},
                                         {"nmi", 1852.0}};
    return TagQuantityReader(text, kUnits).read();
}

/// Reads a speed, km/h unless a unit stands with it: "50", "50 km/h", "30 mph", "5 knots". Otherwise as
/// metresOfTag(). Source: the OpenStreetMap wiki, *Key:maxspeed*.
inline std::optional<double> kmhOfTag(std::string_view text)
{
    constexpr double kKmhPerMph = kMpsPerMph * kKmhPerMps, kKmhPerKnot = kMpsPerKnot * kKmhPerMps;
    static constexpr TagUnit kUnits[] = {
        {"km/h", 1.0},          {"kmh", 1.0},          {"km/hr", 1.0},       {"kph", 1.0},
        {"kmph", 1.0},          {"mph", kKmhPerMph},   {"mi/h", kKmhPerMph}, {"miles/h", kKmhPerMph},
        {"knots", kKmhPerKnot}, {"knot", kKmhPerKnot}, {"kn", kKmhPerKnot},  {"kt", kKmhPerKnot},
        {"kts", kKmhPerKnot},   {"m/s", kKmhPerMps}};
    return TagQuantityReader(text, kUnits).read();
}

/// Reads a number without a unit: "3", "2.5", "2;3" (the first). Otherwise as metresOfTag().
inline std::optional<double> numberOfTag(std::string_view text)
{
    return TagQuantityReader(text, {}).read();
}

} // namespace foundation
