// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/split/Partition.h>

namespace osgMultiTriangulation::core
{

/// A point of the surface that is built.
struct SourcePoint
{
    SurfacePoint point;
    std::uint8_t joinedAt = 255; ///< depth of the part that has all triangles around it
};

/// The surface that is built, as the jobs ask for it: from memory or from files.
/// Threads: any number may ask at once.
class PartSource
{
public:
    /// Finds points by their number. Threads: one.
    class Points
    {
    public:
        virtual ~Points() = default;
        virtual SourcePoint at(std::uint32_t number) = 0;
    };

    virtual ~PartSource() = default;

    virtual std::unique_ptr<Points> points() const = 0;

    /// The triangles that a part is the smallest to hold, in the order of the input; corners are numbers of
    /// points.
    virtual std::vector<Triangle> trianglesOf(std::uint32_t part) const = 0;

    /// Whether checkInput() has found nothing. Where it has not been asked, each part is checked.
    virtual bool isChecked() const { return true; }

    /// Whether all that was asked for could be read.
    virtual foundation::Outcome outcome() const { return foundation::success(); }
};

} // namespace osgMultiTriangulation::core
