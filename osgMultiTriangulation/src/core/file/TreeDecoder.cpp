// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <osgMultiTriangulation/core/file/TreeCode.h>
#include <osgMultiTriangulation/core/structure/ErrorCode.h>
#include <osgMultiTriangulation/core/structure/StarRing.h>
#include <osgPMObjects/core/progressive/CheckedReader.h>

namespace osgMultiTriangulation::core
{

namespace
{

using osgPMObjects::core::CheckedReader;
using osgPMObjects::core::FixedWidth;

class TreeDecoder
{
public:
    TreeDecoder(std::span<const std::byte> bytes, double heightStep)
        : _reader(bytes.data(), bytes.data() + bytes.size()),
          _end(bytes.data() + bytes.size()),
          _heightStep(heightStep)
    {
    }

    std::optional<TreeRecord> decode(std::size_t most)
    {
        MultiTriangulation& tree = _record.part;
        tree.rootPoints = _reader.number();
        tree.rootTriangles = _reader.number();
        const std::size_t fragments = _reader.number();
        if (!isRoomFor(tree.rootPoints, 3) || !isRoomFor(tree.rootTriangles, 5) || !isRoomFor(fragments, 9))
            return std::nullopt;
        const std::size_t wanted = std::min(fragments, most);
        tree.points.reserve(tree.rootPoints + wanted);
        for (auto* list : {&tree.lower, &tree.upper})
            list->reserve(tree.rootTriangles + 6 * wanted);
        tree.corners.reserve(tree.rootTriangles + 6 * wanted);
        tree.errors.reserve(tree.rootTriangles + 6 * wanted);
        tree.floors.reserve(4 * wanted);
        tree.fragments.reserve(wanted);
        if (!readRoot()) return std::nullopt;
        for (std::uint32_t f = 0; f < wanted; ++f)
            if (!readFragment(f)) return std::nullopt;
        if (wanted == fragments && (!readTies() || _reader.at() != _end)) return std::nullopt;
        return std::move(_record);
    }

private:
    /// So that a number from a damaged file reserves no more memory than the file is long.
    bool isRoomFor(std::size_t count, std::size_t bytesEach) const
    {
        return _reader.isGood() && count <= static_cast<std::size_t>(_end - _reader.at()) / bytesEach;
    }

    bool readRoot()
    {
        MultiTriangulation& tree = _record.part;
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
        MultiTriangulation& tree = _record.part;
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
        MultiTriangulation& tree = _record.part;
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

    bool readTies()
    {
        const std::uint32_t lists = _reader.number();
        if (!_reader.isGood() || lists > 64) return false;
        for (std::uint32_t l = 0; l < lists; ++l)
        {
            const std::uint32_t count = _reader.number();
            if (!isRoomFor(count, 1)) return false;
            std::vector<std::uint32_t>& roots = _record.childRoots.emplace_back();
            std::int64_t root = 0;
            for (std::uint32_t i = 0; i < count; ++i)
            {
                root += _reader.difference();
                if (!_reader.isGood() || root < 0 || root >= _record.part.triangleCount()) return false;
                if (_record.part.lower[root] != kNone) return false;
                roots.push_back(static_cast<std::uint32_t>(root));
            }
        }
        return _reader.isGood();
    }

    CheckedReader _reader;
    const std::byte* _end;
    double _heightStep;
    TreeRecord _record;
};

} // namespace

std::optional<TreeRecord> decodeTree(std::span<const std::byte> bytes, double heightStep,
                                     std::size_t fragments)
{
    return TreeDecoder(bytes, heightStep).decode(fragments);
}

} // namespace osgMultiTriangulation::core
