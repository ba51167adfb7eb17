// SPDX-License-Identifier: Apache-2.0
#include "PackedPage.h"

#include <algorithm>
#include <array>
#include <cstring>

#include <foundation/ShortNumbers.h>

namespace osgRoads::core
{

namespace
{

using foundation::appendShort;
using foundation::foldedDifference;
using foundation::ShortTaker;
using foundation::unfoldedDifference;

/// A vertex as numbers of 32 bits.
using VertexWords = std::array<std::uint32_t, 11>;
static_assert(sizeof(VertexWords) == sizeof(MeshVertex));
constexpr std::size_t kPositionWords = 3, kAlongWord = 3; ///< of position; the one of `s`

VertexWords wordsOf(const MeshVertex& vertex)
{
    VertexWords words{};
    std::memcpy(words.data(), &vertex, sizeof vertex);
    return words;
}

/// Returns what the vertex number `i` of a span is expected to be: as the one a row before it, going on in
/// its direction, and as far along the road as the one beside it.
VertexWords expected(const MeshVertex* span, std::uint32_t i, std::uint32_t columns)
{
    if (i == 0) return {};
    const std::uint32_t back = i >= columns ? columns : 1;
    VertexWords words = wordsOf(span[i - back]);
    if (i >= 2 * columns)
    {
        const VertexWords before = wordsOf(span[i - 2 * columns]);
        for (std::size_t w = 0; w < kPositionWords; ++w)
            words[w] += words[w] - before[w];
    }
    if (i % columns != 0) std::memcpy(&words[kAlongWord], &span[i - 1].s, sizeof(float));
    return words;
}

/// Appends which of the words differ from what is expected, and by how much.
void appendVertex(std::string& bytes, const VertexWords& words, const VertexWords& expected)
{
    std::uint32_t which = 0;
    for (std::size_t w = 0; w < words.size(); ++w)
        which |= words[w] != expected[w] ? 1U << w : 0U;
    appendShort(bytes, which);
    for (std::size_t w = 0; w < words.size(); ++w)
        if (words[w] != expected[w]) appendShort(bytes, foldedDifference(words[w] - expected[w]));
}

bool takeVertex(ShortTaker& taker, VertexWords& words)
{
    std::uint32_t which = 0, difference = 0;
    if (!taker.take(which) || which >> words.size() != 0) return false;
    for (std::size_t w = 0; which != 0; ++w, which >>= 1U)
        if ((which & 1U) != 0)
        {
            if (!taker.take(difference)) return false;
            words[w] += unfoldedDifference(difference);
        }
    return true;
}

bool takeSpan(ShortTaker& taker, const VertexRows& span, std::vector<MeshVertex>& vertices)
{
    const std::size_t first = vertices.size();
    vertices.resize(first + span.count);
    MeshVertex* const made = vertices.data() + first;
    for (std::uint32_t i = 0; i < span.count; ++i)
    {
        VertexWords words = expected(made, i, span.columns);
        if (!takeVertex(taker, words)) return false;
        std::memcpy(static_cast<void*>(made + i), words.data(), sizeof words);
    }
    return true;
}

constexpr std::size_t kQuadIndices = 6;
constexpr std::uint32_t kMostQuads = 127; ///< of a run
/// indices for a byte: a run takes three
constexpr std::uint64_t kMostGrowth = kMostQuads * kQuadIndices / 3;

/// The indices of a quad whose right side begins at `right`; the next row's vertices lie `ahead` of it.
std::array<std::uint32_t, kQuadIndices> quadOf(std::uint32_t right, std::uint32_t ahead)
{
    return {right, right + ahead, right + 1, right + 1, right + ahead, right + ahead + 1};
}

/// Returns how many quads that lie side by side the indices from `at` on begin with.
std::uint32_t quadsFrom(std::span<const std::uint32_t> indices, std::size_t at)
{
    std::uint32_t quads = 0;
    for (; quads < kMostQuads && at + (quads + 1) * kQuadIndices <= indices.size(); ++quads)
    {
        const auto quad = quadOf(indices[at] + quads, indices[at + 1] - indices[at]);
        const auto* const place = indices.data() + at + quads * kQuadIndices;
        if (!std::equal(quad.begin(), quad.end(), place)) break;
    }
    return quads;
}

} // namespace

std::string packedVertices(std::span<const MeshVertex> vertices, std::span<const VertexRows> rows)
{
    std::string bytes;
    const MeshVertex* next = vertices.data();
    for (const VertexRows& span : rows)
    {
        appendShort(bytes, span.count);
        appendShort(bytes, span.columns);
        for (std::uint32_t i = 0; i < span.count; ++i)
            appendVertex(bytes, wordsOf(next[i]), expected(next, i, span.columns));
        next += span.count;
    }
    return bytes;
}

bool unpackVertices(std::string_view bytes, std::uint64_t count, std::vector<MeshVertex>& vertices)
{
    vertices.clear();
    if (count > bytes.size()) return false; // each takes a byte at least
    vertices.reserve(static_cast<std::size_t>(count));
    ShortTaker taker(bytes);
    while (!taker.isEmpty())
    {
        VertexRows span;
        if (!taker.take(span.count) || !taker.take(span.columns) || span.columns == 0 ||
            span.columns > span.count || span.count > count - vertices.size() ||
            !takeSpan(taker, span, vertices))
            return false;
    }
    return vertices.size() == count;
}

std::string packedIndices(std::span<const std::uint32_t> indices)
{
    std::string bytes;
    std::uint32_t next = 0, ahead = 0;
    for (std::size_t at = 0; at < indices.size();)
    {
        const std::uint32_t quads = quadsFrom(indices, at);
        appendShort(bytes, quads);
        appendShort(bytes, foldedDifference(indices[at] - next));
        next = indices[at] + std::max(quads, 1U);
        if (quads > 0)
        {
            appendShort(bytes, foldedDifference(indices[at + 1] - indices[at] - ahead));
            ahead = indices[at + 1] - indices[at];
        }
        at += std::max<std::size_t>(quads * kQuadIndices, 1);
    }
    return bytes;
}

bool unpackIndices(std::string_view bytes, std::uint64_t count, std::vector<std::uint32_t>& indices)
{
    indices.clear();
    if (count > kMostGrowth * bytes.size()) return false;
    indices.reserve(static_cast<std::size_t>(count));
    ShortTaker taker(bytes);
    std::uint32_t next = 0, ahead = 0;
    while (!taker.isEmpty())
    {
        std::uint32_t quads = 0, difference = 0;
        if (!taker.take(quads) || !taker.take(difference) || quads > kMostQuads) return false;
        next += unfoldedDifference(difference);
        if (quads == 0)
        {
            indices.push_back(next++);
            continue;
        }
        if (!taker.take(difference)) return false;
        ahead += unfoldedDifference(difference);
        for (std::uint32_t quad = 0; quad < quads; ++quad, ++next)
            for (const std::uint32_t index : quadOf(next, ahead))
                indices.push_back(index);
    }
    return indices.size() == count;
}

} // namespace osgRoads::core
