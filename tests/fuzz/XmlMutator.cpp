// SPDX-License-Identifier: Apache-2.0
// Mutates XML so that most of it stays XML: what lies behind the parser of XML is reached. For fuzzers of XML
// formats.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

// NOLINTBEGIN(readability-identifier-naming): the names are libFuzzer's
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                               unsigned seed);
// NOLINTEND(readability-identifier-naming)

namespace
{

constexpr const char* kValues[] = {"0",    "1",     "-1",   "2",    "0.1",   "-0.5",   "7",       "50",
                                   "1000", "1e6",   "1e12", "1e-9", "1e308", "1e-308", "-1e12",   "nan",
                                   "",     "1e999", "true", "-4",   "1.5",   "0.001",  "6.28318", "99999999"};

/// A stretch of a text.
struct Stretch
{
    std::size_t at = 0, length = 0;
};

/// The value of an attribute somewhere behind a random place; a length of npos where there is none.
Stretch anyValue(const std::string& text, std::minstd_rand& random)
{
    const std::size_t open = text.find("=\"", random() % text.size());
    const std::size_t close = open == std::string::npos ? open : text.find('"', open + 2);
    if (close == std::string::npos) return {0, std::string::npos};
    return {open + 2, close - open - 2};
}

/// An element without children somewhere behind a random place; a length of npos where there is none.
Stretch anyElement(const std::string& text, std::minstd_rand& random)
{
    const std::size_t close = text.find("/>", random() % text.size());
    const std::size_t open = close == std::string::npos ? close : text.rfind('<', close);
    if (open == std::string::npos) return {0, std::string::npos};
    return {open, close + 2 - open};
}

void replaceValue(std::string& text, std::minstd_rand& random)
{
    const Stretch at = anyValue(text, random);
    if (at.length == std::string::npos) return;
    const Stretch other = anyValue(text, random);
    const bool takesOther = random() % 3 == 0 && other.length != std::string::npos;
    text.replace(at.at, at.length,
                 takesOther ? text.substr(other.at, other.length) : kValues[random() % std::size(kValues)]);
}

void repeatElement(std::string& text, std::minstd_rand& random)
{
    const Stretch element = anyElement(text, random), before = anyElement(text, random);
    if (element.length != std::string::npos && before.length != std::string::npos)
        text.insert(before.at, text.substr(element.at, element.length));
}

void removeElement(std::string& text, std::minstd_rand& random)
{
    const Stretch element = anyElement(text, random);
    if (element.length != std::string::npos) text.erase(element.at, element.length);
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                               unsigned seed)
{
    std::minstd_rand random(seed + 1u);
    if (size == 0 || random() % 4 == 0) return LLVMFuzzerMutate(data, size, maxSize);
    std::string text(reinterpret_cast<const char*>(data), size);
    for (unsigned edits = 1 + static_cast<unsigned>(random() % 4); edits > 0 && !text.empty(); --edits)
        switch (random() % 8)
        {
        case 0:
            repeatElement(text, random);
            break;
        case 1:
            removeElement(text, random);
            break;
        default:
            replaceValue(text, random);
        }
    const std::size_t length = std::min(text.size(), maxSize);
    std::copy_n(text.begin(), length, data);
    return length;
}
