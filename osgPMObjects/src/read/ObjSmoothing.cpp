// SPDX-License-Identifier: Apache-2.0
#include "ObjSmoothing.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <span>
#include <vector>

#include <foundation/LineCells.h>
#include <glm/geometric.hpp>

#include <osgPMObjects/core/consolidate/Normals.h>
#include <osgPMObjects/core/mesh/MeshBuilder.h>
#include <osgPMObjects/core/mesh/Wedge.h>
#include <osgPMObjects/core/tessellate/PolygonProjection.h>
#include <osgPMObjects/core/tessellate/Tessellation.h>

namespace osgPMObjects
{

namespace
{

using Cells = std::vector<std::string_view>;

/// A face, and where its line stands in the text.
struct ObjFace
{
    std::size_t begin, end;
    std::uint32_t firstCorner, corners; ///< among all corners
};

/// A line of the text, with those that a backslash at its end joins to it.
struct ObjLine
{
    std::size_t begin, end; ///< in the text, without the last line break
    std::string joined;
};

ObjLine lineAt(std::string_view text, std::size_t begin)
{
    ObjLine line{begin, begin, {}};
    for (std::size_t at = begin; at < text.size(); at = line.end + 1)
    {
        line.end = std::min(text.find('\n', at), text.size());
        line.joined += text.substr(at, line.end - at);
        if (!line.joined.empty() && line.joined.back() == '\r') line.joined.pop_back();
        if (line.joined.empty() || line.joined.back() != '\\') break;
        line.joined.back() = ' ';
    }
    return line;
}

template<class Number>
bool readWhole(std::string_view word, Number& value)
{
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [end, failed] = std::from_chars(word.data(), word.data() + word.size(), value);
    return failed == std::errc() && end == word.data() + word.size();
}

/// Reads the positions, faces and groups of a text, computes normals and writes them into it.
class ObjSmoother
{
public:
    explicit ObjSmoother(std::string_view text) : _text(text) {}

    std::optional<std::string> run()
    {
        for (std::size_t at = 0; at < _text.size();)
        {
            const ObjLine line = lineAt(_text, at);
            if (!read(line)) return std::nullopt;
            at = line.end + 1;
        }
        if (!_namesGroups || _faces.empty()) return std::nullopt;
        _normals.resize(_corners.size(), glm::vec3(0.0f));
        for (const auto& [group, faces] : _groups)
            if (group != 0) smooth(faces);
        for (const ObjFace& face : _faces)
            flatten(face);
        return write();
    }

private:
    /// Returns whether the line is of the format, or of no matter here.
    bool read(const ObjLine& line)
    {
        const Cells cells = foundation::lineCells(line.joined);
        if (cells.empty()) return true;
        if (cells[0] == "v") return readPosition(cells);
        if (cells[0] == "vn") return false;
        if (cells[0] == "s") return readGroup(cells);
        return cells[0] != "f" || readFace(cells, line);
    }

    bool readPosition(const Cells& cells)
    {
        glm::dvec3 p(0.0);
        if (cells.size() < 4 || cells.size() == 5) return false; // one number more divides the others
        for (int i = 0; i < 3; ++i)
            if (!readWhole(cells[static_cast<std::size_t>(i) + 1], p[i]) || !std::isfinite(p[i]))
                return false;
        _positions.push_back(p);
        return true;
    }

    bool readGroup(const Cells& cells)
    {
        _namesGroups = true;
        if (cells.size() < 2) return false;
        if (cells[1] == "off") return _group = 0, true;
        if (cells[1] == "on") return _group = 1, true;
        return readWhole(cells[1], _group);
    }

    bool readFace(const Cells& cells, const ObjLine& line)
    {
        ObjFace face{line.begin, line.end, static_cast<std::uint32_t>(_corners.size()),
                     static_cast<std::uint32_t>(cells.size() - 1)};
        for (std::size_t i = 1; i < cells.size(); ++i)
        {
            const auto count = static_cast<std::int64_t>(_positions.size());
            std::int64_t index = 0;
            if (!readWhole(cells[i].substr(0, cells[i].find('/')), index)) return false;
            index = index < 0 ? count + index : index - 1;
            if (index < 0 || index >= count) return false;
            if (std::count(cells[i].begin(), cells[i].end(), '/') > 1) return false; // names a normal
            _corners.push_back(static_cast<std::uint32_t>(index));
        }
        if (face.corners < 3)
            _corners.resize(face.firstCorner);
        else
        {
            _groups[_group].push_back(static_cast<std::uint32_t>(_faces.size()));
            _faces.push_back(face);
        }
        return true;
    }

