// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>

#include <foundation/WholeFile.h>
#include <zlib.h>

#include <osgPMObjects/core/progressive/PmFile.h>

#include "PmVertices.h"
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
          _recordsEnd(progressive.records.size() - kRecordPadding)
    {
    }

    PmByteWriter base()
    {
        PmByteWriter out;
        appendVertices(out, _progressive.stepCount);
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
        const std::size_t stride = ProgressiveMesh::kErrorStride;
        const std::size_t errorsEnd = (_firstStep + stride - 1) / stride;
        putError(out, errorAfter(_progressive, first));
        for (std::size_t e = first / stride; e < errorsEnd; ++e)
            putError(out, _progressive.errors[e]);
        const std::byte* const records = _progressive.records.data();
        std::size_t begin = _recordsEnd;
        for (; _firstStep > first; --_firstStep)
            begin = static_cast<std::size_t>(beginOfRecordBefore(records + begin) - records);
        out.put(static_cast<std::uint64_t>(_recordsEnd - begin));
        out.append({reinterpret_cast<const char*>(records + begin), _recordsEnd - begin});
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
        const Mesh& mesh = _progressive.mesh;
        const std::size_t end = mesh.positions.size() - steps;
        out.put(static_cast<std::uint32_t>(end - _positions));
        for (; _positions < end; ++_positions)
        {
            const std::uint32_t first = _wedges;
            while (_wedges < mesh.wedgeCount() && mesh.wedgePositions[_wedges] == _positions)
                ++_wedges;
            out.put(_wedges - first);
            _vertices.writePosition(out, mesh.positions[_positions]);
            for (std::uint32_t wedge = first; wedge < _wedges; ++wedge)
            {
                out.put(_progressive.parents[wedge]);
                _vertices.writeWedge(out, mesh, wedge);
            }
        }
    }

    const ProgressiveMesh& _progressive;
    const PmVertices& _vertices;
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
    std::uint32_t last = progressive.stepCount;
    for (std::uint32_t section = settings.stepSections; section-- > 0;)
    {
        constexpr std::uint32_t kStride = ProgressiveMesh::kErrorStride;
        const std::uint32_t coarser = progressive.stepCount >> std::min(section, 31u);
        const std::uint32_t first = (progressive.stepCount - coarser) / kStride * kStride;
        if (first == last) continue;
        appendSection(file, kPmSteps, sections.steps(first));
        last = first;
    }
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
