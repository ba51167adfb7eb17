// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <osgPMObjects/core/progressive/PmFile.h>

#include "PmSectionStream.h"
#include "PmVertices.h"
#include "ProgressiveMeshCheck.h"
#include "RecordPacking.h"
#include "StepRecord.h"

namespace osgPMObjects::core
{

/// The contents read so far. Records come coarsest first, so they are kept in pieces until mesh() joins them.
class PmReader::Sections
{
public:
    Sections(std::istream& stream, std::string place) : _stream(stream, std::move(place)) {}

    foundation::Result<bool> readMore()
    {
        if (_isWhole) return false;
        if (!_hasBase) return readBase();
        PmSectionStream::Section section;
        do
        {
            if (const auto read = _stream.read(section); !read) return read.error();
            if (section.letters == kPmImage && !readImage(section.contents))
                return _stream.damaged("has an image that cannot be");
        } while (section.letters == kPmImage);
        if (section.letters == kPmLadder && _ladder.empty() && _firstStep == _totalSteps)
        {
            if (!readLadder(section.contents))
                return _stream.damaged("has a ladder of errors that cannot be");
            return readMore();
        }
        if (section.letters == kPmSteps) return readSteps(section);
        if (section.letters != kPmEnd)
            return _stream.damaged("has a section " + section.letters + " that does not belong there");
        if (_firstStep != 0 || !_firstWedgeOfLater.empty())
            return _stream.damaged("ends before its last steps");
        _isWhole = true;
        return false;
    }

    foundation::Result<ProgressiveMesh> mesh() const
    {
        ProgressiveMesh whole = _mesh;
        whole.stepCount = _totalSteps - _firstStep;
        for (auto piece = _records.rbegin(); piece != _records.rend(); ++piece)
            for (const char byte : *piece)
                whole.records.push_back(static_cast<std::byte>(byte));
        whole.records.resize(whole.records.size() + kRecordPadding);
        for (auto piece = _errors.rbegin(); piece != _errors.rend(); ++piece)
            whole.errors.insert(whole.errors.end(), piece->begin(), piece->end());
        whole.ladder = ladderFrom(_firstStep);
        const auto needs = needsOf(whole);
        if (!needs) return _stream.damaged("has steps that cannot be");
        whole.mostSlotsOfStep = needs->slotsOfStep;
        whole.mostRearrangements = needs->rearrangements;
        whole.mostSlotsMoved = needs->slotsMoved;
        if (!isValid(whole)) return _stream.damaged("has steps that do not lead back");
        return whole;
    }

    bool isCutOff() const { return _stream.isCutOff(); }
    const std::string& attachment() const { return _attachment; }
    const std::vector<PmImage>& images() const { return _images; }
    std::size_t positions() const { return _mesh.mesh.positions.size(); }
    std::uint32_t totalSteps() const { return _totalSteps; }
    std::uint32_t totalPositions() const { return _totalPositions; }

private:
    foundation::Result<bool> readBase()
    {
        if (const auto begun = _stream.readBegin(); !begun) return begun.error();
        std::string head, materials, layout, base;
        for (const auto& [letters, bytes] : {std::pair{kPmHead, &head},
                                             {kPmMaterials, &materials},
                                             {kPmAttachment, &_attachment},
                                             {kPmLayout, &layout},
                                             {kPmBase, &base}})
            if (const auto read = _stream.read(letters, *bytes); !read) return read.error();
        if (!readHead(head)) return _stream.damaged("has a head that cannot be");
        if (!readMaterials(materials)) return _stream.damaged("has materials that cannot be");
        if (!readLayout(layout)) return _stream.damaged("has a layout that cannot be");
        if (!readBaseFaces(base)) return _stream.damaged("has a coarsest level that cannot be");
        _hasBase = true;
        return true;
    }

