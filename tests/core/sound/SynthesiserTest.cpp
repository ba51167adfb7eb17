// SPDX-License-Identifier: Apache-2.0
// What is heard, measured in the samples: frequencies, levels, Doppler shift, silence, the same bytes.
#include "simulation/sound/Synthesiser.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "TestFolder.h"
#include "simulation/sound/WaveFile.h"

namespace
{

using namespace simulation;

constexpr int kFrames = Synthesiser::kRate; // a second

/// A second of a steady state, left channel, after half a second to settle.
std::vector<double> secondOf(const SoundState& state)
{
    Synthesiser synthesiser;
    std::vector<float> samples(2 * kFrames);
    synthesiser.render(state, {samples.data(), static_cast<std::size_t>(kFrames)});
    synthesiser.render(state, samples);
    std::vector<double> left;
    for (std::size_t i = 0; i < samples.size(); i += 2)
        left.push_back(samples[i]);
    return left;
}

/// A Hann window of mean 1, from a table.
double windowAt(std::size_t i, std::size_t count)
{
    static std::vector<double> table;
    if (table.size() != count)
    {
        table.resize(count);
        for (std::size_t k = 0; k < count; ++k)
            table[k] =
                1.0 - std::cos(2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count));
    }
    return table[i];
}

/// The amplitude at a frequency under a Hann window, by the recurrence of Goertzel (1958).
double amplitudeAt(const std::vector<double>& samples, double hz)
{
    const auto count = static_cast<double>(samples.size());
    const double turn = 2.0 * std::numbers::pi * hz / Synthesiser::kRate, factor = 2.0 * std::cos(turn);
    double last = 0.0, before = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
        const double window = windowAt(i, samples.size());
        const double next = window * samples[i] + factor * last - before;
        before = last;
        last = next;
    }
    return 2.0 * std::sqrt(last * last + before * before - factor * last * before) / count;
}

/// The strongest frequency between two, to half a hertz.
double peakHz(const std::vector<double>& samples, double from, double to)
{
    double best = from, most = 0.0;
    for (double hz = from; hz <= to; hz += 0.5)
        if (const double amplitude = amplitudeAt(samples, hz); amplitude > most)
        {
            most = amplitude;
            best = hz;
        }
    return best;
}

double levelOf(const std::vector<double>& samples)
{
    double sum = 0.0;
    for (const double sample : samples)
        sum += sample * sample;
    return std::sqrt(sum / static_cast<double>(samples.size()));
}

TEST(Sound, AnEngineIsHeardAtItsFiringFrequency)
{
    EXPECT_EQ(firingHz(3000.0, 4), 100.0);
    for (const double rpm : {750.0, 1500.0, 2400.0, 4200.0, 6300.0})
    {
        SoundState state;
        state.engineHz = firingHz(rpm, 4);
        state.engineLoad = 0.6;
        const double peak = peakHz(secondOf(state), 15.0, 260.0);
        EXPECT_NEAR(peak, state.engineHz, 0.5) << rpm;
        // The control: an engine of six cylinders is not taken for it.
        EXPECT_GT(std::abs(peak - firingHz(rpm, 6)), 5.0);
    }
}

TEST(Sound, AnEngineUnderLoadIsLouder)
{
    SoundState state;
    state.engineHz = 90.0;
    double before = 0.0;
    for (const double load : {0.0, 0.25, 0.5, 0.75, 1.0})
    {
        state.engineLoad = load;
        const double level = levelOf(secondOf(state));
        EXPECT_GT(level, 1.1 * before);
        before = level;
    }
}

SoundState passing(double distanceM, double recedingMps, double leftShare = 0.0)
{
    SoundState state;
    state.passing.push_back({7, distanceM, recedingMps, leftShare, 100.0, 1.0});
    return state;
}

TEST(Sound, OthersAreHeardAtTheirDopplerShift)
{
    for (const double mps : {-60.0, -20.0, 0.0, 20.0, 60.0})
        EXPECT_NEAR(peakHz(secondOf(passing(5.0, mps)), 70.0, 130.0), 100.0 * 340.0 / (340.0 + mps), 0.5)
            << mps;
    // The control: a source that stands is not heard as one that moves.
    EXPECT_GT(std::abs(peakHz(secondOf(passing(5.0, 0.0)), 70.0, 130.0) - 100.0 * 340.0 / 360.0), 2.0);
}

TEST(Sound, OthersAreHeardByTheirDistance)
{
    const double near = amplitudeAt(secondOf(passing(4.0, 0.0)), 100.0);
    for (const double distanceM : {8.0, 20.0, 80.0, 320.0})
        EXPECT_NEAR(amplitudeAt(secondOf(passing(distanceM, 0.0)), 100.0) * distanceM / 4.0, near,
                    0.02 * near)
            << distanceM;
}

TEST(Sound, OthersAreHeardOnTheirSide)
{
    Synthesiser synthesiser;
    std::vector<float> samples(2 * 4410);
    synthesiser.render(passing(5.0, 0.0, 1.0), samples);
    double left = 0.0, right = 0.0;
    for (std::size_t i = 0; i < samples.size(); i += 2)
    {
        left += std::abs(samples[i]);
        right += std::abs(samples[i + 1]);
    }
    EXPECT_GT(left, 100.0);
    EXPECT_EQ(right, 0.0);
}

