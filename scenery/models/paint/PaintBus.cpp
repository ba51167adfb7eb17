// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/paint/PaintVehicles.h"
#include "scenery/models/paint/VehiclePainter.h"

namespace scenery::models
{

namespace
{

using View = VehiclePainter::View;

void paintBusSide(VehiclePainter& p, View view)
{
    p.look(view);
    p.box({-5.7F, 1.16F}, {5.78F, 2.50F}, 0.06F,
          VehiclePainter::kBlack); // one dark band behind glass and pillars
    for (int i = 0; i < 7; ++i)
    {
        const float x = -5.62F + 1.42F * static_cast<float>(i);
        p.glass({{x, 1.20F}, {x + 1.36F, 1.20F}, {x + 1.36F, 2.46F}, {x, 2.46F}});
    }
    p.glass({{4.40F, 1.20F}, {5.60F, 1.20F}, {5.56F, 2.46F}, {4.40F, 2.46F}});
    p.box({-5.95F, 0.30F}, {5.95F, 0.42F}, 0.01F, VehiclePainter::kPlastic);
    for (const float x : {-5.2F, -4.1F, 1.1F, 2.0F})
        p.seam({{x, 0.42F}, {x, 1.05F}});
    p.seam({{-5.85F, 1.08F}, {5.80F, 1.08F}});
    for (const float x : {4.12F, -0.42F}) // doors, on the right only
    {
        if (view == View::left) continue;
        p.box({x - 0.02F, 0.36F}, {x + 1.22F, 2.54F}, 0.04F, VehiclePainter::kBlack);
        for (const float leaf : {0.02F, 0.61F})
            p.glass(
                {{x + leaf, 0.48F}, {x + leaf + 0.57F, 0.48F}, {x + leaf + 0.57F, 2.46F}, {x + leaf, 2.46F}});
    }
    p.box({-5.96F, 0.80F}, {-5.84F, 1.02F}, 0.02F, VehiclePainter::kTailLamp);
    for (const float x : {-4.6F, -2.0F, 0.9F})
        p.box({x, 0.62F}, {x + 0.10F, 0.66F}, 0.01F, VehiclePainter::kAmber);
    p.box({-5.75F, 0.55F}, {-4.85F, 0.95F}, 0.02F, VehiclePainter::kShade); // the engine's grille
}

void paintBusEnds(VehiclePainter& p)
{
    p.look(View::front);
    p.glass({{-1.06F, 1.02F}, {1.06F, 1.02F}, {1.04F, 2.46F}, {-1.04F, 2.46F}});
    p.box({-0.98F, 2.50F}, {0.98F, 2.78F}, 0.04F, VehiclePainter::kBlack);
    p.box({-0.70F, 2.57F}, {0.62F, 2.71F}, 0.02F, {0.80F, 0.52F, 0.10F, 0.0F}); // destination sign
    for (int i = 0; i < 11; ++i)
        p.box({-0.67F + 0.117F * static_cast<float>(i), 2.59F},
              {-0.62F + 0.117F * static_cast<float>(i), 2.69F}, 0.005F, VehiclePainter::kBlack);
    p.box({-1.20F, 0.30F}, {1.20F, 0.50F}, 0.05F, VehiclePainter::kPlastic);
    p.pair({0.62F, 0.58F}, {1.06F, 0.78F}, 0.05F, VehiclePainter::kPlastic);
    p.pair({0.66F, 0.61F}, {0.82F, 0.75F}, 0.06F, VehiclePainter::kLamp);
    p.pair({0.86F, 0.61F}, {1.02F, 0.75F}, 0.06F, VehiclePainter::kLamp);
    p.plate({0.0F, 0.58F});
    p.look(View::back);
    p.glass({{-0.95F, 1.60F}, {0.95F, 1.60F}, {0.92F, 2.50F}, {-0.92F, 2.50F}});
    p.seam({{-0.90F, 0.55F}, {-0.90F, 1.45F}, {0.90F, 1.45F}, {0.90F, 0.55F}, {-0.90F, 0.55F}});
    for (int i = 0; i < 5; ++i)
        p.box({-0.60F, 0.95F + 0.07F * static_cast<float>(i)}, {0.60F, 0.98F + 0.07F * static_cast<float>(i)},
              0.01F, VehiclePainter::kShade);
    p.pair({0.95F, 0.72F}, {1.20F, 1.30F}, 0.03F, VehiclePainter::kTailLamp);
    p.pair({0.96F, 0.98F}, {1.19F, 1.10F}, 0.02F, VehiclePainter::kAmber);
    p.pair({0.95F, 2.55F}, {1.10F, 2.66F}, 0.02F, VehiclePainter::kTailLamp);
    p.box({-1.22F, 0.34F}, {1.22F, 0.52F}, 0.04F, VehiclePainter::kPlastic);
    p.plate({0.0F, 0.72F});
    p.look(View::top);
    for (const float x : {-3.4F, 1.6F})
    {
        p.box({x, -0.40F}, {x + 0.8F, 0.40F}, 0.05F, {0.72F, 0.72F, 0.72F, 1.0F}); // hatches
        p.box({x + 0.06F, -0.34F}, {x + 0.74F, 0.34F}, 0.04F, {0.85F, 0.85F, 0.85F, 1.0F});
    }
}

} // namespace

Picture paintBus()
{
    VehiclePainter painter(vehicleForm(VehicleKind::bus));
    paintBusSide(painter, View::side);
    paintBusSide(painter, View::left);
    paintBusEnds(painter);
    return painter.picture();
}

} // namespace scenery::models
