// SPDX-License-Identifier: Apache-2.0
// tswap: new orders of faces as cycles.
#include <algorithm>
#include <numeric>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include <osgPMObjects/core/progressive/PmFile.h>
#include <osgPMObjects/core/progressive/ProgressiveLevel.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "DrawnFaces.h"
#include "GreedyOrder.h"
#include "PmCheckSums.h"
#include "Random.h"
#include "RecordPacking.h"
#include "ScannedMeshes.h"
#include "SlotCycles.h"
#include "StepRecord.h"
#include "TableForm.h"

namespace
{

using namespace osgPMObjects::core;

constexpr std::uint32_t kHoleFace = ~0u;

/// tswap as the paper has it: the face in each slot of a cycle moves to the slot before.
void tswap(std::vector<std::uint32_t>& faces, const std::vector<std::uint32_t>& cycle)
{
    const std::uint32_t first = faces[cycle.front()];
    for (std::size_t i = 0; i + 1 < cycle.size(); ++i)
        faces[cycle[i]] = faces[cycle[i + 1]];
    faces[cycle.back()] = first;
}

void tswapBack(std::vector<std::uint32_t>& faces, const std::vector<std::uint32_t>& cycle)
{
    const std::uint32_t last = faces[cycle.back()];
    for (std::size_t i = cycle.size() - 1; i > 0; --i)
        faces[cycle[i]] = faces[cycle[i - 1]];
    faces[cycle.front()] = last;
}

TEST(SlotCycles, TakeHolesToTheEndInOneCycle) // by hand
{
    // Slots 1 and 4 are holes. Afterwards: faces a e c d, of which e comes from slot 5, and d from 3.
    const std::vector<std::uint32_t> sources{0, 5, 2, 3};
    const SlotCycles cycles(sources, 6);
    EXPECT_EQ(cycles.throughHoles, (std::vector<std::uint32_t>{1, 5, 4}));
    EXPECT_TRUE(cycles.others.empty());
    const SlotCycles turned(std::vector<std::uint32_t>{2, 0, 1, 3}, 4);
    EXPECT_TRUE(turned.throughHoles.empty());
    EXPECT_EQ(turned.others, (std::vector<std::vector<std::uint32_t>>{{0, 2, 1}}));
}

TEST(SlotCycles, AreTheTableAndTheirOwnInverse)
{
    testsupport::Random random(11);
    for (int round = 0; round < 400; ++round)
    {
        const std::uint32_t extent = 1 + random.below(60), live = random.below(extent + 1);
        std::vector<std::uint32_t> sources(extent);
        std::iota(sources.begin(), sources.end(), 0u);
        for (std::uint32_t i = extent; i > 1; --i)
            if (random.below(3) == 0) std::swap(sources[i - 1], sources[random.below(i)]);
        sources.resize(live);
        std::vector<std::uint32_t> faces(extent, kHoleFace);
        for (const std::uint32_t source : sources)
            faces[source] = 1000 + source;
        const std::vector<std::uint32_t> before = faces;
        const SlotCycles cycles(sources, extent);
        const auto holes = static_cast<std::uint32_t>(std::ranges::count(before, kHoleFace));
        std::size_t moves = cycles.throughHoles.size() - holes, changed = 0;
        if (!cycles.throughHoles.empty()) tswap(faces, cycles.throughHoles);
        for (const auto& cycle : cycles.others)
        {
            EXPECT_GT(cycle.size(), 1u);
            tswap(faces, cycle);
            moves += cycle.size();
        }
        for (std::uint32_t slot = 0; slot < extent; ++slot)
        {
            EXPECT_EQ(faces[slot], slot < live ? 1000 + sources[slot] : kHoleFace);
            changed += slot < live && sources[slot] != slot;
        }
        EXPECT_EQ(moves, changed) << "the slots that change, alone";
        for (const auto& cycle : cycles.others)
            tswapBack(faces, cycle);
        if (!cycles.throughHoles.empty()) tswapBack(faces, cycles.throughHoles);
        EXPECT_EQ(faces, before);
    }
}

TEST(GreedyOrder, LeavesFacesInTheirSlotsAndPrefersTouchedLines)
{
    // After the first, the second costs two and the third, with the same vertices as the first, nothing.
    const std::vector<Triangle> three{{0, 1, 2}, {2, 3, 4}, {1, 2, 0}};
    const auto orderOf = [&](float stays, std::vector<std::uint32_t> positions) {
        return greedyOrder(three, 5, {16, {stays, 0.0f}, 1}, {std::move(positions), {}});
    };
    using Order = std::vector<std::uint32_t>;
    EXPECT_EQ(orderOf(1.5f, {0, 1, 2}), (Order{0, 2, 1}));
    EXPECT_EQ(orderOf(2.5f, {0, 1, 2}), (Order{0, 1, 2})) << "it stays where it is";
    EXPECT_EQ(orderOf(2.5f, {0, 2, 3}), (Order{0, 2, 1})) << "the third fills the hole, and the second stays";
    std::vector<Triangle> apart;
    for (std::uint32_t t = 0; t < 30; ++t)
        apart.push_back({0, 1, 2 + t}); // each costs one
    GreedyPlaces touched;
    touched.isTouched.resize(30, false);
    touched.isTouched[25] = true;
    const std::vector<std::uint32_t> order = greedyOrder(apart, 32, {16, {0.0f, 0.25f}, 1}, touched);
    EXPECT_EQ(order[1] / 10, 2u) << "from the line that is written anyway";
    EXPECT_EQ(greedyOrder(apart, 32, {16, {0.0f, 0.0f}, 1}, touched)[1], 1u) << "without the weight";
}

std::vector<std::uint32_t> allIndices(const ProgressiveLevel& level)
{
    if (!level.hasNarrowIndices()) return {level.wideIndices().begin(), level.wideIndices().end()};
    return {level.narrowIndices().begin(), level.narrowIndices().end()};
}

TEST(Tswap, ByCyclesHasTheBuffersOfTablesBitForBit)
{
    std::vector<testsupport::ProgressiveSubject> subjects = testsupport::progressiveSubjects();
    subjects.push_back({"scanned", testsupport::scannedBlob(12)});
    for (const auto& subject : subjects)
    {
        const CollapseSequence sequence = simplify(subject.mesh);
        for (const float step : {0.02f, 0.2f, 1.0f})
        {
            const ProgressiveMesh cycles = buildProgressiveMesh(
                subject.mesh, sequence, {.arrangement = Arrangement::tswap, .tswapStep = step});
            testsupport::TableForm form(cycles);
            const ProgressiveMesh tables = form.tables();
            ASSERT_TRUE(isValid(tables)) << subject.name;
            EXPECT_GT(form.changes(), 0u) << subject.name;
            EXPECT_NE(tables.records, cycles.records);
            ProgressiveLevel byCycles(cycles), byTables(tables);
            for (std::uint32_t i = 0; i <= 2 * cycles.stepCount; ++i)
            {
                const std::uint32_t steps = i <= cycles.stepCount ? i : 2 * cycles.stepCount - i;
                byCycles.moveTo(steps);
                byTables.moveTo(steps);
                ASSERT_EQ(allIndices(byCycles), allIndices(byTables)) << subject.name << ", step " << steps;
            }
            EXPECT_EQ(byCycles.statistics().facesMoved, byTables.statistics().facesMoved);
        }
    }
}

TEST(Tswap, ComesBackFromAFileAndFromEachOfItsPrefixes)
{
    const Mesh mesh = testsupport::waves(30, 30);
    const ProgressiveMesh progressive =
        buildProgressiveMesh(mesh, simplify(mesh), {.arrangement = Arrangement::tswap});
    std::istringstream stream(pmBytes(progressive));
    PmReader reader(stream, "tswap.pm");
    for (auto more = reader.readMore(); more && *more; more = reader.readMore())
        EXPECT_TRUE(reader.mesh());
    const auto back = reader.mesh();
    ASSERT_TRUE(back) << back.error().message();
    EXPECT_EQ(back->records, progressive.records);
    EXPECT_EQ(back->mostSlotsMoved, progressive.mostSlotsMoved);
}

/// The bytes of a whole file without its vertices: they are the same for all orders.
std::size_t bytesOfSteps(const ProgressiveMesh& progressive)
{
    return packedRecords(progressive,
                         std::span(progressive.records).first(progressive.records.size() - kRecordPadding))
        .size();
}

TEST(Tswap, TakesNoMoreBytesInFilesThanTheSameOrdersAsTables)
{
    std::vector<testsupport::ProgressiveSubject> subjects = testsupport::progressiveSubjects();
    subjects.push_back({"scanned", testsupport::scannedBlob(12)});
    for (const auto& subject : subjects)
    {
        const CollapseSequence sequence = simplify(subject.mesh);
        for (const float step : {0.02f, 0.2f, 1.0f})
        {
            const ProgressiveMesh cycles = buildProgressiveMesh(
                subject.mesh, sequence, {.arrangement = Arrangement::tswap, .tswapStep = step});
            const std::size_t inFile = bytesOfSteps(cycles);
            EXPECT_LE(inFile, bytesOfSteps(testsupport::TableForm(cycles).tables())) << subject.name;
            EXPECT_LT(inFile + cycles.stepCount, cycles.records.size()) << subject.name; // without lengths
        }
    }
}

TEST(PackedRecords, AreUnpackedBitForBit)
{
    for (const auto& subject : testsupport::progressiveSubjects())
    {
        const CollapseSequence sequence = simplify(subject.mesh);
        for (const Arrangement arrangement :
             {Arrangement::plain, Arrangement::blocks, Arrangement::windows, Arrangement::tswap})
        {
            const ProgressiveMesh mesh =
                buildProgressiveMesh(subject.mesh, sequence, {.arrangement = arrangement, .blockFaces = 64});
            const std::span records = std::span(mesh.records).first(mesh.records.size() - kRecordPadding);
            const std::string packed = packedRecords(mesh, records);
            const auto unpacked = unpackedRecords(mesh, packed, mesh.stepCount);
            ASSERT_TRUE(unpacked) << subject.name;
            const auto* const wanted = reinterpret_cast<const char*>(records.data());
            EXPECT_EQ(*unpacked, std::string(wanted, records.size())) << subject.name;
            EXPECT_FALSE(unpackedRecords(mesh, packed, mesh.stepCount + 1));
            ASSERT_GT(mesh.stepCount, 0u);
            EXPECT_FALSE(unpackedRecords(mesh, packed, mesh.stepCount - 1));
            for (std::size_t cut = 1; cut < packed.size(); cut += 1 + packed.size() / 50)
                EXPECT_FALSE(unpackedRecords(mesh, packed.substr(0, packed.size() - cut), mesh.stepCount));
        }
    }
}

TEST(PackedRecords, OfAnyBytesAreReadWithinTheirEnd)
{
    const Mesh mesh = testsupport::waves(12, 12);
    const ProgressiveMesh progressive =
        buildProgressiveMesh(mesh, simplify(mesh), {.arrangement = Arrangement::tswap});
    const std::string packed = packedRecords(
        progressive, std::span(progressive.records).first(progressive.records.size() - kRecordPadding));
    testsupport::Random random(7);
    std::size_t told = 0;
    constexpr std::size_t kTries = 5000;
    for (std::size_t i = 0; i < kTries; ++i)
    {
        std::string damaged = packed;
        for (std::uint32_t change = 0; change < 1 + i % 3; ++change)
            damaged[random.below(static_cast<std::uint32_t>(damaged.size()))] =
                static_cast<char>(random.below(256));
        // A copy of just its size, so that tools see a byte read behind it.
        const std::vector<char> exact(damaged.begin(), damaged.end());
        const auto records =
            unpackedRecords(progressive, {exact.data(), exact.size()}, progressive.stepCount);
        told += !records;
        EXPECT_LT(records ? records->size() : 0, 64 * packed.size());
    }
    EXPECT_GT(told, kTries / 10);
    ProgressiveMesh wrong = progressive;
    wrong.slotBytes = 0;
    EXPECT_FALSE(unpackedRecords(wrong, packed, progressive.stepCount));
}

/// Writes a number with the lowest byte first.
std::string lowestFirst(std::uint64_t number)
{
    std::string bytes;
    for (int i = 0; i < 8; ++i)
        bytes += static_cast<char>(number >> (8 * i));
    return bytes;
}

TEST(PmFile, OfVersion3IsReadAsItIs)
{
    const Mesh mesh = testsupport::waves(12, 12);
    const ProgressiveMesh progressive =
        buildProgressiveMesh(mesh, simplify(mesh), {.arrangement = Arrangement::tswap});
    const std::string_view records(reinterpret_cast<const char*>(progressive.records.data()),
                                   progressive.records.size() - kRecordPadding);
    PmSettings settings;
    settings.stepSections = 1; // one section has all records, at its end
    std::string file = pmBytes(progressive, settings);
    const std::string packed = packedRecords(
        progressive, std::span(progressive.records).first(progressive.records.size() - kRecordPadding));
    const std::string tail = lowestFirst(packed.size()) + packed;
    const std::size_t section = file.find("STEP"), at = file.find(tail, section);
    ASSERT_NE(at, file.npos);
    file.replace(at, tail.size(), lowestFirst(records.size()) + std::string(records));
    file.replace(section + 4, 8, lowestFirst(at + 8 + records.size() - section - 12));
    file[8] = 3;
    testsupport::renewCheckSums(file);
    std::istringstream stream(file);
    PmReader reader(stream, "old.pm");
    for (auto more = reader.readMore(); more && *more; more = reader.readMore())
        ;
    const auto back = reader.mesh();
    ASSERT_TRUE(back) << back.error().message();
    EXPECT_EQ(back->records, progressive.records);
    EXPECT_EQ(back->stepCount, progressive.stepCount);
}

TEST(Tswap, WithAWrongCycleIsNotValid)
{
    const Mesh mesh = testsupport::waves(9, 9);
    const ProgressiveMesh progressive =
        buildProgressiveMesh(mesh, simplify(mesh), {.arrangement = Arrangement::tswap});
    ASSERT_TRUE(isValid(progressive));
    std::size_t told = 0;
    for (std::size_t at = 0; at + 4 < progressive.records.size(); ++at)
        for (const std::byte change : {std::byte{1}, std::byte{0x40}})
        {
            ProgressiveMesh wrong = progressive;
            wrong.records[at] ^= change;
            told += !isValid(wrong); // else it leads up to another mesh, and back: no index leaves its array
        }
    EXPECT_GT(told, progressive.records.size() / 2);
}

} // namespace
