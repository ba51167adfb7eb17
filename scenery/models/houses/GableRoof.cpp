// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/houses/GableRoof.h"

#include <cmath>

#include "scenery/models/houses/DetailAtlas.h"
#include "scenery/models/mesh/Box.h"
#include "scenery/models/mesh/Tube.h"

namespace scenery::models
{

namespace
{

class Slab
{
public:
    explicit Slab(const GableRoof& roof) : _roof(roof) {}

    /// Returns a point of the cross section at an end. Counter-clockwise, seen against the axis: 0 to 2 eave,
    /// ridge and eave of the upper side, 3 to 5 those of the lower side.
    glm::dvec3 place(std::size_t end, std::size_t point) const
    {
        const double eave = _roof.halfWidth + _roof.overhang;
        const double across = point == 1 || point == 4 ? 0.0 : (point == 0 || point == 5 ? eave : -eave);
        const double under = point >= 3 ? _roof.thickness : 0.0;
        return _roof.base + _roof.axis * (end == 1 ? _roof.to : _roof.from) + _roof.across() * across +
               glm::dvec3(0.0, 0.0, _roof.topAt(std::abs(across)) - under);
    }

    Corner tileCorner(std::size_t end, std::size_t point) const
    {
        const double slopeM = (_roof.halfWidth + _roof.overhang) * std::hypot(1.0, _roof.slope);
        return {place(end, point),
                {static_cast<float>((end == 1 ? _roof.to : _roof.from) / kRoofPictureM),
                 point == 1 ? static_cast<float>(slopeM / kRoofPictureM) : 0.0F}};
    }

    Corner boardCorner(std::size_t end, std::size_t point) const
    {
        const CellUv uv = uvOf(Detail::wood);
        return {place(end, point), uv.at(end == 1 ? 0.9F : 0.1F, point >= 3 ? 0.45F : 0.55F), {}, 0.85F};
    }

private:
    const GableRoof& _roof;
};

} // namespace

void addGableRoof(ModelBuilder& builder, const GableRoof& roof, const Surface& tiles, const glm::vec3& tint,
                  bool hasGutters)
{
    const Slab slab(roof);
    builder.begin("roof", tiles, tint);
    for (const std::size_t side : {std::size_t{0}, std::size_t{1}})
        builder.quad(slab.tileCorner(0, side), slab.tileCorner(0, side + 1), slab.tileCorner(1, side + 1),
                     slab.tileCorner(1, side));
    builder.begin("roof", kHouseDetails, {0.92F, 0.90F, 0.86F});
    const auto board = [&](std::size_t end, std::size_t point) { return slab.boardCorner(end, point); };
    for (std::size_t i = 2; i < 6; ++i)
    {
        const std::size_t next = (i + 1) % 6;
        builder.quad(board(0, i), board(0, next), board(1, next), board(1, i));
    }
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}})
    {
        builder.quad(board(1, i), board(1, i + 1), board(1, 4 - i), board(1, 5 - i));
        builder.quad(board(0, 5 - i), board(0, 4 - i), board(0, i + 1), board(0, i));
    }
    builder.begin("ridge", tiles, tint * 0.9F);
    const glm::dvec3 ridge = roof.base + glm::dvec3(0.0, 0.0, roof.topAt(0.0) - 0.03);
    Tube tube{{ridge + roof.axis * (roof.from - 0.02), ridge + roof.axis * (roof.to + 0.02)},
              {0.11, 0.11},
              8,
              {0.12, 1.0 / kRoofPictureM},
              0.0,
              {}};
    addTube(builder, tube);
    if (!hasGutters) return;
    builder.begin("gutter", kHouseDetails);
    for (const double side : {-1.0, 1.0})
    {
        const glm::dvec3 eave =
            roof.base + roof.across() * (side * (roof.halfWidth + roof.overhang + 0.05)) +
            glm::dvec3(0.0, 0.0, roof.topAt(roof.halfWidth + roof.overhang) - roof.thickness + 0.04);
        addBar(builder, eave + roof.axis * roof.from, eave + roof.axis * roof.to, 0.065, 7,
               uvOf(Detail::zinc).middle());
    }
}

} // namespace scenery::models