TEST(Sound, NothingIsHeardOfNothing)
{
    EXPECT_EQ(levelOf(secondOf({})), 0.0);
    SoundState wind;
    wind.airspeedMps = 40.0;
    EXPECT_GT(levelOf(secondOf(wind)), 0.005); // the control
}

TEST(Sound, EachGroundSoundsOfItsOwn)
{
    SoundState state;
    state.rollingMps = 25.0;
    double least = 1.0;
    std::vector<double> levels;
    for (const TyreSound tyres :
         {TyreSound::none, TyreSound::soft, TyreSound::hard, TyreSound::wet, TyreSound::loose})
    {
        state.tyres = tyres;
        levels.push_back(levelOf(secondOf(state)));
    }
    EXPECT_EQ(levels[0], 0.0);
    for (std::size_t i = 1; i < levels.size(); ++i)
        for (std::size_t k = i + 1; k < levels.size(); ++k)
            least = std::min(least, std::abs(levels[i] / levels[k] - 1.0));
    EXPECT_GT(least, 0.1);
    // Hard ground squeals where a tyre slides.
    state.tyres = TyreSound::hard;
    const double rolling = amplitudeAt(secondOf(state), 980.0);
    state.tyreSlip = 1.5;
    EXPECT_GT(amplitudeAt(secondOf(state), 980.0), 5.0 * rolling);
}

TEST(Sound, TheStallHornAndBumpsAndClicksAreHeard)
{
    SoundState state;
    state.stallHorn = 1.0;
    EXPECT_NEAR(peakHz(secondOf(state), 700.0, 780.0), 740.0, 0.5);
    const auto loudest = [](const SoundState& first, const SoundState& second)
    {
        Synthesiser synthesiser;
        std::vector<float> samples(2 * 4410);
        synthesiser.render(first, samples);
        synthesiser.render(second, samples);
        return *std::max_element(samples.begin(), samples.end());
    };
    SoundState bump, lit;
    bump.bumpMps = 1.0;
    lit.isIndicatorLit = true;
    EXPECT_GT(loudest({}, bump), 0.02F);
    EXPECT_GT(loudest({}, lit), 0.05F);
    EXPECT_GT(loudest(lit, {}), 0.05F);
    EXPECT_EQ(loudest(lit, lit), 0.0F);
}

TEST(Sound, StaysWithinTheRangeWhateverItIsTold)
{
    SoundState state;
    state.engineHz = state.propellerHz = state.airspeedMps = state.rollingMps = state.tyreSlip =
        state.bumpMps = 1e9;
    state.engineLoad = state.stallHorn = 1e9;
    state.tyres = TyreSound::hard;
    for (std::uint64_t i = 0; i < 20; ++i)
        state.passing.push_back({i, 0.0, -1e9, 5.0, 300.0, 10.0});
    for (const double sample : secondOf(state))
        ASSERT_TRUE(std::isfinite(sample) && std::abs(sample) <= 1.0);
}

TEST(Sound, AWaveFileHasItsLengthsAndTheSameBytesTwice)
{
    const testsupport::TestFolder folder("sound");
    const auto write = [&](const std::string& name, double hz)
    {
        Synthesiser synthesiser;
        WaveFile file(folder / name, Synthesiser::kRate);
        std::vector<float> samples(2000);
        SoundState state;
        state.engineHz = hz;
        state.airspeedMps = 50.0;
        for (int i = 0; i < 10; ++i)
        {
            synthesiser.render(state, samples);
            EXPECT_TRUE(file.add(samples));
        }
        EXPECT_FALSE(std::filesystem::exists(folder / name)) << "it has its name before it is whole";
        EXPECT_TRUE(file.finish());
        return testsupport::bytesOf(folder / name);
    };
    const std::string first = write("a.wav", 80.0);
    ASSERT_EQ(first.size(), 44U + 40'000U);
    EXPECT_EQ(first.substr(0, 4) + first.substr(8, 8), "RIFFWAVEfmt ");
    const auto number = [&](std::size_t at)
    {
        std::uint32_t value = 0;
        for (int i = 3; i >= 0; --i)
            value = value << 8 | static_cast<unsigned char>(first[at + static_cast<std::size_t>(i)]);
        return value;
    };
    EXPECT_EQ(number(4), 36U + 40'000U);
    EXPECT_EQ(number(24), 44'100U);
    EXPECT_EQ(number(40), 40'000U);
    EXPECT_TRUE(first == write("b.wav", 80.0));
    EXPECT_FALSE(first == write("c.wav", 80.1)); // the control
}

TEST(Sound, AFileThatCannotBeWrittenIsSaid)
{
    WaveFile file("/nowhere/a.wav", Synthesiser::kRate);
    const std::vector<float> samples(100);
    EXPECT_FALSE(file.add(samples));
    WaveFile full("/dev/full", Synthesiser::kRate);
    bool isSaid = false;
    for (int i = 0; i < 200 && !isSaid; ++i)
        isSaid = !full.add(std::vector<float>(4096));
    EXPECT_TRUE(isSaid || !full.finish());
}

} // namespace