    bool readHead(const std::string& bytes)
    {
        PmByteReader in(bytes);
        _totalPositions = in.get<std::uint32_t>();
        _totalWedges = in.get<std::uint32_t>();
        _totalSteps = _firstStep = in.get<std::uint32_t>();
        _mesh.slotCount = in.get<std::uint32_t>();
        _mesh.slotBytes = in.get<std::uint8_t>();
        _mesh.wedgeBytes = in.get<std::uint8_t>();
        const auto stride = in.get<std::uint16_t>();
        _vertices = PmVertices(in);
        return in.isGood() && in.isAtEnd() && _vertices.isSound() &&
               stride == ProgressiveMesh::kErrorStride && _totalSteps <= _totalPositions &&
               _totalPositions <= _totalWedges && _mesh.slotCount <= mostSlots();
    }

    /// Returns an upper limit of slots for the size of the file. They are announced before their faces are
    /// read; a larger number is damage, and memory for it must not be requested.
    std::uint64_t mostSlots() const
    {
        constexpr std::uint64_t kFew = 1u << 20, kMany = 1u << 24, kOfByte = 64;
        return _stream.size() ? kFew + kOfByte * *_stream.size() : kMany;
    }

    bool readMaterials(const std::string& bytes)
    {
        PmByteReader in(bytes);
        const auto count = in.get<std::uint32_t>();
        if (!in.hasRoomFor(count, 17)) return false;
        for (std::uint32_t i = 0; i < count; ++i)
        {
            Material& material = _mesh.mesh.materials.emplace_back();
            material.name = in.text();
            material.state = in.get<std::uint32_t>();
            material.attributes = in.get<std::uint32_t>();
            material.unseen = in.get<std::uint32_t>();
            const auto flags = in.get<std::uint8_t>();
            material.isTwoSided = flags & 1;
            material.litFromBothSides = flags & 2;
            material.isTransparent = flags & 4;
        }
        return in.isGood() && in.isAtEnd();
    }

    bool readLayout(const std::string& bytes)
    {
        PmByteReader in(bytes);
        const auto groups = in.get<std::uint32_t>();
        if (!in.hasRoomFor(groups, 8)) return false;
        for (std::uint32_t i = 0; i < groups; ++i)
        {
            const auto material = in.get<std::uint32_t>();
            _mesh.groups.push_back({material, in.get<std::uint32_t>()});
        }
        const auto blocks = in.get<std::uint32_t>();
        if (!in.hasRoomFor(blocks, 8)) return false;
        for (std::uint32_t i = 0; i < blocks; ++i)
        {
            const auto first = in.get<std::uint32_t>();
            _mesh.blocks.push_back({first, in.get<std::uint32_t>()});
        }
        return in.isGood() && in.isAtEnd();
    }

    bool readImage(const std::string& bytes)
    {
        PmByteReader in(bytes);
        PmImage& image = _images.emplace_back();
        image.name = in.text();
        image.format = in.text();
        image.isFlipped = (in.get<std::uint8_t>() & 1) != 0;
        image.bytes = in.rest();
        return in.isGood();
    }

    bool readBaseFaces(const std::string& bytes)
    {
        PmByteReader in(bytes);
        if (!readVertices(in, _totalSteps)) return false;
        _mesh.finestError = readError(in);
        const auto count = in.get<std::uint32_t>();
        if (!in.hasRoomFor(count, 12)) return false;
        for (std::uint32_t i = 0; i < count; ++i)
        {
            Triangle& face = _mesh.base.emplace_back();
            for (std::uint32_t& wedge : face)
                wedge = in.get<std::uint32_t>();
        }
        return in.isGood() && in.isAtEnd();
    }

    bool readLadder(const std::string& bytes)
    {
        PmByteReader in(bytes);
        const auto count = in.get<std::uint32_t>();
        if (count == 0 || !in.hasRoomFor(count, 12)) return false;
        for (std::uint32_t i = 0; i < count; ++i)
        {
            MeasuredLevel& level = _ladder.emplace_back();
            level.steps = in.get<std::uint32_t>();
            level.error.maximum = in.get<float>();
            level.error.rootMeanSquare = in.get<float>();
        }
        return in.isGood() && in.isAtEnd() && areMeasured(_ladder) && _ladder.back().steps <= _totalSteps;
    }

