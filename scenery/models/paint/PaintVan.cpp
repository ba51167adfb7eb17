// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/paint/PaintVehicles.h"
#include "scenery/models/paint/VehiclePainter.h"

namespace scenery::models
{

namespace
{

using View = VehiclePainter::View;

void paintVanSide(VehiclePainter& p)
{
    p.look(View::side);
    p.glass({{1.98F, 1.19F}, {1.70F, 1.55F}, {1.42F, 1.88F}, {1.22F, 2.04F}, {0.72F, 2.06F}, {0.70F, 1.20F}});
    p.seam({{1.98F, 1.15F}, {2.02F, 0.85F}});
    p.seam({{0.62F, 2.12F}, {0.60F, 0.42F}, {1.30F, 0.42F}});
    p.seam({{0.56F, 2.20F}, {0.54F, 0.42F}, {-0.80F, 0.42F}, {-0.78F, 2.20F}, {0.56F, 2.20F}});
    p.seam({{-0.80F, 1.22F}, {-2.70F, 1.22F}});
    p.seam({{-0.80F, 1.26F}, {-2.70F, 1.26F}});
    p.box({-2.8F, 0.42F}, {1.35F, 0.50F}, 0.02F, VehiclePainter::kPlastic);
    p.box({-2.8F, 0.24F}, {2.8F, 0.36F}, 0.01F, VehiclePainter::kPlastic);
    p.box({2.30F, 0.24F}, {2.82F, 0.56F}, 0.03F, VehiclePainter::kPlastic);
    p.box({-2.82F, 0.24F}, {-2.45F, 0.50F}, 0.03F, VehiclePainter::kPlastic);
    for (const float x : {0.70F, 0.36F})
        p.box({x, 1.02F}, {x + 0.16F, 1.06F}, 0.012F, VehiclePainter::kBlack);
    p.fill({{2.80F, 0.68F}, {2.74F, 0.92F}, {2.46F, 1.06F}, {2.36F, 1.04F}, {2.48F, 0.80F}},
           VehiclePainter::kLamp);
    p.box({-2.81F, 0.85F}, {-2.72F, 1.45F}, 0.02F, VehiclePainter::kTailLamp);
}

void paintVanTop(VehiclePainter& p)
{
    p.look(View::top);
    p.glass({{2.12F, -0.80F}, {2.17F, 0.0F}, {2.12F, 0.80F}, {1.19F, 0.78F}, {1.17F, 0.0F}, {1.19F, -0.78F}});
    p.box({2.16F, -0.70F}, {2.21F, 0.70F}, 0.015F, VehiclePainter::kPlastic);
    p.seam({{2.30F, -0.84F}, {2.34F, 0.0F}, {2.30F, 0.84F}});
    for (const float x : {-2.2F, -1.5F, -0.8F, -0.1F, 0.6F}) // stiffening ribs of the roof
        p.box({x, -0.72F}, {x + 0.06F, 0.72F}, 0.03F, {0.86F, 0.86F, 0.86F, 1.0F});
}

void paintVanEnds(VehiclePainter& p)
{
    p.look(View::front);
    p.glass({{-0.80F, 1.28F}, {0.80F, 1.28F}, {0.76F, 2.22F}, {-0.76F, 2.22F}});
    p.box({-0.86F, 0.24F}, {0.86F, 0.56F}, 0.06F, VehiclePainter::kPlastic);
    p.box({-0.50F, 0.70F}, {0.50F, 0.88F}, 0.05F, VehiclePainter::kBlack);
    for (int bar = 0; bar < 3; ++bar)
        p.box({-0.47F, 0.725F + 0.05F * static_cast<float>(bar)},
              {0.47F, 0.74F + 0.05F * static_cast<float>(bar)}, 0.006F, VehiclePainter::kChrome);
    p.pair({0.54F, 0.68F}, {0.86F, 1.00F}, 0.06F, VehiclePainter::kLamp);
    p.pair({0.60F, 0.73F}, {0.75F, 0.88F}, 0.07F, {0.55F, 0.57F, 0.60F, 0.0F});
    p.plate({0.0F, 0.46F});
    p.look(View::back);
    p.seam({{0.0F, 0.50F}, {0.0F, 2.32F}});
    p.seam({{-0.86F, 0.50F}, {-0.84F, 2.30F}, {0.84F, 2.30F}, {0.86F, 0.50F}});
    p.glass({{-0.74F, 1.42F}, {-0.10F, 1.42F}, {-0.10F, 2.08F}, {-0.70F, 2.08F}});
    p.glass({{0.74F, 1.42F}, {0.70F, 2.08F}, {0.10F, 2.08F}, {0.10F, 1.42F}});
    p.pair({0.87F, 0.85F}, {1.02F, 1.45F}, 0.02F, VehiclePainter::kTailLamp);
    p.pair({0.88F, 1.12F}, {1.02F, 1.24F}, 0.02F, VehiclePainter::kAmber);
    p.box({-0.98F, 0.30F}, {0.98F, 0.50F}, 0.04F, VehiclePainter::kPlastic);
    p.box({0.04F, 1.05F}, {0.20F, 1.10F}, 0.01F, VehiclePainter::kBlack);
    p.plate({-0.45F, 0.95F});
}

} // namespace

Picture paintVan()
{
    VehiclePainter painter(vehicleForm(VehicleKind::van));
    paintVanSide(painter);
    paintVanTop(painter);
    paintVanEnds(painter);
    return painter.picture();
}

} // namespace scenery::models