    std::vector<glm::dvec3> placesOf(const ObjFace& face) const
    {
        std::vector<glm::dvec3> places;
        for (std::uint32_t i = 0; i < face.corners; ++i)
            places.push_back(_positions[_corners[face.firstCorner + i]]);
        return places;
    }

    /// The triangles of a face, by numbers of its corners. One whose edges cross is a fan.
    static std::vector<core::Triangle> trianglesOf(const std::vector<glm::dvec3>& places)
    {
        const auto count = static_cast<std::uint32_t>(places.size());
        if (count > 3)
            if (const auto cut = core::tessellate(places, std::span(&count, 1)); cut && cut->inserted.empty())
                return cut->triangles;
        std::vector<core::Triangle> fan;
        for (std::uint32_t i = 2; i < count; ++i)
            fan.push_back({0, i - 1, i});
        return fan;
    }

    /// Gives the corners of a group's faces their normals. The group is a mesh of its own, so that others at
    /// its edges do not matter.
    void smooth(const std::vector<std::uint32_t>& faces)
    {
        core::MeshBuilder builder;
        const std::uint32_t material = builder.material({}), part = builder.part("");
        std::vector<std::uint32_t> corners; // three for each triangle
        for (const std::uint32_t f : faces)
            for (const core::Triangle& t : trianglesOf(placesOf(_faces[f])))
            {
                core::Face face{{}, material, part};
                for (std::size_t i = 0; i < 3; ++i)
                {
                    corners.push_back(_faces[f].firstCorner + t[i]);
                    core::Wedge wedge;
                    wedge.position = builder.position(_positions[_corners[corners.back()]]);
                    face.wedges[i] = builder.wedge(wedge);
                }
                builder.face(face);
            }
        core::Mesh mesh = builder.finish();
        const std::vector<std::uint32_t> together(mesh.faces.size(), 1);
        core::computeNormals(mesh, {.groups = together, .onlyMissing = false});
        for (std::size_t c = 0; c < corners.size(); ++c)
            if (_normals[corners[c]] == glm::vec3(0.0f))
                _normals[corners[c]] = core::wedgeOf(mesh, mesh.faces[c / 3].wedges[c % 3]).normal;
    }

    /// Gives corners without a normal that of their face.
    void flatten(const ObjFace& face)
    {
        const glm::dvec3 area = core::areaVector(placesOf(face));
        const double length = glm::length(area);
        const glm::dvec3 up = length > 0.0 ? area / length : glm::dvec3(0.0, 0.0, 1.0);
        for (std::uint32_t i = 0; i < face.corners; ++i)
            if (glm::vec3& normal = _normals[face.firstCorner + i]; normal == glm::vec3(0.0f))
                normal = glm::vec3(up);
    }

    std::string write() const
    {
        std::map<std::array<float, 3>, std::size_t> numbers;
        std::string text, lines;
        std::size_t at = 0;
        for (const ObjFace& face : _faces)
        {
            text += _text.substr(at, face.begin - at);
            at = face.end;
            text += 'f';
            const std::string joined = lineAt(_text, face.begin).joined;
            const Cells cells = foundation::lineCells(joined);
            for (std::uint32_t i = 0; i < face.corners; ++i)
            {
                const glm::vec3& n = _normals[face.firstCorner + i];
                const auto [known, isNew] = numbers.try_emplace({n.x, n.y, n.z}, numbers.size() + 1);
                if (isNew) addNormal(lines, n);
                const std::string_view corner = cells[i + 1];
                text.append(" ").append(corner);
                text += corner.find('/') == corner.npos ? "//" : "/";
                text += std::to_string(known->second);
            }
        }
        text += _text.substr(at);
        return lines + text;
    }

    static void addNormal(std::string& lines, const glm::vec3& n)
    {
        char line[96];
        const int length =
            std::snprintf(line, sizeof line, "vn %.9g %.9g %.9g\n", double(n.x), double(n.y), double(n.z));
        lines.append(line, static_cast<std::size_t>(length));
    }

    std::string_view _text;
    std::vector<glm::dvec3> _positions;
    std::vector<std::uint32_t> _corners; ///< of all faces, one after the other: positions
    std::vector<glm::vec3> _normals;     ///< by corner
    std::vector<ObjFace> _faces;
    std::map<std::uint32_t, std::vector<std::uint32_t>> _groups; ///< 0: none; the faces of each
    std::uint32_t _group = 0;
    bool _namesGroups = false;
};

} // namespace

std::optional<std::string> withGroupNormals(std::string_view obj)
{
    return ObjSmoother(obj).run();
}

} // namespace osgPMObjects
