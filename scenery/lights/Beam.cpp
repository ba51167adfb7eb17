// SPDX-License-Identifier: Apache-2.0
#include "scenery/lights/Beam.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace scenery
{

namespace
{

constexpr double kEdge = 0.01; ///< degrees within which a sector ends

constexpr BeamPoint kAll[]{{0.0, 1.0}};
constexpr BeamPoint kAboveUp[]{{-3.0, 0.0}, {0.0, 0.6}, {2.0, 1.0}, {10.0, 1.0}, {60.0, 0.5}, {90.0, 0.3}};

constexpr BeamPoint kEdgeAside[]{{-180.0, 0.0}, {-90.1, 0.0}, {-90.0, 0.01}, {-20.0, 0.02}, {-8.5, 0.10},
                                 {-5.5, 0.6},   {0.0, 1.0},   {5.5, 0.6},    {8.5, 0.10},   {20.0, 0.02},
                                 {90.0, 0.01},  {90.1, 0.0},  {180.0, 0.0}};
constexpr BeamPoint kEdgeUp[]{{-6.0, 0.0}, {-3.5, 0.8}, {0.0, 1.0},   {3.5, 0.8},
                              {8.0, 0.2},  {15.0, .1},  {30.0, 0.05}, {90.0, 0.02}};
constexpr BeamPoint kApproachAside[]{{-180.0, 0.0}, {-60.0, 0.0}, {-30.0, 0.02}, {-15.0, 0.1},
                                     {-10.0, 0.6},  {0.0, 1.0},   {10.0, 0.6},   {15.0, 0.1},
                                     {30.0, 0.02},  {60.0, 0.0},  {180.0, 0.0}};
constexpr BeamPoint kApproachUp[]{{-9.0, 0.0}, {-5.5, 0.7}, {0.0, 1.0},  {5.5, 0.7},
                                  {9.0, 0.2},  {15.0, 0.1}, {30.0, .03}, {90.0, 0.0}};
constexpr BeamPoint kInsetAside[]{{-180.0, 0.0}, {-20.0, 0.0}, {-8.0, 0.1}, {-5.0, 0.6}, {0.0, 1.0},
                                  {5.0, 0.6},    {8.0, 0.1},   {20.0, 0.0}, {180.0, 0.0}};
constexpr BeamPoint kInsetUp[]{{-5.0, 0.0}, {-3.5, 0.7}, {0.0, 1.0}, {3.5, 0.7}, {9.0, 0.1}, {30.0, 0.0}};
constexpr BeamPoint kPapiAside[]{{-180.0, 0.0}, {-20.0, 0.0}, {-15.0, 0.12}, {-8.0, 0.6}, {0.0, 1.0},
                                 {8.0, 0.6},    {15.0, 0.12}, {20.0, 0.0},   {180.0, 0.0}};
constexpr BeamPoint kPapiUp[]{{-10.0, 0.0}, {-8.0, 0.1}, {-5.0, 0.5}, {0.0, 1.0},
                              {5.0, 0.5},   {8.0, 0.1},  {10.0, 0.0}};
// The lens spreads light down and aside. What goes up is what street and housing throw back.
constexpr BeamPoint kStreetUp[]{{-90.0, 0.35}, {-60.0, 0.6}, {-30.0, 1.0}, {-15.0, 0.8},
                                {-5.0, 0.3},   {0.0, 0.15},  {20.0, 0.12}, {90.0, 0.10}};
constexpr BeamPoint kWindowAside[]{{-180.0, 0.0}, {-90.0, 0.0}, {-45.0, 0.7}, {0.0, 1.0},
                                   {45.0, 0.7},   {90.0, 0.0},  {180.0, 0.0}};
constexpr BeamPoint kWindowUp[]{{-90.0, 0.3}, {0.0, 1.0}, {30.0, 0.9}, {60.0, 0.5}, {90.0, 0.05}};
// 23.1391, of 40 cd; beyond its angle 10 cd may be seen for 10 degrees more and 1 cd elsewhere (23.1395).
constexpr BeamPoint kLeftAside[]{
    {-20.0, 0.0},   {-10.0, 0.02},         {-kEdge, 0.2},          {0.0, 1.0},
    {10.0, 1.0},    {10.0 + kEdge, 0.75},  {20.0, 0.75},           {20.0 + kEdge, 0.125},
    {110.0, 0.125}, {110.0 + kEdge, 0.02}, {120.0 + kEdge, 0.005}, {130.0, 0.0}};
constexpr BeamPoint kRightAside[]{{-130.0, 0.0},
                                  {-120.0 - kEdge, 0.005},
                                  {-110.0 - kEdge, 0.02},
                                  {-110.0, 0.125},
                                  {-20.0 - kEdge, 0.125},
                                  {-20.0, 0.75},
                                  {-10.0 - kEdge, .75},
                                  {-10.0, 1.0},
                                  {0.0, 1.0},
                                  {kEdge, 0.2},
                                  {10.0, 0.02},
                                  {20.0, 0.0}};
constexpr BeamPoint kRearAside[]{{-90.0, 0.0}, {-80.0, 0.02},        {-70.0 - kEdge, 0.2}, {-70.0, 1.0},
                                 {70.0, 1.0},  {70.0 + kEdge, 0.20}, {80.0, 0.02},         {90.0, 0.0}};
// 23.1393: the greatest share of each band, above and below alike.
constexpr BeamPoint kPositionUp[]{
    {-90.0, .05}, {-40.0 - kEdge, .05}, {-40.0, 0.1}, {-30.0 - kEdge, 0.1}, {-30.0, 0.3}, {-20.0 - kEdge, .3},
    {-20.0, 0.5}, {-15.0 - kEdge, .5},  {-15.0, 0.7}, {-10.0 - kEdge, .7},  {-10.0, 0.8}, {-5.0 - kEdge, 0.8},
    {-5.0, 0.9},  {-kEdge, 0.9},        {0.0, 1.0},   {kEdge, 0.9},         {5.0, 0.9},   {5.0 + kEdge, .8},
    {10.0, 0.8},  {10.0 + kEdge, .7},   {15.0, 0.7},  {15.0 + kEdge, 0.5},  {20.0, 0.5},  {20.0 + kEdge, 0.3},
    {30.0, 0.3},  {30.0 + kEdge, 0.1},  {40.0, 0.1},  {40.0 + kEdge, .05},  {90.0, .05}};
// 23.1401 (f): 400, 240, 80, 40 and 20 cd.
constexpr BeamPoint kAnticollisionUp[]{{-75.0, .05}, {-30.0, .05}, {-20.0, .1}, {-10.0, 0.2},
                                       {-5.0, 0.6},  {0.0, 1.0},   {5.0, 0.6},  {10.0, 0.2},
                                       {20.0, 0.1},  {30.0, .05},  {75.0, .05}};
constexpr BeamPoint kLandingAside[]{{-180.0, 0.0}, {-90.0, 0.0}, {-30.0, 0.002}, {-15.0, 0.02},
                                    {-6.0, 0.4},   {0.0, 1.0},   {6.0, 0.4},     {15.0, 0.02},
                                    {30.0, 0.002}, {90.0, 0.0},  {180.0, 0.0}};
constexpr BeamPoint kLandingUp[]{{-30.0, 0.01}, {-15.0, 0.05}, {-5.0, 0.5}, {0.0, 1.0},
                                 {5.0, 0.5},    {15.0, 0.05},  {30.0, 0.01}};
constexpr BeamPoint kLowAside[]{{-180.0, 0.0}, {-90.0, 0.0}, {-45.0, 0.05}, {-20.0, 0.3},
                                {-5.0, 0.9},   {0.0, 1.0},   {5.0, 0.8},    {20.0, 0.3},
                                {45.0, 0.05},  {90.0, 0.0},  {180.0, 0.0}};
// Of 13 000 cd below the edge; 350 cd above it, towards those who come (UN R112: B50L).
constexpr BeamPoint kLowUp[]{{-30.0, 0.0},  {-10.0, 0.15}, {-3.0, 0.6},   {-0.86, 1.0},
                             {-0.57, 0.75}, {-0.1, 0.04},  {0.57, 0.027}, {4.0, 0.02},
                             {20.0, 0.01},  {60.0, 0.005}, {90.0, 0.0}};
constexpr BeamPoint kCarAside[]{{-180.0, 0.0}, {-90.0, 0.0}, {-80.0, 0.1}, {-45.0, 0.4}, {-20.0, 1.0},
                                {20.0, 1.0},   {45.0, 0.4},  {80.0, 0.1},  {90.0, 0.0},  {180.0, 0.0}};
constexpr BeamPoint kCarUp[]{{-60.0, 0.0}, {-15.0, 0.2}, {-5.0, 1.0}, {5.0, 1.0}, {15.0, 0.2}, {60.0, 0.05}};

const std::array<Beam, kBeamKinds>& beams()
{
    static const std::array<Beam, kBeamKinds> all{{{kAll, kAll},
                                                   {kAll, kAboveUp},
                                                   {kEdgeAside, kEdgeUp},
                                                   {kApproachAside, kApproachUp},
                                                   {kInsetAside, kInsetUp},
                                                   {kEdgeAside, kEdgeUp},
                                                   {kPapiAside, kPapiUp},
                                                   {kAll, kStreetUp},
                                                   {kWindowAside, kWindowUp},
                                                   {kLeftAside, kPositionUp},
                                                   {kRightAside, kPositionUp},
                                                   {kRearAside, kPositionUp},
                                                   {kAll, kAnticollisionUp},
                                                   {kLandingAside, kLandingUp},
                                                   {kLowAside, kLowUp},
                                                   {kCarAside, kCarUp}}};
    return all;
}

double along(std::span<const BeamPoint> curve, double deg)
{
    const auto next = std::upper_bound(curve.begin(), curve.end(), deg,
                                       [](double at, const BeamPoint& point) { return at < point.deg; });
    if (next == curve.begin()) return curve.front().share;
    if (next == curve.end()) return curve.back().share;
    const BeamPoint& before = *(next - 1);
    return std::lerp(before.share, next->share, (deg - before.deg) / (next->deg - before.deg));
}

} // namespace

const Beam& beamOf(BeamKind kind)
{
    return beams()[static_cast<std::size_t>(kind)];
}

double shareOf(const Beam& beam, double asideDeg, double upDeg)
{
    return along(beam.aside, std::remainder(asideDeg, 360.0)) * along(beam.up, upDeg);
}

} // namespace scenery