    /// Returns the ladder of the levels from `first` on. The first of them has the error of the next coarser
    /// measured level.
    std::vector<MeasuredLevel> ladderFrom(std::uint32_t first) const
    {
        std::vector<MeasuredLevel> ladder;
        for (const MeasuredLevel& level : _ladder)
        {
            if (level.steps < first) continue;
            if (ladder.empty() && level.steps > first) ladder.push_back({0, level.error});
            ladder.push_back({level.steps - first, level.error});
        }
        return ladder;
    }

    bool readVertices(PmByteReader& in, std::uint32_t steps)
    {
        Mesh& mesh = _mesh.mesh;
        const auto count = in.get<std::uint32_t>();
        if (count != _totalPositions - steps - mesh.positions.size()) return false;
        const std::size_t end = mesh.positions.size() + count;
        while (mesh.positions.size() < end)
        {
            const auto wedges = in.get<std::uint32_t>();
            if (_stream.version() > 1 && !_hasBase && (wedges & kPmLater) != 0)
            {
                if (!in.isGood() || !skipRun(wedges, end)) return false;
                continue;
            }
            const auto position = static_cast<std::uint32_t>(mesh.positions.size());
            mesh.positions.push_back(_vertices.readPosition(in));
            if (!in.isGood() || !in.hasRoomFor(wedges, 4 + _vertices.wedgeBytes())) return false;
            for (std::uint32_t w = 0; w < wedges; ++w)
            {
                mesh.wedgePositions.push_back(position);
                _mesh.parents.push_back(in.get<std::uint32_t>());
                _vertices.readWedge(in, mesh);
            }
        }
        return in.isGood() && mesh.wedgeCount() <= _totalWedges;
    }

    /// Makes positions whose vertices follow later; until then they lie in the middle of the box, where no
    /// face uses them.
    bool skipRun(std::uint32_t code, std::size_t end)
    {
        Mesh& mesh = _mesh.mesh;
        const std::uint32_t wedges = code >> kPmLaterWedgesShift & kPmLaterMostWedges;
        const std::uint32_t run = code & kPmLaterMostPositions;
        if (wedges == 0 || run == 0 || run > end - mesh.positions.size()) return false;
        if (mesh.wedgeCount() + std::uint64_t{run} * wedges >
            std::min<std::uint64_t>(_totalWedges, mostSlots()))
            return false;
        for (std::uint32_t i = 0; i < run; ++i)
        {
            const auto position = static_cast<std::uint32_t>(mesh.positions.size());
            _firstWedgeOfLater[position] = static_cast<std::uint32_t>(mesh.wedgeCount());
            mesh.positions.push_back(_vertices.middle());
            for (std::uint32_t w = 0; w < wedges; ++w)
            {
                _mesh.parents.push_back(static_cast<std::uint32_t>(mesh.wedgeCount()));
                mesh.wedgePositions.push_back(position);
                _vertices.appendEmptyWedge(mesh);
            }
        }
        return true;
    }

    /// Reads vertices that earlier sections left out.
    bool readLaterVertices(PmByteReader& in)
    {
        if (_stream.version() == 1) return true;
        Mesh& mesh = _mesh.mesh;
        const auto count = in.get<std::uint32_t>();
        if (!in.hasRoomFor(count, 4 + _vertices.positionBytes())) return false;
        for (std::uint32_t i = 0; i < count; ++i)
        {
            const auto position = in.get<std::uint32_t>();
            const auto later = _firstWedgeOfLater.find(position);
            if (!in.isGood() || later == _firstWedgeOfLater.end()) return false;
            mesh.positions[position] = _vertices.readPosition(in);
            for (std::uint32_t wedge = later->second;
                 wedge < mesh.wedgeCount() && mesh.wedgePositions[wedge] == position; ++wedge)
                _vertices.readWedgeAt(in, mesh, wedge);
            _firstWedgeOfLater.erase(later);
        }
        return in.isGood();
    }

