// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/trees/Foliage.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace scenery::models
{

namespace
{

/// The position of a card: where it grows, the direction of its length (`along`) and of its width (`across`).
struct CardPlace
{
    glm::dvec3 stalk, along, across;
    double lengthM;
};

class Cards
{
public:
    Cards(ModelBuilder& builder, const TreeForm& form, const Skeleton& tree)
        : _builder(builder), _form(form), _tree(tree)
    {
    }

    void add(const CardPlace& place)
    {
        const glm::dvec3 side = place.across * (0.5 * place.lengthM * _form.cardWidth);
        const glm::dvec3 bend = glm::cross(place.across, place.along) * (0.16 * place.lengthM);
        std::vector<std::vector<Corner>> rows;
        for (const double t : {0.0, 0.55, 1.0})
        {
            const glm::dvec3 middle = place.stalk + place.along * (place.lengthM * t) - bend * (t * t);
            rows.push_back({cornerAt(middle - side, {0.0, t}), cornerAt(middle + side, {1.0, t})});
        }
        _builder.grid(rows);
    }

private:
    Corner cornerAt(const glm::dvec3& place, const glm::dvec2& uv) const
    {
        const Crown& crown = _tree.crown;
        const double depth = std::min(crown.depthOf(place), 1.0);
        const double share = std::clamp(crown.shareOf(place.z), 0.0, 1.0);
        const double light = glm::mix(0.40, 1.0, glm::smoothstep(0.15, 1.0, std::max(depth, share * share))) *
                             glm::mix(0.78, 1.05, share);
        return {place, glm::vec2(uv), crown.normalAt(place), static_cast<float>(std::min(light, 1.0))};
    }

    ModelBuilder& _builder;
    const TreeForm& _form;
    const Skeleton& _tree;
};

glm::dvec3 anyDirection(Dice& dice)
{
    const double z = dice.between(-1.0, 1.0);
    const double turn = dice.between(0.0, 6.283185307);
    return {std::sqrt(1.0 - z * z) * std::cos(turn), std::sqrt(1.0 - z * z) * std::sin(turn), z};
}

/// Adds cards along a limb, from the share `from` of its length on.
void addCardsAlong(Cards& cards, const TreeForm& form, const Limb& limb, double from, Dice& dice)
{
    const glm::dvec3 whole = glm::normalize(limb.line.back() - limb.line.front());
    for (int k = 0; k < form.cardsPerTwig; ++k)
    {
        const double share = glm::mix(from, 1.0, (k + dice.unit()) / form.cardsPerTwig);
        const double at = share * static_cast<double>(limb.line.size() - 1);
        const auto i = std::min(static_cast<std::size_t>(at), limb.line.size() - 2);
        CardPlace place;
        place.stalk = glm::mix(limb.line[i], limb.line[i + 1], at - static_cast<double>(i));
        place.lengthM = dice.between(form.cardM.low, form.cardM.high);
        const glm::dvec3 level =
            glm::normalize(glm::cross(whole, glm::dvec3(0, 0, 1)) + glm::dvec3(1e-4, 0, 0));
        if (form.flatCards)
        {
            // Sprays stand out to both sides of the bough and tilt down like the halves of a roof.
            const double out = (k % 2 == 0 ? 1.0 : -1.0) * dice.between(0.35, 1.0);
            place.along =
                glm::normalize(whole + level * out - glm::dvec3(0, 0, form.cardHang * std::abs(out)));
            place.across =
                glm::normalize(glm::cross(place.along, glm::dvec3(0, 0, 1)) + 0.35 * anyDirection(dice));
            // The length of a spray is limited by that of its bough, so that the tip of the tree stays
            // pointed.
            place.lengthM =
                std::min(place.lengthM, 0.30 + 0.42 * glm::distance(limb.line.front(), limb.line.back())) *
                glm::mix(1.2, 0.7, share);
        }
        else
        {
            place.along = glm::normalize(0.7 * whole + 0.75 * anyDirection(dice) -
                                         glm::dvec3(0, 0, 1.2 * form.cardHang));
            place.across = anyDirection(dice);
        }
        place.across -= place.along * glm::dot(place.across, place.along);
        if (glm::length(place.across) < 0.1) continue;
        place.across = glm::normalize(place.across);
        if (glm::cross(place.along, place.across).z > 0.0) place.across = -place.across; // cards bend down
        cards.add(place);
    }
}

} // namespace

void addFoliage(ModelBuilder& builder, const TreeForm& form, const Skeleton& tree, Dice& dice)
{
    Cards cards(builder, form, tree);
    for (const Limb& twig : tree.twigs)
        addCardsAlong(cards, form, twig, 0.15, dice);
    for (const Limb& bough : tree.boughs)
        addCardsAlong(cards, form, bough, form.twigsPerBough == 0 ? 0.12 : 0.6, dice);
    for (const Limb& trunk : tree.trunks) // the end of each trunk
    {
        Limb top{{trunk.line[trunk.line.size() - 2], trunk.line.back()}, {}};
        addCardsAlong(cards, form, top, 0.3, dice);
    }
}

} // namespace scenery::models
