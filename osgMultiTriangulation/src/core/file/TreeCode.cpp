// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>

#include <osgMultiTriangulation/core/file/TreeCode.h>
#include <osgMultiTriangulation/core/structure/ErrorCode.h>
#include <osgMultiTriangulation/core/structure/StarRing.h>
#include <osgMultiTriangulation/core/surface/HeightStep.h>
#include <osgPMObjects/core/progressive/Bytes.h>

#include "MtHeader.h"

namespace osgMultiTriangulation::core
{

namespace
{

using osgPMObjects::core::appendDifference;
using osgPMObjects::core::appendFixed;
using osgPMObjects::core::appendNumber;

class TreeEncoder
{
public:
    TreeEncoder(const TreeRecord& record, double heightStep)
        : _record(record), _tree(record.part), _heightStep(heightStep)
    {
    }

    std::vector<std::byte> encode()
    {
        appendNumber(_bytes, _tree.rootPoints);
        appendNumber(_bytes, _tree.rootTriangles);
        appendNumber(_bytes, _tree.fragments.size());
        SurfacePoint before;
        for (std::uint32_t p = 0; p < _tree.rootPoints; ++p)
        {
            addPoint(_tree.points[p], before);
            before = _tree.points[p];
        }
        std::int64_t corner = 0;
        for (std::uint32_t t = 0; t < _tree.rootTriangles; ++t)
        {
            for (const std::uint32_t c : _tree.corners[t])
            {
                appendDifference(_bytes, c - corner);
                corner = c;
            }
            addError(t);
        }
        endSection();
        for (std::uint32_t f = 0; f < _tree.fragments.size(); ++f)
        {
            addFragment(f);
            if ((f + 1) % kSectionFragments == 0 || f + 1 == _tree.fragments.size()) endSection();
        }
        addTies();
        endSection();
        return withTable();
    }

private:
    void endSection()
    {
        const std::span<const std::byte> section = std::span(_bytes).subspan(_begin);
        _begin = _bytes.size();
        const auto* chars = reinterpret_cast<const char*>(section.data());
        _sections.push_back(
            {static_cast<std::uint32_t>(section.size()), mtChecksum({chars, section.size()})});
    }

    std::vector<std::byte> withTable() const
    {
        std::vector<std::byte> all;
        appendFixed(all, _sections.size(), 4);
        for (const TreeSection& section : _sections)
        {
            appendFixed(all, section.bytes, 4);
            appendFixed(all, section.checksum, 4);
        }
        all.insert(all.end(), _bytes.begin(), _bytes.end());
        return all;
    }

    void addFragment(std::uint32_t f)
    {
        const Fragment& own = _tree.fragments[f];
        appendNumber(_bytes, own.floorCount);
        for (const std::uint32_t floor : _tree.floorOf(f))
            appendNumber(_bytes, own.firstTriangle - floor);
        addPoint(_tree.points[_tree.rootPoints + f], _tree.points[_tree.corners[_tree.floorOf(f)[0]][0]]);
        for (std::uint32_t t = 0; t < own.triangleCount; ++t)
            addError(own.firstTriangle + t);
    }

    void addPoint(const SurfacePoint& point, const SurfacePoint& before)
    {
        appendDifference(_bytes, point.x - before.x);
        appendDifference(_bytes, point.y - before.y);
        if (_heightStep > 0.0)
            appendDifference(_bytes, static_cast<std::int64_t>((point.height - before.height) / _heightStep));
        else
            appendFixed(_bytes, std::bit_cast<std::uint64_t>(point.height), 8);
    }

    void addError(std::uint32_t triangle) { appendFixed(_bytes, codeOfError(_tree.errors[triangle]), 2); }

    void addTies()
    {
        appendNumber(_bytes, _record.childRoots.size());
        for (const std::vector<std::uint32_t>& roots : _record.childRoots)
        {
            appendNumber(_bytes, roots.size());
            std::int64_t before = 0;
            for (const std::uint32_t root : roots)
            {
                appendDifference(_bytes, root - before);
                before = root;
            }
        }
    }

    const TreeRecord& _record;
    const MultiTriangulation& _tree;
    double _heightStep;
    std::vector<std::byte> _bytes;
    std::size_t _begin = 0; ///< of the section that is being written
    std::vector<TreeSection> _sections;
};

} // namespace

double commonHeightStep(std::span<const SurfacePoint> points)
{
    HeightStep heights;
    for (const SurfacePoint& p : points)
        heights.add(p.height);
    return heights.step();
}

std::vector<std::byte> encodeTree(const TreeRecord& record, double heightStep)
{
    return TreeEncoder(record, heightStep).encode();
}

} // namespace osgMultiTriangulation::core
