// SPDX-License-Identifier: Apache-2.0
// A recursive-descent evaluator: or < and < not < sum < product < sign < atom.
#include "simulation/parser/Expression.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <vector>

namespace simulation
{
namespace
{

constexpr int kMaximumDepth = 64;

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}
bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}
bool isLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

class Evaluator
{
public:
    Evaluator(std::string_view text, const ParameterLookup& lookup) : _text(text), _lookup(lookup) {}

    foundation::Result<double> run()
    {
        const double value = disjunction();
        skipBlanks();
        if (_error.empty() && _at < _text.size()) fail("unexpected text");
        if (_error.empty() && !std::isfinite(value)) fail("the value is not finite");
        if (!_error.empty()) return foundation::Error{"", _error, "correct the expression"};
        return value;
    }

private:
    double disjunction()
    {
        double value = conjunction();
        while (acceptWord("or"))
        {
            const double right = conjunction();
            value = value != 0.0 || right != 0.0 ? 1.0 : 0.0;
        }
        return value;
    }

    double conjunction()
    {
        double value = sum();
        while (acceptWord("and"))
        {
            const double right = sum();
            value = value != 0.0 && right != 0.0 ? 1.0 : 0.0;
        }
        return value;
    }

    double sum()
    {
        double value = product();
        while (_error.empty())
        {
            if (accept('+'))
                value += product();
            else if (accept('-'))
                value -= product();
            else
                break;
        }
        return value;
    }

    double product()
    {
        double value = atom();
        while (_error.empty())
        {
            if (accept('*'))
                value *= atom();
            else if (accept('/'))
                value /= divisor();
            else if (accept('%'))
                value = std::fmod(value, divisor());
            else
                break;
        }
        return value;
    }

    double divisor()
    {
        const double value = atom();
        if (value == 0.0) fail("division by zero");
        return value == 0.0 ? 1.0 : value;
    }

    double atom()
    {
        if (_depth >= kMaximumDepth || !_error.empty())
        {
            fail("nested too deeply");
            return 0.0;
        }
        ++_depth;
        const double value = atomInside();
        --_depth;
        return value;
    }

    double atomInside()
    {
        if (accept('-')) return -atom();
        if (accept('+')) return atom();
        if (accept('('))
        {
            const double value = disjunction();
            if (!accept(')')) fail("a closing parenthesis is missing");
            return value;
        }
        skipBlanks();
        if (_at < _text.size() && _text[_at] == '$') return parameter();
        if (_at < _text.size() && (isDigit(_text[_at]) || _text[_at] == '.')) return literal();
        const std::string_view name = word();
        if (name.empty())
        {
            fail("a value is missing");
            return 0.0;
        }
        if (name == "true") return 1.0;
        if (name == "false") return 0.0;
        if (name == "pi" || name == "PI") return std::numbers::pi;
        if (name == "not") return atom() == 0.0 ? 1.0 : 0.0;
        return call(name);
    }

    double parameter()
    {
        ++_at;
        const std::string_view name = word();
        const std::optional<std::string> content = _lookup(name);
        if (!content)
        {
            fail("the parameter $" + std::string(name) + " is not declared");
            return 0.0;
        }
        if (*content == "true") return 1.0;
        if (*content == "false") return 0.0;
        const std::optional<double> value = parseNumber(*content);
        if (!value) fail("the parameter $" + std::string(name) + " is not a number");
        return value.value_or(0.0);
    }

    double literal()
    {
        double value = 0.0;
        const char* const begin = _text.data() + _at;
        const std::from_chars_result read = std::from_chars(begin, _text.data() + _text.size(), value);
        if (read.ec != std::errc()) fail("not a number");
        _at += std::max<std::size_t>(1, static_cast<std::size_t>(read.ptr - begin));
        return value;
    }

    double call(std::string_view name)
    {
        struct Function
        {
            std::string_view name;
            std::size_t arity;
            double (*apply)(double a, double b);
        };
        static constexpr std::array<Function, 17> kFunctions = {{
            {"round", 1, [](double a, double) { return std::round(a); }},
            {"floor", 1, [](double a, double) { return std::floor(a); }},
            {"ceil", 1, [](double a, double) { return std::ceil(a); }},
            {"sqrt", 1, [](double a, double) { return std::sqrt(a); }},
            {"abs", 1, [](double a, double) { return std::fabs(a); }},
            {"sign", 1, [](double a, double) { return a > 0.0 ? 1.0 : (a < 0.0 ? -1.0 : 0.0); }},
            {"sin", 1, [](double a, double) { return std::sin(a); }},
            {"cos", 1, [](double a, double) { return std::cos(a); }},
            {"tan", 1, [](double a, double) { return std::tan(a); }},
            {"asin", 1, [](double a, double) { return std::asin(a); }},
            {"acos", 1, [](double a, double) { return std::acos(a); }},
            {"atan", 1, [](double a, double) { return std::atan(a); }},
            {"exp", 1, [](double a, double) { return std::exp(a); }},
            {"log", 1, [](double a, double) { return std::log(a); }},
            {"pow", 2, [](double a, double b) { return std::pow(a, b); }},
            {"min", 2, [](double a, double b) { return std::fmin(a, b); }},
            {"max", 2, [](double a, double b) { return std::fmax(a, b); }},
        }};
        for (const Function& function : kFunctions)
            if (function.name == name)
            {
                const std::array<double, 2> values = arguments(function.arity);
                return _error.empty() ? function.apply(values[0], values[1]) : 0.0;
            }
        fail("the function or name " + std::string(name) + " is unknown");
        return 0.0;
    }

    std::array<double, 2> arguments(std::size_t count)
    {
        std::array<double, 2> values{};
        if (!accept('(')) fail("an opening parenthesis is missing");
        for (std::size_t i = 0; i < count && _error.empty(); ++i)
        {
            if (i > 0 && !accept(',')) fail("a comma is missing");
            values[i] = disjunction();
        }
        if (!accept(')')) fail("a closing parenthesis is missing");
        return values;
    }

    std::string_view word()
    {
        const std::size_t begin = _at;
        while (_at < _text.size() && (isLetter(_text[_at]) || (_at > begin && isDigit(_text[_at]))))
            ++_at;
        return _text.substr(begin, _at - begin);
    }

    bool acceptWord(std::string_view wanted)
    {
        skipBlanks();
        const std::size_t begin = _at;
        if (_error.empty() && word() == wanted) return true;
        _at = begin;
        return false;
    }

    bool accept(char wanted)
    {
        skipBlanks();
        if (!_error.empty() || _at >= _text.size() || _text[_at] != wanted) return false;
        ++_at;
        return true;
    }

    void skipBlanks()
    {
        while (_at < _text.size() && isBlank(_text[_at]))
            ++_at;
    }

    void fail(const std::string& what)
    {
        if (_error.empty()) _error = what + " at character " + std::to_string(_at + 1);
    }

    std::string_view _text;
    const ParameterLookup& _lookup;
    std::size_t _at = 0;
    int _depth = 0;
    std::string _error;
};

} // namespace

std::optional<double> parseNumber(std::string_view text)
{
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
    double value = 0.0;
    const std::from_chars_result read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string formatNumber(double value)
{
    std::array<char, 64> text{};
    const std::to_chars_result written = std::to_chars(text.data(), text.data() + text.size(), value);
    return std::string(text.data(), written.ptr);
}

foundation::Result<double> evaluateExpression(std::string_view text, const ParameterLookup& lookup)
{
    return Evaluator(text, lookup).run();
}

} // namespace simulation
