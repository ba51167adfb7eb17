// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <foundation/Excerpt.h>
#include <foundation/Result.h>

namespace osgTerrainROAM::core
{

/// One line `key = value`, with the data that messages and relative paths need.
struct RoamEntry
{
    std::string place; ///< file:line
    std::string_view key, value;
    std::filesystem::path folder;

    /// Returns an error of this line; of an overlong line it shows an excerpt.
    foundation::Error error(const std::string& what, const std::string& remedy) const
    {
        return {place, foundation::excerpt(what), remedy};
    }
};

/// Parses `least` to `most` finite numbers.
foundation::Result<std::vector<double>> numbers(const RoamEntry& entry, std::size_t least, std::size_t most);

/// Parses a number within [low, high].
foundation::Result<double> numberWithin(const RoamEntry& entry, double low, double high);

/// A path is relative to the folder of the file.
foundation::Outcome assignPath(std::filesystem::path& target, const RoamEntry& entry);

foundation::Error unknownWord(const RoamEntry& entry, const std::string& choices);

template<class Target>
foundation::Outcome assignNumber(Target& target, const RoamEntry& entry, double low, double high)
{
    const auto number = numberWithin(entry, low, high);
    if (!number) return number.error();
    target = *number;
    return foundation::success();
}

/// A word, and the value it stands for.
template<class Value>
struct Word
{
    std::string_view text;
    Value value;
};

template<class Value, std::size_t Count>
foundation::Outcome assignWord(Value& target, const RoamEntry& entry, const Word<Value> (&words)[Count])
{
    std::string choices;
    for (const Word<Value>& word : words)
    {
        if (word.text == entry.value)
        {
            target = word.value;
            return foundation::success();
        }
        choices += (choices.empty() ? "" : ", ") + std::string(word.text);
    }
    return unknownWord(entry, choices);
}

/// Calls visit(entry) for each line `key = value`; blank lines and what follows a # are passed over. Ends
/// with the first error that it returns.
/// `name`: for messages, and for paths. `keys`: those that there are, for messages. Errors: a line of another
/// form, with its number.
foundation::Outcome visitEntries(std::string_view text, const std::filesystem::path& name,
                                 const std::string& keys,
                                 const std::function<foundation::Outcome(const RoamEntry&)>& visit);

/// Reads a file of such lines. Errors: none there; longer than such a text is, or with a zero byte.
foundation::Result<std::string> readEntries(const std::filesystem::path& file);

} // namespace osgTerrainROAM::core
