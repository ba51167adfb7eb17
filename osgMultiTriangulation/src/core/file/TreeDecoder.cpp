// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <osgMultiTriangulation/core/file/TreeCode.h>
#include <osgMultiTriangulation/core/structure/ErrorCode.h>
#include <osgMultiTriangulation/core/structure/KeepFragments.h>
#include <osgMultiTriangulation/core/structure/StarRing.h>
#include <osgPMObjects/core/progressive/CheckedReader.h>

namespace osgMultiTriangulation::core
{

namespace
{

using osgPMObjects::core::CheckedReader;
using osgPMObjects::core::FixedWidth;

/// Reads bytes of a tree in their order, all of it or a section.
class TreeDecoder
{
public:
    TreeDecoder(std::span<const std::byte> bytes, double heightStep, MultiTriangulation& tree)
        : _tree(tree),
          _reader(bytes.data(), bytes.data() + bytes.size()),
          _end(bytes.data() + bytes.size()),
          _heightStep(heightStep)
    {
    }

    /// `isWhole`: the fragments follow, so there must be room for them.
    bool readHead(std::uint32_t& fragments, bool isWhole)
    {
        _tree.rootPoints = _reader.number();
        _tree.rootTriangles = _reader.number();
        fragments = _reader.number();
        if (!isRoomFor(_tree.rootPoints, 3) || !isRoomFor(_tree.rootTriangles, 5)) return false;
        if (isWhole && !isRoomFor(fragments, 9)) return false;
        _tree.points.reserve(_tree.rootPoints);
        return readRoot();
    }

    bool readFragments(std::size_t count)
    {
        if (!isRoomFor(count, 9)) return false;
        for (std::size_t f = 0; f < count; ++f)
            if (!readFragment(static_cast<std::uint32_t>(_tree.fragments.size()))) return false;
        return true;
    }

    bool readTies(std::vector<std::vector<std::uint32_t>>& childRoots)
    {
        const std::uint32_t lists = _reader.number();
        if (!_reader.isGood() || lists > 64) return false;
        for (std::uint32_t l = 0; l < lists; ++l)
        {
            const std::uint32_t count = _reader.number();
            if (!isRoomFor(count, 1)) return false;
            std::vector<std::uint32_t>& roots = childRoots.emplace_back();
            std::int64_t root = 0;
            for (std::uint32_t i = 0; i < count; ++i)
            {
                root += _reader.difference();
                if (!_reader.isGood() || root < 0 || root >= _tree.triangleCount()) return false;
                if (_tree.lower[root] != kNone) return false;
                roots.push_back(static_cast<std::uint32_t>(root));
            }
        }
        return _reader.isGood();
    }

    bool isAtEnd() const { return _reader.isGood() && _reader.at() == _end; }

private:
    /// So that a number from a damaged file reserves no more memory than the file is long.
    bool isRoomFor(std::size_t count, std::size_t bytesEach) const
    {
        return _reader.isGood() && count <= static_cast<std::size_t>(_end - _reader.at()) / bytesEach;
    }

    bool readRoot()
    {
        MultiTriangulation& tree = _tree;
        SurfacePoint before;
        for (std::uint32_t p = 0; p < tree.rootPoints; ++p)
        {
            if (!readPoint(before, before)) return false;
            tree.points.push_back(before);
        }
        std::int64_t corner = 0;
        for (std::uint32_t t = 0; t < tree.rootTriangles; ++t)
        {
            Triangle triangle{};
            for (std::uint32_t& c : triangle)
            {
                corner += _reader.difference();
                if (corner < 0 || corner >= tree.rootPoints) return false;
                c = static_cast<std::uint32_t>(corner);
            }
            if (!addTriangle(triangle, kNone)) return false;
            if (!(twiceArea(tree.points[triangle[0]], tree.points[triangle[1]], tree.points[triangle[2]]) >
                  0.0))
                return false;
        }
        return true;
    }

    bool readFragment(std::uint32_t number)
    {
        MultiTriangulation& tree = _tree;
        Fragment own;
        own.firstTriangle = tree.triangleCount();
        own.firstFloor = static_cast<std::uint32_t>(tree.floors.size());
        const std::uint32_t count = _reader.number();
        std::array<Triangle, StarRing::kMost> floor;
        if (count == 0 || count > StarRing::kMost - 2) return false;
        for (std::uint32_t i = 0; i < count; ++i)
        {
            const std::uint32_t back = _reader.number();
            if (!_reader.isGood() || back == 0 || back > own.firstTriangle) return false;
            const std::uint32_t triangle = own.firstTriangle - back;
            if (tree.lower[triangle] != kNone) return false;
            tree.lower[triangle] = number;
            tree.floors.push_back(triangle);
            floor[i] = tree.corners[triangle];
        }
        SurfacePoint point;
        if (!readPoint(tree.points[floor[0][0]], point)) return false;
        StarRing ring;
        if (!findStarRing(std::span(floor).first(count), tree.points, point, ring)) return false;
        tree.points.push_back(point);
        for (std::size_t i = 0; i < ring.triangles(); ++i)
            if (!addTriangle(ring.triangle(i, tree.rootPoints + number), number)) return false;
        own.floorCount = static_cast<std::uint8_t>(count);
        own.triangleCount = static_cast<std::uint8_t>(ring.triangles());
        tree.fragments.push_back(own);
        return true;
    }

