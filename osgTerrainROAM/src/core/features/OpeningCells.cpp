// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>

#include <osgTerrainROAM/core/features/OpeningCells.h>

namespace osgTerrainROAM::core
{

namespace
{

using Section = GroundOpening::Section;

constexpr double kLeastCellM = 32.0, kMostCellM = 4096.0;
constexpr int kMostCellsAlong = 512;
constexpr double kPieceOverlapM = 0.02; ///< of neighbouring pieces, besides what their bend needs

/// A straight part of an opening.
struct OpeningPiece
{
    Section from, to;
    glm::dvec4 heights{0.0};
    double beforeM = 0.0, beyondM = 0.0;

    double reachM() const { return std::max(from.halfM, to.halfM) + std::max(beforeM, beyondM); }
    glm::dvec2 low() const { return glm::min(glm::dvec2(from.middle), glm::dvec2(to.middle)) - reachM(); }
    glm::dvec2 high() const { return glm::max(glm::dvec2(from.middle), glm::dvec2(to.middle)) + reachM(); }
};

/// By how much the outer sides of two pieces have to go on so that they meet at a section.
double overlapAt(const std::vector<Section>& line, std::size_t at)
{
    const glm::dvec2 in(line[at].middle - line[at - 1].middle), out(line[at + 1].middle - line[at].middle);
    const double bend = std::fabs(std::atan2(in.x * out.y - in.y * out.x, glm::dot(in, out)));
    return line[at].halfM * std::tan(0.5 * std::min(bend, 2.0)) + kPieceOverlapM;
}

void addPieces(const GroundOpening& opening, std::vector<OpeningPiece>& pieces)
{
    const auto& line = opening.line;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
    {
        OpeningPiece piece{line[i], line[i + 1]};
        piece.heights = {opening.lowM, opening.wallM, opening.kneeM, opening.crownM};
        piece.beforeM = i == 0 ? opening.beyondM : overlapAt(line, i);
        piece.beyondM = i + 2 == line.size() ? opening.beyondM : overlapAt(line, i + 1);
        pieces.push_back(piece);
    }
}

foundation::Outcome checkOpening(const GroundOpening& opening)
{
    const auto isSound = [&](const Section& section)
    {
        const glm::dvec3 size = glm::abs(section.middle - opening.line.front().middle);
        return glm::all(glm::lessThan(size, glm::dvec3(1e6))) && std::fabs(section.halfM) < 1e6; // no NaN
    };
    if (opening.line.size() < 2)
        return foundation::Error{"opening of the ground", "has less than two sections", "give both its ends"};
    if (!std::all_of(opening.line.begin(), opening.line.end(), isSound))
        return foundation::Error{"opening of the ground", "has a place that is no number or lies far off",
                                 "correct the line of its sections"};
    return foundation::success();
}

std::array<float, 4> pieceTexel(double x, double y, double z, double w)
{
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z), static_cast<float>(w)};
}

/// Lays a grid over all pieces.
void layPieceGrid(const std::vector<OpeningPiece>& pieces, OpeningCells& cells)
{
    glm::dvec2 low = pieces.front().low(), high = pieces.front().high();
    for (const OpeningPiece& piece : pieces)
    {
        low = glm::min(low, piece.low());
        high = glm::max(high, piece.high());
    }
    cells.cellM = kLeastCellM;
    while (cells.cellM < kMostCellM &&
           std::max(high.x - low.x, high.y - low.y) > cells.cellM * (kMostCellsAlong - 1))
        cells.cellM *= 2.0;
    cells.firstCell = glm::ivec2(glm::floor(low / cells.cellM));
    const glm::ivec2 last(glm::floor(high / cells.cellM));
    cells.columns = last.x - cells.firstCell.x + 1;
    cells.rows = last.y - cells.firstCell.y + 1;
    cells.cells.resize(static_cast<std::size_t>(cells.columns) * static_cast<std::size_t>(cells.rows));
}

