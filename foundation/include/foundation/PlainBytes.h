// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace foundation
{

static_assert(std::endian::native == std::endian::little, "files keep the machine's numbers");

/// Appends a value as the machine keeps it.
template<class Value>
void appendValue(std::string& bytes, const Value& value)
{
    static_assert(std::is_trivially_copyable_v<Value>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(Value));
}

/// Appends the number of values, and the values.
template<class Value>
void appendValues(std::string& bytes, const std::vector<Value>& values)
{
    static_assert(std::is_trivially_copyable_v<Value>);
    appendValue(bytes, static_cast<std::uint64_t>(values.size()));
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
}

/// Appends the length of a text, and the text.
inline void appendText(std::string& bytes, std::string_view text)
{
    appendValue(bytes, static_cast<std::uint64_t>(text.size()));
    bytes += text;
}

/// Appends the number of texts, and each.
inline void appendTexts(std::string& bytes, const std::vector<std::string>& texts)
{
    appendValue(bytes, static_cast<std::uint64_t>(texts.size()));
    for (const std::string& text : texts)
        appendText(bytes, text);
}

/// Takes values off the front of bytes that appendValue(), appendValues() and appendText() made.
class ValueTaker
{
public:
    explicit ValueTaker(std::string_view bytes) : _bytes(bytes) {}

    /// False: there are too few bytes.
    template<class Value>
    bool take(Value& value)
    {
        static_assert(std::is_trivially_copyable_v<Value>);
        if (_bytes.size() < sizeof(Value)) return false;
        std::memcpy(&value, _bytes.data(), sizeof(Value));
        _bytes.remove_prefix(sizeof(Value));
        return true;
    }

    template<class Value>
    bool take(std::vector<Value>& values)
    {
        static_assert(std::is_trivially_copyable_v<Value>);
        std::uint64_t count = 0;
        if (!take(count) || count > _bytes.size() / sizeof(Value)) return false;
        values.resize(static_cast<std::size_t>(count));
        const std::size_t size = values.size() * sizeof(Value);
        if (size > 0) std::memcpy(static_cast<void*>(values.data()), _bytes.data(), size);
        _bytes.remove_prefix(size);
        return true;
    }

    bool take(std::string& text)
    {
        std::string_view view;
        if (!take(view)) return false;
        text = view;
        return true;
    }

    /// A view into the bytes, that lives as long as they do.
    bool take(std::string_view& text)
    {
        std::uint64_t size = 0;
        if (!take(size) || size > _bytes.size()) return false;
        text = _bytes.substr(0, static_cast<std::size_t>(size));
        _bytes.remove_prefix(static_cast<std::size_t>(size));
        return true;
    }

    bool take(std::vector<std::string>& texts)
    {
        std::uint64_t count = 0;
        if (!takeCount(count, sizeof(count))) return false;
        texts.resize(static_cast<std::size_t>(count));
        for (std::string& text : texts)
            if (!take(text)) return false;
        return true;
    }

    /// The number of things that follow, each of `leastBytes` at least. False: so many cannot follow.
    bool takeCount(std::uint64_t& count, std::size_t leastBytes)
    {
        return take(count) && count <= _bytes.size() / leastBytes;
    }

    bool isEmpty() const { return _bytes.empty(); }

private:
    std::string_view _bytes;
};

} // namespace foundation
