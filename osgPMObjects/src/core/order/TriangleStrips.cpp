// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include <osgPMObjects/core/order/TriangleStrips.h>

namespace osgPMObjects::core
{

bool areStrips(const TriangleStrips& strips, const TriangleAdjacency& adjacency)
{
    if (strips.triangles.size() != adjacency.size()) return false;
    if (!std::is_sorted(strips.firsts.begin(), strips.firsts.end())) return false;
    std::vector<char> isDone(adjacency.size(), 0);
    for (const std::uint32_t t : strips.triangles)
        if (t >= adjacency.size() || std::exchange(isDone[t], 1)) return false;
    for (std::size_t i = 0; i < strips.size(); ++i)
    {
        const auto strip = strips.strip(i);
        for (std::size_t k = 1; k < strip.size(); ++k)
            if (adjacency.across(strip[k], adjacency.edgeTo(strip[k], strip[k - 1])) != strip[k - 1])
                return false;
    }
    return true;
}

namespace
{

bool has(const Triangle& t, std::uint32_t vertex)
{
    return t[0] == vertex || t[1] == vertex || t[2] == vertex;
}

/// Returns the corner of `t` that is not on its edge with `next`; `next` runs through that edge in the
/// opposite direction.
int cornerOffEdge(const Triangle& t, const Triangle& next)
{
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            if (t[i] == next[(k + 1) % 3] && t[(i + 1) % 3] == next[k]) return (i + 2) % 3;
    return 0;
}

/// Returns the vertices of a strip's first triangle, those of the edge to the next triangle last. If the
/// third triangle needs it, these two are swapped and the first vertex is doubled.
std::vector<std::uint32_t> beginning(std::span<const Triangle> triangles,
                                     std::span<const std::uint32_t> strip)
{
    const Triangle& first = triangles[strip[0]];
    const int off = strip.size() > 1 ? cornerOffEdge(first, triangles[strip[1]]) : 0;
    const std::uint32_t a = first[off], b = first[(off + 1) % 3], c = first[(off + 2) % 3];
    const auto keeps = [&](std::uint32_t vertex) { return has(triangles[strip[2]], vertex); };
    if (strip.size() > 2 && keeps(b) && !keeps(c)) return {a, a, c, b};
    return {a, b, c};
}

/// Restarts within a strip: the triangles in between have area zero.
void join(std::vector<std::uint32_t>& sent, const std::vector<std::uint32_t>& behind)
{
    sent.push_back(sent.back());
    sent.push_back(behind.front());
    if (sent.size() % 2 != 0) sent.push_back(behind.front());
    sent.insert(sent.end(), behind.begin(), behind.end());
}

} // namespace

std::vector<std::uint32_t> encodeStrip(std::span<const Triangle> triangles,
                                       std::span<const std::uint32_t> strip)
{
    if (strip.empty()) return {};
    std::vector<std::uint32_t> sent = beginning(triangles, strip);
    for (std::size_t k = 1; k < strip.size(); ++k)
    {
        const Triangle& t = triangles[strip[k]];
        const std::uint32_t oldest = sent[sent.size() - 3], newer = sent.back();
        std::uint32_t older = sent[sent.size() - 2];
        if (!has(t, newer) || (!has(t, older) && !has(t, oldest)))
        { // a turn back: the next triangle has the same corners as the one before
            join(sent, beginning(triangles, strip.subspan(k)));
            continue;
        }
        if (!has(t, older))
        { // a second turn to the same side: the vertex before the newest is repeated, which makes two triangles of area zero
            sent.insert(sent.end() - 1, oldest);
            older = oldest;
        }
        sent.push_back(
            *std::find_if(t.begin(), t.end(), [=](std::uint32_t v) { return v != older && v != newer; }));
    }
    return sent;
}

std::vector<std::uint32_t> joinStrips(std::span<const Triangle> triangles, const TriangleStrips& strips)
{
    std::vector<std::uint32_t> sent;
    for (std::size_t i = 0; i < strips.size(); ++i)
    {
        std::vector<std::uint32_t> strip = encodeStrip(triangles, strips.strip(i));
        if (sent.empty())
            sent = std::move(strip);
        else
            join(sent, strip);
    }
    return sent;
}

TriangleStrips stripsOf(std::span<const Triangle> triangles, std::uint32_t vertexCount, StripKind kind)
{
    constexpr std::uint32_t kCacheSize = 16;
    const TriangleStrips strips = kind == StripKind::sgi ? sgiStrips(triangles) : dualGraphStrips(triangles);
    return cacheOrderedStrips(triangles, vertexCount, strips, kCacheSize);
}

std::vector<Triangle> decodeStrip(std::span<const std::uint32_t> sent)
{
    std::vector<Triangle> drawn;
    for (std::size_t i = 2; i < sent.size(); ++i)
    {
        const std::uint32_t a = sent[i - 2], b = sent[i - 1], c = sent[i];
        if (a == b || b == c || a == c) continue;
        drawn.push_back(i % 2 == 0 ? Triangle{a, b, c} : Triangle{b, a, c});
    }
    return drawn;
}

} // namespace osgPMObjects::core
