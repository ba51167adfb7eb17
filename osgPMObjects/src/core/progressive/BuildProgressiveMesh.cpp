// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <limits>

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>

#include "FaceArrangement.h"
#include "StepRecord.h"

namespace osgPMObjects::core
{

namespace
{

/// Walks down the levels and writes a record for each step.
class Recorder
{
public:
    Recorder(const SplitOrder& split, const ArrangementSettings& settings)
        : _walk(split), _arrangement(makeArrangement(settings))
    {
        _arrangement->begin(_walk, _slots);
    }

    /// Writes the groups and blocks of the finest level.
    void layOut(ProgressiveMesh& progressive) const
    {
        for (const SlotBlock& block : _slots.blocks())
        {
            if (progressive.groups.empty() || progressive.groups.back().material != block.group)
                progressive.groups.push_back(
                    {block.group, static_cast<std::uint32_t>(progressive.blocks.size())});
            progressive.blocks.push_back({block.first});
        }
        progressive.slotCount = _slots.slotCount();
        progressive.slotBytes = widthFor(progressive.slotCount);
        progressive.wedgeBytes = widthFor(progressive.mesh.wedgeCount());
    }

    /// Writes the faces of the coarsest level.
    void keepBase(ProgressiveMesh& progressive) const
    {
        for (std::uint32_t b = 0; b < progressive.blocks.size(); ++b)
        {
            const SlotBlock& block = _slots.blocks()[b];
            progressive.blocks[b].extent = block.extent;
            for (std::uint32_t i = 0; i < block.extent; ++i)
            {
                const std::uint32_t face = _slots.faceAt(block.first + i);
                progressive.base.push_back(face == SlotTable::kNone ? Triangle{} : _walk.triangle(face));
            }
        }
    }

    void recordSteps(ProgressiveMesh& progressive)
    {
        while (_walk.stepsTaken() < _walk.stepCount())
            recordStep(progressive);
        progressive.stepCount = _walk.stepCount();
        progressive.records.resize(progressive.records.size() + kRecordPadding);
        progressive.records.shrink_to_fit();
    }

private:
    void recordStep(ProgressiveMesh& progressive)
    {
        const std::uint32_t wedges = _walk.wedgeCount();
        _walk.step();
        StepRecord step;
        step.patchedOfWedge.assign(wedges - _walk.wedgeCount(), 0);
        std::vector<LevelWalk::Patch> patches = _walk.patches();
        std::sort(patches.begin(), patches.end(),
                  [this](const LevelWalk::Patch& a, const LevelWalk::Patch& b) {
                      return a.from != b.from ? a.from > b.from
                                              : _slots.slotOf(a.face) < _slots.slotOf(b.face);
                  });
        std::vector<Triangle> patched;
        for (const LevelWalk::Patch& patch : patches)
        {
            ++step.patchedOfWedge[wedges - 1 - patch.from];
            step.patched.push_back(_slots.slotOf(patch.face));
            patched.push_back(_walk.triangle(patch.face));
        }
        std::vector<std::uint32_t> dead = _walk.vanished();
        std::sort(dead.begin(), dead.end(),
                  [this](std::uint32_t a, std::uint32_t b) { return _slots.slotOf(a) < _slots.slotOf(b); });
        for (const std::uint32_t face : dead)
        {
            step.vanished.push_back(_slots.slotOf(face));
            step.vanishedTriangles.push_back(_walk.triangle(face));
            _slots.removeFace(face);
        }
        _arrangement->afterStep(_walk, _slots);
        step.rearrangements = _slots.takeRearrangements();
        appendRecord(progressive, step, patched, wedges, _slots.blocks());
        noteNeeds(progressive, step);
    }

    static void noteNeeds(ProgressiveMesh& progressive, const StepRecord& step)
    {
        const auto raise = [](std::uint32_t& most, std::size_t value)
        { most = std::max(most, static_cast<std::uint32_t>(value)); };
        raise(progressive.mostSlotsOfStep, step.patched.size() + step.vanished.size());
        raise(progressive.mostRearrangements, step.rearrangements.size());
        for (const Rearrangement& rearrangement : step.rearrangements)
        {
            std::size_t slots = rearrangement.slots.size();
            if (rearrangement.kind == RearrangementKind::rewrite)
                for (const std::uint32_t extent : rearrangement.extents)
                    slots += extent;
            if (rearrangement.kind == RearrangementKind::cycles)
                slots = rearrangement.extents.front() - slots;
            raise(progressive.mostSlotsMoved, slots);
        }
    }

    LevelWalk _walk;
    SlotTable _slots;
    std::unique_ptr<FaceArrangement> _arrangement;
};

std::vector<LevelError> thinned(const std::vector<LevelError>& errors)
{
    std::vector<LevelError> kept;
    for (std::size_t step = ProgressiveMesh::kErrorStride; step < errors.size();
         step += ProgressiveMesh::kErrorStride)
        kept.push_back(errors[step - 1]);
    if (!errors.empty()) kept.push_back(errors.back());
    return kept;
}

} // namespace

ProgressiveMesh buildProgressiveMesh(const Mesh& mesh, const CollapseSequence& sequence,
                                     const ArrangementSettings& settings)
{
    assert(checkSettings(settings));
    const SplitOrder split = inSplitOrder(mesh, sequence);
    ProgressiveMesh progressive;
    Recorder recorder(split, settings);
    progressive.mesh = split.mesh;
    progressive.mesh.faces.clear();
    progressive.parents = split.parents;
    progressive.errors = thinned(split.errors);
    recorder.layOut(progressive);
    recorder.recordSteps(progressive);
    recorder.keepBase(progressive);
    return progressive;
}

std::uint32_t ProgressiveMesh::wedgesAfter(std::uint32_t steps) const
{
    const auto& positions = mesh.wedgePositions; // ascending
    const auto left = static_cast<std::uint32_t>(mesh.positions.size()) - steps;
    return static_cast<std::uint32_t>(std::lower_bound(positions.begin(), positions.end(), left) -
                                      positions.begin());
}

std::size_t ProgressiveMesh::overheadBytes() const
{
    const std::size_t indexBytes = mesh.wedgeCount() < std::numeric_limits<std::uint16_t>::max() ? 2 : 4;
    return records.size() + parents.size() * indexBytes + groups.size() * sizeof(FaceGroup) +
           blocks.size() * sizeof(FaceBlock) + errors.size() * sizeof(LevelError) +
           ladder.size() * sizeof(MeasuredLevel) + 3 * base.size() * indexBytes;
}

LevelError errorAfter(const ProgressiveMesh& progressive, std::uint32_t steps)
{
    steps = std::min(steps, progressive.stepCount);
    return steps == 0 ? progressive.finestError
                      : progressive.errors[(steps - 1) / ProgressiveMesh::kErrorStride];
}

std::uint32_t stepsToDistance(const ProgressiveMesh& progressive, double tolerance, ErrorKind kind)
{
    if (!progressive.ladder.empty()) return ErrorLadder(progressive.ladder).coarsestWithin(tolerance, kind);
    const auto above = std::partition_point(progressive.errors.begin(), progressive.errors.end(),
                                            [&](const LevelError& e) { return e.distance <= tolerance; });
    const auto kept = static_cast<std::uint32_t>(above - progressive.errors.begin());
    return std::min(kept * ProgressiveMesh::kErrorStride, progressive.stepCount);
}

} // namespace osgPMObjects::core