void storePieces(const std::vector<std::vector<const OpeningPiece*>>& lists, OpeningCells& cells)
{
    for (std::size_t i = 0; i < lists.size(); ++i)
    {
        cells.cells[i] = {static_cast<std::uint32_t>(cells.records.size()),
                          static_cast<std::uint32_t>(lists[i].size())};
        const auto columns = static_cast<std::size_t>(cells.columns);
        const glm::dvec2 index = glm::dvec2(cells.firstCell) + glm::dvec2(i % columns, i / columns);
        const glm::dvec2 middle = (index + 0.5) * cells.cellM;
        for (const OpeningPiece* piece : lists[i])
        {
            for (const Section* end : {&piece->from, &piece->to})
                cells.records.push_back(pieceTexel(end->middle.x - middle.x, end->middle.y - middle.y,
                                                   end->middle.z, end->halfM));
            const glm::dvec4& heights = piece->heights;
            cells.records.push_back(pieceTexel(heights.x, heights.y, heights.z, heights.w));
            cells.records.push_back(pieceTexel(piece->beforeM, piece->beyondM, 0.0, 0.0));
        }
    }
}

/// Whether a place, relative to the middle of its cell, lies in a piece: as isInPiece() of
/// GroundOpenings.glsl.
bool isInPiece(const std::array<float, 4>* record, const glm::dvec3& at)
{
    const auto &from = record[0], &to = record[1], &heights = record[2], &ends = record[3];
    const glm::dvec2 way(to[0] - from[0], to[1] - from[1]), away(at.x - from[0], at.y - from[1]);
    const double length = std::max(glm::length(way), 1e-6), along = glm::dot(away, way) / length;
    if (along < -ends[0] || along > length + ends[1]) return false;
    const double share = std::clamp(along / length, 0.0, 1.0);
    const double half = std::lerp(double(from[3]), double(to[3]), share);
    const double aside = std::fabs(way.x * away.y - way.y * away.x) / (length * half);
    const double height = at.z - std::lerp(double(from[2]), double(to[2]), share);
    GroundOpening profile;
    profile.wallM = heights[1];
    profile.kneeM = heights[2];
    profile.crownM = heights[3];
    return aside <= 1.0 && height >= heights[0] && height < profile.roofM(aside);
}

} // namespace

bool OpeningCells::isOpen(const glm::dvec3& place) const
{
    const glm::ivec2 whole(glm::floor(glm::dvec2(place) / cellM)), index = whole - firstCell;
    if (index.x < 0 || index.y < 0 || index.x >= columns || index.y >= rows) return false;
    const Cell& cell = cells[static_cast<std::size_t>(index.y * columns + index.x)];
    const glm::dvec3 at(glm::dvec2(place) - (glm::dvec2(whole) + 0.5) * cellM, place.z);
    for (std::uint32_t i = 0; i < cell.pieces; ++i)
        if (isInPiece(&records[cell.first + i * kTexelsOfPiece], at)) return true;
    return false;
}

foundation::Result<OpeningCells> OpeningCells::build(const std::vector<GroundOpening>& openings)
{
    std::vector<OpeningPiece> pieces;
    for (const GroundOpening& opening : openings)
    {
        if (const auto sound = checkOpening(opening); !sound) return sound.error();
        addPieces(opening, pieces);
    }
    OpeningCells cells;
    if (pieces.empty()) return cells;
    layPieceGrid(pieces, cells);
    std::vector<std::vector<const OpeningPiece*>> lists(cells.cells.size());
    for (const OpeningPiece& piece : pieces)
    {
        const glm::ivec2 low = glm::ivec2(glm::floor(piece.low() / cells.cellM)) - cells.firstCell;
        const glm::ivec2 high = glm::ivec2(glm::floor(piece.high() / cells.cellM)) - cells.firstCell;
        for (int row = low.y; row <= high.y; ++row)
            for (int column = low.x; column <= high.x; ++column)
                lists[static_cast<std::size_t>(row * cells.columns + column)].push_back(&piece);
    }
    storePieces(lists, cells);
    return cells;
}

} // namespace osgTerrainROAM::core