    bool addTriangle(const Triangle& corners, std::uint32_t upper)
    {
        static const FixedWidth kTwoBytes(2);
        MultiTriangulation& tree = _tree;
        tree.corners.push_back(corners);
        tree.errors.push_back(errorOfCode(static_cast<std::uint16_t>(_reader.fixed(kTwoBytes))));
        tree.upper.push_back(upper);
        tree.lower.push_back(kNone);
        return _reader.isGood();
    }

    bool readPoint(const SurfacePoint& before, SurfacePoint& point)
    {
        static const FixedWidth kFourBytes(4);
        const std::int64_t x = std::int64_t(before.x) + _reader.difference();
        const std::int64_t y = std::int64_t(before.y) + _reader.difference();
        if (x < 0 || y < 0 || x > kMostPlan || y > kMostPlan) return false;
        double height;
        if (_heightStep > 0.0)
            height = before.height + _reader.difference() * _heightStep;
        else
        {
            const std::uint64_t low = _reader.fixed(kFourBytes), high = _reader.fixed(kFourBytes);
            height = std::bit_cast<double>(low | high << 32);
        }
        point = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), height};
        return _reader.isGood() && std::isfinite(height);
    }

    MultiTriangulation& _tree;
    CheckedReader _reader;
    const std::byte* _end;
    double _heightStep;
};

} // namespace

std::optional<std::vector<TreeSection>> readSectionTable(std::span<const std::byte> bytes, std::size_t whole)
{
    static const FixedWidth kFourBytes(4);
    CheckedReader reader(bytes.data(), bytes.data() + bytes.size());
    const std::size_t count = reader.fixed(kFourBytes);
    if (!reader.isGood() || count < 2 || count > (bytes.size() - 4) / 8) return std::nullopt;
    std::vector<TreeSection> sections(count);
    std::size_t all = 4 + 8 * count;
    for (TreeSection& section : sections)
    {
        section.bytes = reader.fixed(kFourBytes);
        section.checksum = reader.fixed(kFourBytes);
        all += section.bytes;
    }
    if (all != whole) return std::nullopt;
    return sections;
}

void reserveFragments(MultiTriangulation& tree, std::size_t fragments)
{
    const std::size_t triangles = tree.rootTriangles + 6 * fragments;
    tree.points.reserve(tree.rootPoints + fragments);
    tree.lower.reserve(triangles);
    tree.upper.reserve(triangles);
    tree.corners.reserve(triangles);
    tree.errors.reserve(triangles);
    tree.floors.reserve(4 * fragments);
    tree.fragments.reserve(fragments);
}

bool decodeRoot(std::span<const std::byte> bytes, double heightStep, MultiTriangulation& tree,
                std::uint32_t& fragments)
{
    TreeDecoder decoder(bytes, heightStep, tree);
    return decoder.readHead(fragments, false) && decoder.isAtEnd();
}

bool decodeFragments(std::span<const std::byte> bytes, double heightStep, std::uint32_t count,
                     MultiTriangulation& tree)
{
    const std::size_t before = tree.fragments.size();
    TreeDecoder decoder(bytes, heightStep, tree);
    if (decoder.readFragments(count) && decoder.isAtEnd()) return true;
    keepFragments(tree, before);
    return false;
}

bool decodeTies(std::span<const std::byte> bytes, TreeRecord& record)
{
    TreeDecoder decoder(bytes, 0.0, record.part);
    if (decoder.readTies(record.childRoots) && decoder.isAtEnd()) return true;
    record.childRoots.clear();
    return false;
}

std::optional<TreeRecord> decodeTree(std::span<const std::byte> bytes, double heightStep, std::size_t most)
{
    const auto sections = readSectionTable(bytes, bytes.size());
    if (!sections) return std::nullopt;
    TreeRecord record;
    std::span<const std::byte> left = bytes.subspan(4 + 8 * sections->size());
    const auto next = [&](std::size_t section)
    {
        const std::span<const std::byte> own = left.first((*sections)[section].bytes);
        left = left.subspan(own.size());
        return own;
    };
    std::uint32_t fragments = 0;
    if (!decodeRoot(next(0), heightStep, record.part, fragments)) return std::nullopt;
    if (sections->size() != sectionsFor(fragments) || left.size() / 9 < fragments) return std::nullopt;
    const auto wanted = static_cast<std::uint32_t>(wholeSections(fragments, most));
    reserveFragments(record.part, wanted);
    for (std::uint32_t f = 0; f < wanted; f += kSectionFragments)
        if (!decodeFragments(next(1 + f / kSectionFragments), heightStep,
                             std::min(kSectionFragments, wanted - f), record.part))
            return std::nullopt;
    if (wanted == fragments && !decodeTies(left, record)) return std::nullopt;
    return record;
}

std::optional<TreeRecord> decodeWholeTree(std::span<const std::byte> bytes, double heightStep,
                                          std::size_t most)
{
    TreeRecord record;
    TreeDecoder decoder(bytes, heightStep, record.part);
    std::uint32_t fragments = 0;
    if (!decoder.readHead(fragments, true)) return std::nullopt;
    const std::size_t wanted = wholeSections(fragments, most);
    reserveFragments(record.part, wanted);
    if (!decoder.readFragments(wanted)) return std::nullopt;
    if (wanted == fragments && (!decoder.readTies(record.childRoots) || !decoder.isAtEnd()))
        return std::nullopt;
    return record;
}

} // namespace osgMultiTriangulation::core
