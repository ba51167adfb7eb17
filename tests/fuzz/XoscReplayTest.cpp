// SPDX-License-Identifier: Apache-2.0
// The fuzz target without a fuzzer: the corpus and seeded mutations of it, the same in every run.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "simulation/parser/ParseScenario.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

constexpr int kMutationsPerSeed = 500;

std::vector<std::string> corpus()
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(OSGTRAINER_SOURCE_DIR "/tests/fuzz/corpus"))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<std::string> texts;
    for (const std::filesystem::path& file : files)
    {
        std::ifstream stream(file, std::ios::binary);
        texts.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    }
    return texts;
}

/// SplitMix64: the same numbers with every library.
class Random
{
public:
    explicit Random(std::uint64_t seed) : _state(seed) {}
    std::uint64_t next()
    {
        std::uint64_t z = _state += 0x9E3779B97F4A7C15u;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }
    std::size_t below(std::size_t limit)
    {
        return static_cast<std::size_t>(next() % std::max<std::size_t>(1, limit));
    }

private:
    std::uint64_t _state;
};

const std::vector<std::string> kWords = {"\"",          "<",
                                         ">",           "/>",
                                         "${",          "}",
                                         "$p",          "nan",
                                         "-1",          "1e308",
                                         "1e-308",      "0",
                                         "99999999",    "<Vertex/>",
                                         "time=\"0\"",  "<!--",
                                         "]]>",         "&#0;",
                                         "\xFF\xFE",    "<Position>",
                                         "</Position>", "0.1 / 0",
                                         "follow",      "Ego",
                                         "((((((",      "closed=\"true\""};

const std::vector<std::string> kValues = {
    "0",        "-1",         "1e308",  "1e-308", "99999999", "0.1",           "$p",
    "${1/3}",   "nan",        "follow", "true",   "Ego",      "air",           "rate",
    "step",     "sinusoidal", "1e9",    "act",    "none",     "completeState", "",
    "absolute", "-1e308",     "rising", "31",     "2.5"};

/// Puts a word for the value of one attribute: the text stays XML, so that what lies behind the XML is
/// reached.
void replaceAttribute(std::string& text, Random& random)
{
    const std::size_t open = text.find("=\"", random.below(text.size()));
    if (open == std::string::npos) return;
    const std::size_t close = text.find('"', open + 2);
    if (close == std::string::npos) return;
    text.replace(open + 2, close - open - 2, kValues[random.below(kValues.size())]);
}

std::string mutated(const std::string& seed, const std::vector<std::string>& texts, Random& random)
{
    std::string text = seed;
    const std::size_t edits = 1 + random.below(4);
    for (std::size_t edit = 0; edit < edits; ++edit)
    {
        const std::size_t at = random.below(text.size());
        const std::size_t length = std::min(text.size() - at, 1 + random.below(40));
        switch (random.below(16))
        {
        case 0:
            text.erase(at, length);
            break;
        case 1:
            text.insert(at, text.substr(at, length));
            break;
        case 2:
            text.insert(at, kWords[random.below(kWords.size())]);
            break;
        case 3:
            text.replace(at, length, kWords[random.below(kWords.size())]);
            break;
        case 4:
            if (!text.empty()) text[at] = static_cast<char>(random.next());
            break;
        case 5:
        {
            const std::string& other = texts[random.below(texts.size())];
            const std::size_t from = random.below(other.size());
            text.insert(at, other.substr(from, 1 + random.below(200)));
            break;
        }
        default:
            replaceAttribute(text, random);
        }
    }
    return text;
}

void run(const std::string& text)
{
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

TEST(XoscReplay, CorpusAndMutationsNeitherCrashNorHang)
{
    const std::vector<std::string> texts = corpus();
    ASSERT_GE(texts.size(), 5u);
    Random random(20240101);
    std::size_t runs = 0;
    std::size_t readable = 0;
    for (const std::string& seed : texts)
    {
        run(seed);
        for (int i = 0; i < kMutationsPerSeed; ++i, ++runs)
        {
            const std::string text = mutated(seed, texts, random);
            run(text);
            if (simulation::parseScenario(text, "mutation")) ++readable;
        }
    }
    EXPECT_GE(runs, 2000u);
    EXPECT_GE(readable, 200u) << "mutations that are not read test nothing behind the parser";
}

} // namespace
