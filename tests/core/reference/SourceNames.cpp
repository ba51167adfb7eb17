// SPDX-License-Identifier: Apache-2.0
#include "SourceNames.h"

#include <cctype>

namespace reference
{

namespace
{

bool isWord(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// Where the arguments of a call begin, after its name and template arguments; npos: it is no call.
std::size_t argumentsAt(std::string_view source, std::size_t afterName)
{
    std::size_t at = afterName;
    if (at < source.size() && source[at] == '<') at = source.find('>', at) + 1;
    return at < source.size() && source[at] == '(' ? at + 1 : std::string_view::npos;
}

/// The literals up to the parenthesis that closes the call.
std::vector<std::string> literalsFrom(std::string_view source, std::size_t at)
{
    std::vector<std::string> literals;
    for (int depth = 1; at < source.size() && depth > 0; ++at)
    {
        if (source[at] == '(') ++depth;
        if (source[at] == ')') --depth;
        if (source[at] != '"') continue;
        const std::size_t end = source.find('"', at + 1);
        literals.emplace_back(source.substr(at + 1, end - at - 1));
        at = end;
    }
    return literals;
}

} // namespace

std::vector<std::vector<std::string>> literalsOfCalls(std::string_view source, const std::string& function)
{
    std::vector<std::vector<std::string>> calls;
    for (std::size_t at = source.find(function); at != std::string_view::npos;
         at = source.find(function, at + 1))
    {
        if (at > 0 && isWord(source[at - 1])) continue;
        const std::size_t arguments = argumentsAt(source, at + function.size());
        if (arguments != std::string_view::npos) calls.push_back(literalsFrom(source, arguments));
    }
    return calls;
}

Names literalsOfCalls(std::string_view source, const std::vector<std::string>& functions, bool firstOnly)
{
    Names names;
    for (const std::string& function : functions)
        for (const auto& literals : literalsOfCalls(source, function))
            for (const std::string& literal : literals)
            {
                if (!literal.empty()) names.insert(literal);
                if (firstOnly) break;
            }
    return names;
}

Names literalsOfStatement(std::string_view source, std::string_view name, std::string_view beginning)
{
    Names names;
    for (std::size_t at = source.find(name); at < source.size() && source[at] != ';'; ++at)
    {
        if (source[at] != '"') continue;
        const std::size_t end = source.find('"', at + 1);
        if (end == std::string_view::npos) break;
        const std::string_view literal = source.substr(at + 1, end - at - 1);
        if (!literal.empty() && literal.starts_with(beginning)) names.emplace(literal);
        at = end;
    }
    return names;
}

} // namespace reference
