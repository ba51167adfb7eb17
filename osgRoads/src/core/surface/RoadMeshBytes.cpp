// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include <foundation/PlainBytes.h>
#include <foundation/ShortNumbers.h>

#include <osgRoads/core/surface/RoadMeshBytes.h>

namespace osgRoads::core
{

namespace
{

using foundation::appendShort;
using foundation::appendText;
using foundation::appendValue;
using foundation::appendValues;
using foundation::foldedDifference;
using foundation::ShortTaker;
using foundation::unfoldedDifference;
using foundation::ValueTaker;

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

/// Vertices that follow each other, in rows across a road.
struct RowSpan
{
    std::uint32_t count = 0, columns = 1;
};

/// Returns how many vertices of a chunk lie in a row: those that are as far along the road as the first.
std::uint32_t columnsOf(const RoadMesh& mesh, const RoadChunk& chunk)
{
    const auto first = mesh.vertices.begin() + static_cast<std::ptrdiff_t>(chunk.firstVertex);
    const auto end = first + static_cast<std::ptrdiff_t>(chunk.vertexCount);
    const auto other =
        std::find_if(first, end, [&](const MeshVertex& vertex) { return vertex.s != first->s; });
    return static_cast<std::uint32_t>(std::max<std::ptrdiff_t>(other - first, 1));
}

/// Returns the rows of the chunks, or, where these do not follow each other, all vertices in one column.
std::vector<RowSpan> rowSpansOf(const RoadMesh& mesh)
{
    std::vector<RowSpan> spans;
    std::uint64_t next = 0;
    const auto all = mesh.vertices.size();
    for (const RoadChunk& chunk : mesh.chunks)
    {
        if (chunk.firstVertex != next || chunk.vertexCount > all - next)
            return {{static_cast<std::uint32_t>(all), 1}};
        if (chunk.vertexCount > 0) spans.push_back({chunk.vertexCount, columnsOf(mesh, chunk)});
        next += chunk.vertexCount;
    }
    if (next < all) spans.push_back({static_cast<std::uint32_t>(all - next), 1});
    return spans;
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

bool takeSpan(ShortTaker& taker, const RowSpan& span, std::vector<MeshVertex>& vertices)
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
std::uint32_t quadsFrom(const std::vector<std::uint32_t>& indices, std::size_t at)
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

/// Returns the vertices of a mesh in about a quarter of their bytes: each number is a difference to what the
/// rows before it let expect, which is mostly nothing. No bit is lost. What grows beyond `mostBytes` ends
/// early, and cannot be unpacked.
std::string packedVertices(const RoadMesh& mesh, std::uintmax_t mostBytes)
{
    const std::vector<RowSpan> spans = rowSpansOf(mesh);
    std::string bytes;
    const MeshVertex* next = mesh.vertices.data();
    for (const RowSpan& span : spans)
    {
        if (bytes.size() > mostBytes) break;
        appendShort(bytes, span.count);
        appendShort(bytes, span.columns);
        for (std::uint32_t i = 0; i < span.count; ++i)
            appendVertex(bytes, wordsOf(next[i]), expected(next, i, span.columns));
        next += span.count;
    }
    return bytes;
}

/// False: packedVertices() did not make the bytes of so many vertices. `vertices` is replaced.
bool unpackVertices(std::string_view bytes, std::uint64_t count, std::vector<MeshVertex>& vertices)
{
    vertices.clear();
    if (count > bytes.size()) return false; // each takes a byte at least
    vertices.reserve(static_cast<std::size_t>(count));
    ShortTaker taker(bytes);
    while (!taker.isEmpty())
    {
        RowSpan span;
        if (!taker.take(span.count) || !taker.take(span.columns) || span.columns == 0 ||
            span.columns > span.count || span.count > count - vertices.size() ||
            !takeSpan(taker, span, vertices))
            return false;
    }
    return vertices.size() == count;
}

/// Returns indices in about an eighth of their bytes: rows of quads as their first vertex, their step from
/// row to row and their number, and what is no quad index by index. No bit is lost.
std::string packedIndices(const std::vector<std::uint32_t>& indices)
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

/// False: packedIndices() did not make the bytes of so many indices. `indices` is replaced; they may lie
/// beyond all vertices.
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

void appendChunk(std::string& bytes, const RoadChunk& chunk)
{
    appendValue(bytes, chunk.road);
    appendValue(bytes, chunk.sStart);
    appendValue(bytes, chunk.sEnd);
    appendValue(bytes, chunk.centre);
    appendValue(bytes, chunk.radius);
    appendValue(bytes, chunk.firstVertex);
    appendValue(bytes, chunk.vertexCount);
    appendValue(bytes, static_cast<std::uint64_t>(chunk.levels.size()));
    for (const ChunkLevel& level : chunk.levels)
    {
        appendValue(bytes, level.firstIndex);
        appendValue(bytes, level.indexCount);
        appendValue(bytes, level.errorM);
        appendValue(bytes, level.pavedCount);
    }
}

bool takeChunk(ValueTaker& taker, RoadChunk& chunk)
{
    constexpr std::size_t kLevelBytes = 3 * sizeof(std::uint32_t) + sizeof(double);
    std::uint64_t levels = 0;
    if (!taker.take(chunk.road) || !taker.take(chunk.sStart) || !taker.take(chunk.sEnd) ||
        !taker.take(chunk.centre) || !taker.take(chunk.radius) || !taker.take(chunk.firstVertex) ||
        !taker.take(chunk.vertexCount) || !taker.takeCount(levels, kLevelBytes))
        return false;
    chunk.levels.resize(static_cast<std::size_t>(levels));
    for (ChunkLevel& level : chunk.levels)
        if (!taker.take(level.firstIndex) || !taker.take(level.indexCount) || !taker.take(level.errorM) ||
            !taker.take(level.pavedCount))
            return false;
    return true;
}

/// Whether a range of so many numbers lies within all.
bool isWithin(std::uint64_t first, std::uint64_t count, std::size_t all)
{
    return first <= all && count <= all - first;
}

bool isChunkOf(const RoadMesh& mesh, const RoadChunk& chunk)
{
    if (!isWithin(chunk.firstVertex, chunk.vertexCount, mesh.vertices.size())) return false;
    return std::all_of(chunk.levels.begin(), chunk.levels.end(),
                       [&](const ChunkLevel& level)
                       {
                           return isWithin(level.firstIndex, level.indexCount, mesh.indices.size()) &&
                                  level.pavedCount <= level.indexCount;
                       });
}

bool takeVertices(ValueTaker& taker, std::vector<MeshVertex>& vertices)
{
    std::uint64_t count = 0;
    std::string_view packed;
    return taker.take(count) && taker.take(packed) && unpackVertices(packed, count, vertices);
}

bool takeIndices(ValueTaker& taker, std::vector<std::uint32_t>& indices)
{
    std::uint64_t count = 0;
    std::string_view packed;
    return taker.take(count) && taker.take(packed) && unpackIndices(packed, count, indices);
}

bool canBeDrawn(const RoadMesh& mesh)
{
    const std::size_t vertices = mesh.vertices.size(), marks = mesh.marks.size(), decals = mesh.decals.size();
    return std::all_of(mesh.indices.begin(), mesh.indices.end(),
                       [&](std::uint32_t index) { return index < vertices; }) &&
           std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                       [&](const MeshVertex& vertex)
                       {
                           return vertex.kind <= SurfaceKind::skirt && vertex.rightRow < marks &&
                                  vertex.leftRow < marks && vertex.decalRow < decals;
                       }) &&
           std::all_of(mesh.chunks.begin(), mesh.chunks.end(),
                       [&](const RoadChunk& chunk) { return isChunkOf(mesh, chunk); });
}

} // namespace

std::optional<std::string> bytesOf(const RoadMesh& mesh, std::uintmax_t mostBytes)
{
    const std::string vertices = packedVertices(mesh, mostBytes);
    if (vertices.size() > mostBytes) return std::nullopt;
    std::string bytes;
    appendValue(bytes, mesh.origin);
    appendValue(bytes, static_cast<std::uint64_t>(mesh.vertices.size()));
    appendText(bytes, vertices);
    appendValue(bytes, static_cast<std::uint64_t>(mesh.indices.size()));
    appendText(bytes, packedIndices(mesh.indices));
    appendValues(bytes, mesh.marks);
    appendValues(bytes, mesh.unreached);
    appendValues(bytes, mesh.decals);
    appendValue(bytes, static_cast<std::uint64_t>(mesh.chunks.size()));
    for (const RoadChunk& chunk : mesh.chunks)
        appendChunk(bytes, chunk);
    return bytes.size() > mostBytes ? std::nullopt : std::optional(std::move(bytes));
}

std::optional<RoadMesh> roadMeshIn(std::string_view bytes)
{
    RoadMesh mesh;
    ValueTaker taker(bytes);
    std::uint64_t chunks = 0;
    if (!taker.take(mesh.origin) || !takeVertices(taker, mesh.vertices) ||
        !takeIndices(taker, mesh.indices) || !taker.take(mesh.marks) || !taker.take(mesh.unreached) ||
        !taker.take(mesh.decals) || !taker.takeCount(chunks, sizeof(std::uint64_t)))
        return std::nullopt;
    mesh.chunks.resize(static_cast<std::size_t>(chunks));
    for (RoadChunk& chunk : mesh.chunks)
        if (!takeChunk(taker, chunk)) return std::nullopt;
    return taker.isEmpty() && canBeDrawn(mesh) ? std::optional(std::move(mesh)) : std::nullopt;
}

} // namespace osgRoads::core
