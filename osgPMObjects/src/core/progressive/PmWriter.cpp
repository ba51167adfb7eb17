// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <foundation/WholeFile.h>
#include <zlib.h>

#include <osgPMObjects/core/progressive/PmFile.h>

#include "NeededPositions.h"
#include "PmVertices.h"
#include "RecordPacking.h"
#include "StepRecord.h"

namespace osgPMObjects::core
{

std::uint32_t pmCheckSum(std::string_view bytes)
{
    return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

namespace
{

void appendSection(PmByteWriter& file, std::string_view letters, const PmByteWriter& contents)
{
    PmByteWriter section;
    section.append(letters);
    section.put(static_cast<std::uint64_t>(contents.bytes().size()));
    section.append(contents.bytes());
    file.append(section.bytes());
    file.put(pmCheckSum(section.bytes()));
}

PmByteWriter headOf(const ProgressiveMesh& p, const PmVertices& vertices)
{
    PmByteWriter head;
    for (const std::size_t count :
         {p.mesh.positions.size(), p.mesh.wedgeCount(), std::size_t{p.stepCount}, std::size_t{p.slotCount}})
        head.put(static_cast<std::uint32_t>(count));
    head.put(static_cast<std::uint8_t>(p.slotBytes));
    head.put(static_cast<std::uint8_t>(p.wedgeBytes));
    head.put(static_cast<std::uint16_t>(ProgressiveMesh::kErrorStride));
    vertices.writeTo(head);
    return head;
}

PmByteWriter materialsOf(const Mesh& mesh)
{
    PmByteWriter out;
    out.put(static_cast<std::uint32_t>(mesh.materials.size()));
    for (const Material& material : mesh.materials)
    {
        out.put(std::string_view(material.name));
        out.put(material.state);
        out.put(material.attributes);
        out.put(material.unseen);
        out.put(static_cast<std::uint8_t>((material.isTwoSided ? 1 : 0) |
                                          (material.litFromBothSides ? 2 : 0) |
                                          (material.isTransparent ? 4 : 0)));
    }
    return out;
}

PmByteWriter contentsOf(const PmImage& image)
{
    PmByteWriter out;
    out.put(std::string_view(image.name));
    out.put(std::string_view(image.format));
    out.put(static_cast<std::uint8_t>(image.isFlipped ? 1 : 0));
    out.append(image.bytes);
    return out;
}

/// Writes the images that are not written yet, up to one that is larger than `mostBytes`.
void appendImages(PmByteWriter& file, std::span<const PmImage>& images, std::size_t mostBytes)
{
    for (; !images.empty() && images.front().bytes.size() <= mostBytes; images = images.subspan(1))
        appendSection(file, kPmImage, contentsOf(images.front()));
}

PmByteWriter layoutOf(const ProgressiveMesh& p)
{
    PmByteWriter out;
    out.put(static_cast<std::uint32_t>(p.groups.size()));
    for (const FaceGroup& group : p.groups)
    {
        out.put(group.material);
        out.put(group.firstBlock);
    }
    out.put(static_cast<std::uint32_t>(p.blocks.size()));
    for (const FaceBlock& block : p.blocks)
    {
        out.put(block.firstSlot);
        out.put(block.extent);
    }
    return out;
}

PmByteWriter ladderOf(const ProgressiveMesh& p)
{
    PmByteWriter out;
    out.put(static_cast<std::uint32_t>(p.ladder.size()));
    for (const MeasuredLevel& level : p.ladder)
    {
        out.put(level.steps);
        out.put(level.error.maximum);
        out.put(level.error.rootMeanSquare);
    }
    return out;
}

/// Writes the sections that hold vertices, one after the other.
class VertexSections
{
public:
    VertexSections(const ProgressiveMesh& progressive, const PmVertices& vertices)
        : _progressive(progressive),
          _vertices(vertices),
          _needed(progressive),
          _recordsEnd(progressive.records.size() - kRecordPadding)
    {
    }

    PmByteWriter base()
    {
        PmByteWriter out;
        _needed.addLevel(_progressive.stepCount);
        appendBaseVertices(out);
        putError(out, errorAfter(_progressive, _progressive.stepCount));
        out.put(static_cast<std::uint32_t>(_progressive.base.size()));
        for (const Triangle& face : _progressive.base)
            for (const std::uint32_t wedge : face)
                out.put(wedge);
        _firstStep = _progressive.stepCount;
        return out;
    }

    /// Writes the steps from `first` to where the last section began.
    PmByteWriter steps(std::uint32_t first)
    {
        PmByteWriter out;
        out.put(first);
        appendVertices(out, first);
        _needed.addLevel(first);
        appendLaterVertices(out, first == 0);
        const std::size_t stride = ProgressiveMesh::kErrorStride;
        const std::size_t errorsEnd = (_firstStep + stride - 1) / stride;
        putError(out, errorAfter(_progressive, first));
        for (std::size_t e = first / stride; e < errorsEnd; ++e)
            putError(out, _progressive.errors[e]);
        const std::byte* const records = _progressive.records.data();
        std::size_t begin = _recordsEnd;
        for (; _firstStep > first; --_firstStep)
            begin = static_cast<std::size_t>(beginOfRecordBefore(records + begin) - records);
        const std::string packed = packedRecords(_progressive, {records + begin, _recordsEnd - begin});
        out.put(static_cast<std::uint64_t>(packed.size()));
        out.append(packed);
        _recordsEnd = begin;
        return out;
    }

private:
    static void putError(PmByteWriter& out, const LevelError& error)
    {
        for (const float value : {error.distance, error.normal, error.texCoord, error.colour})
            out.put(value);
    }

    /// Writes the vertices of a level that are not written yet: each position with its wedges.
    void appendVertices(PmByteWriter& out, std::uint32_t steps)
    {
        const std::size_t end = _progressive.mesh.positions.size() - steps;
        out.put(static_cast<std::uint32_t>(end - _positions));
        while (_positions < end)
            appendPosition(out);
    }

    /// Writes the vertices of the coarsest level, and runs in the place of those that its faces do not need.
    void appendBaseVertices(PmByteWriter& out)
    {
        const std::size_t end = _progressive.mesh.positions.size() - _progressive.stepCount;
        out.put(static_cast<std::uint32_t>(end));
        while (_positions < end)
        {
            const std::uint32_t wedges = wedgesOf(_wedges);
            if (_needed.isNeeded(_positions) || wedges > kPmLaterMostWedges)
            {
                appendPosition(out);
                continue;
            }
            std::uint32_t run = 0;
            while (_positions < end && !_needed.isNeeded(_positions) && run < kPmLaterMostPositions &&
                   wedgesOf(_wedges) == wedges)
            {
                _later.push_back({static_cast<std::uint32_t>(_positions++), _wedges});
                _wedges += wedges;
                ++run;
            }
            out.put(kPmLater | wedges << kPmLaterWedgesShift | run);
        }
    }

    /// Writes the vertices that were left out before and that a level needs, or all of them.
    void appendLaterVertices(PmByteWriter& out, bool areAll)
    {
        const auto isLeft = [&](const LaterPosition& later)
        { return !areAll && !_needed.isNeeded(later.position); };
        const auto end = std::stable_partition(_later.begin(), _later.end(), isLeft);
        out.put(static_cast<std::uint32_t>(_later.end() - end));
        for (auto later = end; later != _later.end(); ++later)
        {
            out.put(later->position);
            _vertices.writePosition(out, _progressive.mesh.positions[later->position]);
            for (std::uint32_t i = 0; i < wedgesOf(later->firstWedge); ++i)
                _vertices.writeWedge(out, _progressive.mesh, later->firstWedge + i);
        }
        _later.erase(end, _later.end());
    }

    /// Writes the next position with its wedges.
    void appendPosition(PmByteWriter& out)
    {
        const std::uint32_t wedges = wedgesOf(_wedges);
        out.put(wedges);
        _vertices.writePosition(out, _progressive.mesh.positions[_positions++]);
        for (std::uint32_t i = 0; i < wedges; ++i, ++_wedges)
        {
            out.put(_progressive.parents[_wedges]);
            _vertices.writeWedge(out, _progressive.mesh, _wedges);
        }
    }

    /// Returns the number of wedges of the position that has this one first.
    std::uint32_t wedgesOf(std::uint32_t first) const
    {
        const auto& positions = _progressive.mesh.wedgePositions;
        std::uint32_t count = 1;
        while (first + count < positions.size() && positions[first + count] == positions[first])
            ++count;
        return count;
    }

    /// A position whose vertices are not written yet.
    struct LaterPosition
    {
        std::uint32_t position, firstWedge;
    };

    const ProgressiveMesh& _progressive;
    const PmVertices& _vertices;
    NeededPositions _needed;
    std::vector<LaterPosition> _later;
    std::size_t _positions = 0, _recordsEnd;
    std::uint32_t _wedges = 0, _firstStep = 0;
};

} // namespace

std::string pmBytes(const ProgressiveMesh& progressive, const PmSettings& settings)
{
    assert(isValid(progressive) && checkSettings(settings));
    const PmVertices vertices(progressive.mesh, settings.quantised);
    PmByteWriter file;
    file.append(kPmMagic);
    file.put(kPmVersion);
    appendSection(file, kPmHead, headOf(progressive, vertices));
    appendSection(file, kPmMaterials, materialsOf(progressive.mesh));
    PmByteWriter attachment;
    attachment.append(settings.attachment);
    appendSection(file, kPmAttachment, attachment);
    appendSection(file, kPmLayout, layoutOf(progressive));
    VertexSections sections(progressive, vertices);
    appendSection(file, kPmBase, sections.base());
    if (!progressive.ladder.empty()) appendSection(file, kPmLadder, ladderOf(progressive));
    std::span<const PmImage> images = settings.images;
    std::uint32_t last = progressive.stepCount;
    for (std::uint32_t section = settings.stepSections; section-- > 0;)
    {
        constexpr std::uint32_t kStride = ProgressiveMesh::kErrorStride;
        const std::uint32_t coarser = progressive.stepCount >> std::min(section, 31u);
        const std::uint32_t first = (progressive.stepCount - coarser) / kStride * kStride;
        if (first == last) continue;
        const PmByteWriter steps = sections.steps(first);
        appendImages(file, images, steps.bytes().size());
        appendSection(file, kPmSteps, steps);
        last = first;
    }
    appendImages(file, images, std::numeric_limits<std::size_t>::max());
    appendSection(file, kPmEnd, {});
    return file.bytes();
}

foundation::Outcome writePm(const std::filesystem::path& file, const ProgressiveMesh& progressive,
                            const PmSettings& settings)
{
    if (foundation::Outcome checked = checkSettings(settings); !checked) return checked;
    return foundation::writeWholeFile(file, pmBytes(progressive, settings));
}

} // namespace osgPMObjects::core
