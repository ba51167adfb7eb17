// SPDX-License-Identifier: Apache-2.0
#include "scenery/structures/Footbridge.h"

#include <algorithm>
#include <cmath>

namespace scenery
{

namespace
{

constexpr glm::vec3 kFootConcrete(0.62F, 0.61F, 0.58F), kFootSteel(0.50F, 0.52F, 0.53F);
constexpr double kFootRailM = 1.1, kFootPostM = 2.0, kFootEdgeM = 0.12, kFootPierM = 0.35;
constexpr double kLeastPierM = 1.5, kFootingM = 0.8;

class FootbridgeMaker
{
public:
    FootbridgeMaker(const Structure& bridge, const foundation::HeightInPlan& ground, SquareBeams& beams)
        : _bridge(bridge), _ground(ground), _beams(beams)
    {
    }

    void add()
    {
        double alongM = 0.0, postM = 0.0;
        for (std::size_t i = 0; i + 1 < _bridge.line.size(); ++i)
        {
            const glm::dvec3 from(_bridge.line[i], _bridge.heightsM[i]),
                to(_bridge.line[i + 1], _bridge.heightsM[i + 1]);
            const double lengthM = glm::distance(_bridge.line[i], _bridge.line[i + 1]);
            if (lengthM < 1e-3) continue;
            if (_bridge.treads == 0) addDeck(from, to);
            for (const double side : {1.0, -1.0})
                addRailing(i, from, to, side, postM);
            postM = std::fmod(postM - lengthM, kFootPostM);
            if (postM < 0.0) postM += kFootPostM;
            for (const double pierM : _bridge.piersM)
                if (pierM >= alongM && pierM < alongM + lengthM)
                    addPier(glm::mix(from, to, (pierM - alongM) / lengthM), to - from);
            alongM += lengthM;
        }
        if (_bridge.treads > 0) addStairs(alongM);
    }

private:
    /// Treads of one length in the plan, each as high as the way is at its lower end.
    void addStairs(double lengthM)
    {
        std::size_t i = 0;
        double startM = 0.0;
        const auto placeAt = [&](double atM)
        {
            for (; i + 2 < _bridge.line.size(); ++i)
            {
                const double stretchM = glm::distance(_bridge.line[i], _bridge.line[i + 1]);
                if (atM <= startM + stretchM) break;
                startM += stretchM;
            }
            const double stretchM = std::max(1e-6, glm::distance(_bridge.line[i], _bridge.line[i + 1]));
            const double share = std::clamp((atM - startM) / stretchM, 0.0, 1.0);
            return glm::dvec3(glm::mix(_bridge.line[i], _bridge.line[i + 1], share),
                              std::lerp(_bridge.heightsM[i], _bridge.heightsM[i + 1], share));
        };
        glm::dvec3 from = placeAt(0.0);
        for (int tread = 1; tread <= _bridge.treads; ++tread)
        {
            const glm::dvec3 to = placeAt(lengthM * tread / _bridge.treads);
            const double levelM = std::min(from.z, to.z);
            if (glm::distance(glm::dvec2(from), glm::dvec2(to)) > 1e-3)
                addDeck({glm::dvec2(from), levelM}, {glm::dvec2(to), levelM});
            from = to;
        }
    }

    double footM(const glm::dvec3& place) const
    {
        const double deckM = place.z - kFootDeckM;
        if (_bridge.kind == StructureKind::footbridge) return deckM;
        return std::min(deckM, _ground(place).value_or(deckM) - kFootingM);
    }

    void addDeck(const glm::dvec3& from, const glm::dvec3& to)
    {
        const glm::dvec2 along = glm::normalize(glm::dvec2(to - from)), left(-along.y, along.x);
        SquareBeams::in(_beams.at(from), &StructureSquare::low, kFootConcrete)
            .slab({from, to, 0.5 * _bridge.widthM * left, footM(from), footM(to)});
    }

    glm::dvec3 sideOf(std::size_t point, double side) const
    {
        return {_bridge.line[point] + side * 0.5 * _bridge.widthM * leftAt(_bridge.line, point),
                _bridge.heightsM[point]};
    }

    /// Bars on posts. `postM`: from the start of the stretch to its first post.
    void addRailing(std::size_t i, const glm::dvec3& from, const glm::dvec3& to, double side, double postM)
    {
        const glm::dvec3 a = sideOf(i, side), b = sideOf(i + 1, side);
        const double lengthM = glm::distance(glm::dvec2(from), glm::dvec2(to));
        Beams bars = SquareBeams::in(_beams.at(from), &StructureSquare::low, kFootSteel);
        bars.bar(a + glm::dvec3(0, 0, kFootRailM), b + glm::dvec3(0, 0, kFootRailM), 0.035);
        Beams thin = SquareBeams::in(_beams.at(from), &StructureSquare::fine, kFootSteel);
        for (const double high : {kFootEdgeM, 0.45, 0.78})
            thin.bar(a + glm::dvec3(0, 0, high), b + glm::dvec3(0, 0, high), 0.025);
        for (; postM < lengthM; postM += kFootPostM)
        {
            const glm::dvec3 foot = glm::mix(a, b, postM / lengthM);
            thin.bar(foot - glm::dvec3(0, 0, 0.2), foot + glm::dvec3(0, 0, kFootRailM), 0.03);
        }
    }

    void addPier(const glm::dvec3& top, const glm::dvec3& way)
    {
        const auto groundM = _ground(glm::dvec2(top));
        if (!groundM || top.z - kFootDeckM - *groundM < kLeastPierM) return;
        const double footM = *groundM - kFootingM, highM = top.z - 0.9 * kFootDeckM;
        SquareBeams::in(_beams.at(top), &StructureSquare::low, kFootConcrete)
            .box({glm::dvec2(top), 0.5 * (footM + highM)}, glm::normalize(glm::dvec2(way)),
                 {kFootPierM, 0.3 * _bridge.widthM, 0.5 * (highM - footM)});
    }

    const Structure& _bridge;
    const foundation::HeightInPlan& _ground;
    SquareBeams& _beams;
};

} // namespace

void addFootbridge(const Structure& bridge, const foundation::HeightInPlan& ground, SquareBeams& beams)
{
    if (bridge.heightsM.size() == bridge.line.size()) FootbridgeMaker(bridge, ground, beams).add();
}

} // namespace scenery
