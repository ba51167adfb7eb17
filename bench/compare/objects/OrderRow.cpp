// SPDX-License-Identifier: Apache-2.0
#include "compare/objects/OrderRow.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include <osgPMObjects/core/order/TriangleOrders.h>
#include <osgPMObjects/core/order/TriangleStrips.h>
#include <osgPMObjects/core/order/VertexCacheCost.h>

#include "pmtool/Timing.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects::core;
using Numbers = std::vector<std::uint32_t>;

std::uint32_t vertexCount(const DrawCall& call)
{
    return static_cast<std::uint32_t>(call.positions.size());
}

Numbers given(const DrawCall& call)
{
    Numbers numbers(call.triangles.size());
    std::iota(numbers.begin(), numbers.end(), 0u);
    return numbers;
}

/// Shuffles triangles, the same way each time: the cost of no order.
Numbers shuffled(const DrawCall& call)
{
    Numbers numbers = given(call);
    std::uint64_t state = 1;
    for (std::size_t i = numbers.size(); i > 1; --i)
    {
        state = state * 6364136223846793005ull + 1442695040888963407ull; // Knuth's generator
        std::swap(numbers[i - 1], numbers[(state >> 33) % i]);
    }
    return numbers;
}

TriangleStrips sgi(const DrawCall& call)
{
    return sgiStrips(call.triangles);
}

TriangleStrips dualGraph(const DrawCall& call)
{
    return dualGraphStrips(call.triangles);
}

template<std::uint32_t size>
TriangleStrips byFifo(const DrawCall& call)
{
    return cacheOrderedStrips(call.triangles, vertexCount(call), sgiStrips(call.triangles), size);
}

template<std::uint32_t size>
Numbers locality(const DrawCall& call)
{
    return localityOrder(call.triangles, vertexCount(call), size);
}

/// An order, made by one of the two functions.
struct NamedOrder
{
    const char* name;
    Numbers (*order)(const DrawCall&);
    TriangleStrips (*strips)(const DrawCall&);
};

constexpr NamedOrder kNamedOrders[] = {
    {"given", given, nullptr},
    {"random", shuffled, nullptr},
    {"sgiStrips", nullptr, sgi},
    {"dualGraphStrips", nullptr, dualGraph},
    {"fifoStrips10", nullptr, byFifo<10>},
    {"fifoStrips16", nullptr, byFifo<16>},
    {"fifoStrips32", nullptr, byFifo<32>},
    {"hilbert", [](const DrawCall& call) { return hilbertOrder(call.triangles, call.positions); }, nullptr},
    {"universal", [](const DrawCall& call) { return universalOrder(call.triangles); }, nullptr},
    {"locality10", locality<10>, nullptr},
    {"locality16", locality<16>, nullptr},
    {"locality32", locality<32>, nullptr},
    {"meshoptimizer", [](const DrawCall& call) { return libraryOrder(call.triangles, vertexCount(call)); },
     nullptr},
};

} // namespace

std::vector<std::string> orderNames()
{
    std::vector<std::string> names;
    for (const NamedOrder& order : kNamedOrders)
        names.emplace_back(order.name);
    return names;
}

OrderedSubject orderSubject(const OrderSubject& subject, const std::string& name)
{
    const NamedOrder& order = *std::find_if(std::begin(kNamedOrders), std::end(kNamedOrders),
                                            [&](const NamedOrder& o) { return o.name == name; });
    OrderedSubject ordered;
    for (const DrawCall& call : subject.calls)
    {
        TriangleStrips strips;
        ordered.ms += threadMillisecondsOf(
            [&] {
                strips = order.strips ? order.strips(call) : TriangleStrips{order.order(call), {}};
            });
        ordered.calls.push_back(inOrder(call.triangles, strips.triangles));
        ordered.strips += strips.size();
        for (std::size_t i = 0; i < strips.size(); ++i)
            ordered.sentVertices += encodeStrip(call.triangles, strips.strip(i)).size();
    }
    return ordered;
}

nlohmann::ordered_json transformsPerTriangle(const OrderSubject& subject, const OrderedSubject& ordered)
{
    const auto sum = [&](const std::function<std::uint64_t(std::span<const Triangle>, std::uint32_t)>& count)
    {
        std::uint64_t transforms = 0;
        for (std::size_t i = 0; i < ordered.calls.size(); ++i)
            transforms += count(ordered.calls[i], vertexCount(subject.calls[i]));
        return static_cast<double>(transforms) / static_cast<double>(subject.triangleCount());
    };
    const auto fifo = [&](std::uint32_t size)
    {
        return sum([size](std::span<const Triangle> triangles, std::uint32_t vertices)
                   { return fifoTransforms(triangles, vertices, size); });
    };
    const auto batch = [&](const foundation::BatchLimits& limits)
    {
        return sum([limits](std::span<const Triangle> triangles, std::uint32_t vertices)
                   { return batchTransforms(triangles, vertices, limits); });
    };
    return {{"fifo4", fifo(4)},
            {"fifo6", fifo(6)},
            {"fifo8", fifo(8)},
            {"fifo10", fifo(10)},
            {"fifo16", fifo(16)},
            {"fifo32", fifo(32)},
            {"fifo64", fifo(64)},
            {"batch32", batch(foundation::BatchCache::kNvidia)},
            {"batch32Triangles", batch({.triangles = 32})},
            {"batch32Indices", batch({.triangles = 32 / 3})}};
}

} // namespace pmtool
