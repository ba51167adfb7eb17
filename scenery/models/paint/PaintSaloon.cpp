// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/paint/PaintVehicles.h"
#include "scenery/models/paint/VehiclePainter.h"

namespace scenery::models
{

namespace
{

using View = VehiclePainter::View;

/// The side but for the windows behind the front door.
void paintCarSide(VehiclePainter& p)
{
    p.look(View::side);
    p.glass({{0.98F, 0.955F},
             {0.74F, 1.13F},
             {0.45F, 1.285F},
             {0.15F, 1.345F},
             {-0.09F, 1.355F},
             {-0.12F, 0.965F}});
    p.seam({{1.02F, 0.90F}, {1.03F, 0.62F}, {0.96F, 0.33F}, {-0.10F, 0.33F}});
    p.seam({{-0.15F, 0.95F}, {-0.13F, 0.60F}, {-0.10F, 0.33F}, {-0.86F, 0.33F}});
    p.seam({{-1.20F, 0.98F}, {-1.14F, 0.80F}, {-0.95F, 0.66F}});
    p.box({-2.25F, 0.20F}, {2.25F, 0.27F}, 0.01F, VehiclePainter::kPlastic);
    for (const float x : {-0.06F, -1.08F})
    {
        p.box({x, 0.80F}, {x + 0.21F, 0.845F}, 0.015F, VehiclePainter::kShade);
        p.box({x + 0.01F, 0.815F}, {x + 0.20F, 0.838F}, 0.008F, VehiclePainter::kChrome);
    }
    p.fill({{2.25F, 0.60F}, {2.23F, 0.70F}, {2.02F, 0.765F}, {1.86F, 0.76F}, {1.98F, 0.66F}, {2.16F, 0.60F}},
           VehiclePainter::kLamp);
    p.fill({{-2.25F, 0.74F}, {-2.25F, 0.89F}, {-1.98F, 0.89F}, {-1.92F, 0.83F}, {-2.06F, 0.74F}},
           VehiclePainter::kTailLamp);
    p.seam({{1.95F, 0.56F}, {1.78F, 0.52F}});
    p.seam({{-1.78F, 0.58F}, {-2.00F, 0.62F}, {-2.25F, 0.62F}});
    p.box({1.20F, 0.60F}, {1.28F, 0.63F}, 0.01F, VehiclePainter::kAmber);
}

/// Windscreen, bonnet and head lamps from above.
void paintCarTop(VehiclePainter& p)
{
    p.look(View::top);
    p.glass({{1.15F, -0.66F},
             {1.19F, -0.30F},
             {1.20F, 0.0F},
             {1.19F, 0.30F},
             {1.15F, 0.66F},
             {0.46F, 0.575F},
             {0.42F, 0.0F},
             {0.46F, -0.575F}});
    p.seam({{1.26F, -0.76F}, {1.30F, 0.0F}, {1.26F, 0.76F}});
    for (const float side : {-1.0F, 1.0F})
    {
        p.seam({{1.30F, side * 0.74F}, {1.75F, side * 0.72F}, {2.08F, side * 0.60F}});
        p.fill({{2.25F, side * 0.60F},
                {2.12F, side * 0.74F},
                {1.98F, side * 0.80F},
                {1.92F, side * 0.72F},
                {2.10F, side * 0.56F}},
               VehiclePainter::kLamp);
    }
    p.box({1.20F, -0.62F}, {1.235F, 0.62F}, 0.012F, VehiclePainter::kPlastic);
}

void paintBoot(VehiclePainter& p)
{
    p.look(View::side);
    p.glass({{-0.18F, 0.965F},
             {-0.17F, 1.355F},
             {-0.55F, 1.335F},
             {-0.90F, 1.235F},
             {-1.22F, 1.055F},
             {-1.26F, 0.995F}});
    p.look(View::top);
    p.glass({{-0.92F, -0.56F},
             {-0.89F, 0.0F},
             {-0.92F, 0.56F},
             {-1.46F, 0.61F},
             {-1.49F, 0.0F},
             {-1.46F, -0.61F}});
    for (const float side : {-1.0F, 1.0F})
        p.seam({{-1.56F, side * 0.64F}, {-2.10F, side * 0.62F}});
    p.seam({{-1.56F, -0.64F}, {-1.60F, 0.0F}, {-1.56F, 0.64F}});
}

/// The windows behind the front door of an estate, and the pane of its tailgate.
void paintTailgate(VehiclePainter& p)
{
    p.look(View::side);
    p.glass({{-0.18F, 0.965F}, {-0.17F, 1.355F}, {-0.90F, 1.345F}, {-1.02F, 1.30F}, {-1.06F, 0.985F}});
    p.glass({{-1.12F, 0.985F}, {-1.09F, 1.335F}, {-1.60F, 1.315F}, {-1.82F, 1.22F}, {-1.90F, 1.03F}});
    p.look(View::back);
    p.glass({{-0.60F, 0.99F}, {-0.52F, 1.30F}, {0.52F, 1.30F}, {0.60F, 0.99F}});
}

void paintCarEnds(VehiclePainter& p)
{
    p.look(View::front);
    p.box({-0.62F, 0.20F}, {0.62F, 0.35F}, 0.03F, VehiclePainter::kPlastic);
    p.box({-0.46F, 0.53F}, {0.46F, 0.635F}, 0.035F, VehiclePainter::kBlack);
    for (int bar = 0; bar < 3; ++bar)
        p.box({-0.44F, 0.548F + 0.03F * static_cast<float>(bar)},
              {0.44F, 0.556F + 0.03F * static_cast<float>(bar)}, 0.003F, VehiclePainter::kChrome);
    p.pair({0.52F, 0.58F}, {0.84F, 0.74F}, 0.05F, VehiclePainter::kPlastic);
    p.pair({0.54F, 0.595F}, {0.82F, 0.725F}, 0.045F, VehiclePainter::kLamp);
    p.pair({0.58F, 0.615F}, {0.68F, 0.70F}, 0.04F, {0.55F, 0.57F, 0.60F, 0.0F});
    p.pair({0.62F, 0.32F}, {0.78F, 0.40F}, 0.03F, VehiclePainter::kPlastic);
    p.plate({0.0F, 0.43F});
    p.look(View::back);
    p.pair({0.42F, 0.74F}, {0.85F, 0.89F}, 0.03F, VehiclePainter::kTailLamp);
    p.pair({0.46F, 0.80F}, {0.60F, 0.86F}, 0.02F, {0.85F, 0.84F, 0.82F, 0.0F});
    p.seam({{-0.42F, 0.98F}, {-0.40F, 0.62F}, {0.40F, 0.62F}, {0.42F, 0.98F}});
    p.box({-0.80F, 0.20F}, {0.80F, 0.36F}, 0.03F, VehiclePainter::kPlastic);
    p.box({-0.32F, 0.70F}, {0.32F, 0.84F}, 0.02F, VehiclePainter::kShade);
    p.plate({0.0F, 0.77F});
}

} // namespace

namespace
{

Picture paintCar(VehicleKind kind)
{
    VehiclePainter painter(vehicleForm(kind));
    paintCarSide(painter);
    paintCarTop(painter);
    paintCarEnds(painter);
    if (kind == VehicleKind::saloon)
        paintBoot(painter);
    else
        paintTailgate(painter);
    return painter.picture();
}

} // namespace

Picture paintSaloon()
{
    return paintCar(VehicleKind::saloon);
}

Picture paintEstate()
{
    return paintCar(VehicleKind::estate);
}

} // namespace scenery::models