    static LevelError readError(PmByteReader& in)
    {
        LevelError error;
        for (float* value : {&error.distance, &error.normal, &error.texCoord, &error.colour})
            *value = in.get<float>();
        return error;
    }

    foundation::Result<bool> readSteps(const PmSectionStream::Section& section)
    {
        PmByteReader in(section.contents);
        const auto first = in.get<std::uint32_t>();
        constexpr std::uint32_t kStride = ProgressiveMesh::kErrorStride;
        if (first >= _firstStep || first % kStride != 0 || !readVertices(in, first) || !readLaterVertices(in))
            return _stream.damaged("has vertices that cannot be");
        const std::uint32_t errors = (_firstStep + kStride - 1) / kStride - first / kStride;
        if (!in.hasRoomFor(errors + 1, 16)) return _stream.damaged("has too few errors");
        _mesh.finestError = readError(in);
        std::vector<LevelError>& piece = _errors.emplace_back();
        for (std::uint32_t i = 0; i < errors; ++i)
            piece.push_back(readError(in));
        const auto length = in.get<std::uint64_t>();
        const std::string_view records = in.take(length);
        if (!in.isGood() || !in.isAtEnd()) return _stream.damaged("has steps of another length");
        std::optional<std::string> unpacked(records);
        if (_stream.version() > 3) unpacked = unpackedRecords(_mesh, records, _firstStep - first);
        if (!unpacked) return _stream.damaged("has steps that cannot be");
        _records.push_back(*std::move(unpacked));
        _firstStep = first;
        return true;
    }

    PmSectionStream _stream;
    bool _hasBase = false, _isWhole = false;
    std::uint32_t _totalPositions = 0, _totalWedges = 0, _totalSteps = 0, _firstStep = 0;
    PmVertices _vertices{Mesh{}, false};
    ProgressiveMesh _mesh; ///< without records and errors
    std::unordered_map<std::uint32_t, std::uint32_t>
        _firstWedgeOfLater; ///< by position that is left out so far
    std::string _attachment;
    std::vector<MeasuredLevel> _ladder; ///< of the whole mesh
    std::vector<PmImage> _images;
    std::vector<std::string> _records;
    std::vector<std::vector<LevelError>> _errors;
};

PmReader::PmReader(std::istream& stream, std::string place)
    : _sections(std::make_unique<Sections>(stream, std::move(place)))
{
}

PmReader::~PmReader() = default;
PmReader::PmReader(PmReader&&) noexcept = default;
PmReader& PmReader::operator=(PmReader&&) noexcept = default;

foundation::Result<bool> PmReader::readMore()
{
    return _sections->readMore();
}

foundation::Result<ProgressiveMesh> PmReader::mesh() const
{
    return _sections->mesh();
}

bool PmReader::isCutOff() const
{
    return _sections->isCutOff();
}

const std::vector<PmImage>& PmReader::images() const
{
    return _sections->images();
}

const std::string& PmReader::attachment() const
{
    return _sections->attachment();
}

std::size_t PmReader::positions() const
{
    return _sections->positions();
}

std::uint32_t PmReader::totalSteps() const
{
    return _sections->totalSteps();
}

std::uint32_t PmReader::totalPositions() const
{
    return _sections->totalPositions();
}

foundation::Result<ProgressiveMesh> readPm(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        return foundation::Error{file.string(), "cannot be opened", "check its path and permissions"};
    PmReader reader(stream, file.string());
    while (true)
    {
        const auto more = reader.readMore();
        if (!more) return more.error();
        if (!*more) return reader.mesh();
    }
}

} // namespace osgPMObjects::core
