// SPDX-License-Identifier: Apache-2.0
#include "ArrayValues.h"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace osgPMObjects
{

namespace
{

/// Converts a component as glVertexAttribPointer does. Source: OpenGL 4.5 specification, §2.3.5 (eqs. 2.1 and
/// 2.2).
template<class T>
double component(T value, bool isNormalised)
{
    if constexpr (std::is_integral_v<T>)
        if (isNormalised)
            return std::max(-1.0,
                            static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()));
    return static_cast<double>(value);
}

template<class T>
concept Scalar = std::is_arithmetic_v<T>;

struct Collector
{
    bool isNormalised;
    std::vector<glm::dvec4> values{};

    template<Scalar T>
    void add(const T& value)
    {
        values.emplace_back(component(value, isNormalised), 0.0, 0.0, 1.0);
    }

    template<class Vector>
    void add(const Vector& v)
    {
        glm::dvec4 value(0.0, 0.0, 0.0, 1.0);
        for (int i = 0; i < Vector::num_components; ++i)
            value[i] = component(v[i], isNormalised);
        values.push_back(value);
    }
};

/// Fills a collector from the array if it is of type Candidate.
template<class Candidate>
bool collect(const osg::Array& array, Collector& into)
{
    const auto* typed = dynamic_cast<const Candidate*>(&array);
    if (!typed) return false;
    into.values.reserve(typed->size());
    for (const auto& element : *typed)
        into.add(element);
    return true;
}

template<class... Candidates>
void collectFirst(const osg::Array& array, Collector& into)
{
    (collect<Candidates>(array, into) || ...);
}

} // namespace

std::vector<glm::dvec4> valuesOf(const osg::Array& array, bool isNormalised)
{
    Collector collector{isNormalised};
    using namespace osg;
    collectFirst<Vec3Array, Vec2Array, Vec4Array, Vec4ubArray, Vec3dArray, Vec2dArray, Vec4dArray, FloatArray,
                 DoubleArray, Vec2bArray, Vec3bArray, Vec4bArray, Vec2sArray, Vec3sArray, Vec4sArray,
                 Vec2iArray, Vec3iArray, Vec4iArray, Vec2ubArray, Vec3ubArray, Vec2usArray, Vec3usArray,
                 Vec4usArray, Vec2uiArray, Vec3uiArray, Vec4uiArray, ByteArray, ShortArray, IntArray,
                 UByteArray, UShortArray, UIntArray>(array, collector);
    return std::move(collector.values);
}

} // namespace osgPMObjects
