// SPDX-License-Identifier: Apache-2.0
// Shades a place of the ground: normal, ground colour, layers from below to above, light.
// TerrainShader.cpp defines TERRAIN_DRAPE, _LAYERS, _FEATURES, _COVER, _SEASON, _SHEETS, _FINE, _SURROUNDINGS for what the terrain has,
// and _LENT where another surface looks as the ground does: its text defines lentTilt() and lentAlbedo() (TerrainMaterial::lendLook()).

#ifdef TERRAIN_LENT
vec2 lentTilt();
vec3 lentAlbedo(vec3 ground, Grain g, inout GroundKinds kinds);
#endif

const float kWaterSteep = 0.03; // one less the height of the normal: 14 degrees; rapids are less steep
const float kCrowns = 0.2; // of the sky that crowns hide from the floor of a wood

#ifdef SURFACE_WEATHER
// What the ground loses of its reflectance when it is wet: grass, stones, earth, rock; litter; asphalt; what is not known. A loam has 0.14 in
// place of 0.30 (Idso, Jackson, Reginato, Kimball and Nakayama, The dependence of bare soil albedo on soil water content, 1975); rough dark
// surfaces lose some two fifths (Lekner and Dorf, Why some things are darker when wet, 1988, section 4); water runs off blades.
const vec4 kLostOpen = vec4(0.10, 0.35, 0.50, 0.35);
const float kLostLitter = 0.35, kLostAsphalt = 0.40, kLostAny = 0.20;
#endif

// A wood's colour is that of its crowns. Where a map of land cover tells woods, trees stand in them: who stands among them sees last
// year's leaves between the green.
vec3 woodFloor(vec3 crowns, float litter, Grain g)
{
#ifdef PICTURE_LOW
    return crowns;
#else
    float seen = litter * (1.0 - smoothstep(4.0, 14.0, -fromEye.z)) * (1.0 - smoothstep(60.0, 150.0, length(fromEye)));
    float bare = smoothstep(-0.12, 0.06, g.metres28.z + 0.6 * g.metres2.w);
    return mix(crowns, terrainSoil * vec3(0.52, 0.42, 0.34) * (1.0 + 1.3 * g.metres2.z), seen * bare);
#endif
}

// Returns the radiance of the ground towards the eye, without haze.
vec3 groundRadiance(vec3 directionWorld)
{
    vec3 place = fromEye + terrainEyeWrapped;
    Grain g = grainAt(place.xy);
    float coarse = coarseShare(length(fromEye));
    g.metres2.z *= coarse;
    // The grain bends the lookups by a part of a texel: no threshold follows the rows and columns of the maps.
    vec2 bend = g.metres2.xy * terrainBend.x + g.metres28.xy * terrainBend.y + g.metres324.xy * terrainBend.z
              + g.metres4700.xy * terrainBend.w;
    vec2 mapPlace = grid * terrainMapFromGrid.xy + terrainMapFromGrid.zw + bend / vec2(textureSize(terrainLand, 0));
#ifdef TERRAIN_LENT
    vec2 tilt = lentTilt();
#else
    vec2 tilt = texture(terrainNormals, mapPlace).rg * 2.0 - 1.0;
#endif
    vec4 bumpiness = terrainBumpiness;
#ifdef TERRAIN_SHEETS
    sheetTilt(tilt, bumpiness);
#endif
    vec4 land = texture(terrainLand, mapPlace);
#ifdef TERRAIN_FINE
    float edited;
    tilt = fineTilt(tilt, edited);
    land.b *= 1.0 - edited; // what is dug or filled is no water
#endif
#ifdef TERRAIN_SURROUNDINGS
    outerMaps(tilt, land);
#endif
#ifdef TERRAIN_LENT
    land.b = 0.0;
#endif

    float steep = 1.0 - sqrt(max(1.0 - dot(tilt, tilt), 0.0));
#ifdef TERRAIN_SEASON
    land.g = seasonSnow(land.g, place, steep, g);
#endif
    float snow = smoothstep(0.38, 0.62, land.g + 0.30 * g.metres324.w + 0.22 * g.metres28.w + 0.25 * g.metres4700.w
                                            - 0.9 * max(steep - 0.25, 0.0));
    float roughness = mix(1.0 + 1.5 * smoothstep(0.12, 0.35, steep), 0.8, snow);
    vec3 cliffAlong;
    float cliff = cliffGrain(g, place, tilt, steep, cliffAlong);
    GroundKinds kinds;
    vec4 ground = groundColour(land.r, steep, place.z, g, kinds);
#ifdef TERRAIN_COVER
    Cover cover = terrainCover(grid, place.xy, g);
    ground = coveredGround(ground, cover, g, kinds);
    snow = max(snow, smoothstep(0.35, 0.65, cover.snow));
#endif
#ifdef TERRAIN_SEASON
    // Snow lies between the trees.
    snow *= 1.0 - ground.a * clamp(0.5 + 2.2 * g.metres28.z + 1.6 * g.metres2.z, 0.0, 1.0);
#endif
#ifdef SURFACE_WEATHER
    // Crowns stick out of the snow between them; blades do until it is some centimetres deep.
    float depthCm = snowDepth(directionWorld * length(fromEye), 1.0 - steep);
    float fallen = snowShare(depthCm, 2.0, g.metres2.w + 0.5 * g.metres28.w) * (1.0 - 0.55 * ground.a);
    snow = max(snow, fallen);
#endif
#ifdef TERRAIN_FEATURES
    Paint paint = kNoPaint;
#ifdef TERRAIN_LISTED_FEATURES
    paint = listedPaint(place.xy, dFdx(fromEye.xy), dFdy(fromEye.xy));
#endif
#ifdef TERRAIN_FAR_FEATURES
    addFarFeatures(paint, place.xy, dFdx(fromEye.xy), dFdy(fromEye.xy));
#endif
    ground = fieldAlbedo(ground, paint, g, kinds);
    ground.a *= openShare(paint);
    roughness *= 0.25 + 0.75 * openShare(paint);
    tilt -= paint.slope * (openShare(paint) * (1.0 - snow));
#endif
    kinds.open *= 1.0 - snow;
    kinds.other = vec2(snow, kinds.other.y * (1.0 - snow));

    vec3 albedo = ground.rgb;
#ifdef TERRAIN_COVER
    albedo = woodFloor(albedo, min(cover.litter, kinds.other.y), g);
#endif
    float shore = smoothstep(terrainShore, terrainShore + 0.08, land.b + 0.12 * g.metres28.w + 0.12 * g.metres324.w)
                * (1.0 - smoothstep(0.01, 0.05, steep));
#ifdef TERRAIN_SURROUNDINGS
    shore = 0.0; // the texels there are wider than a beach
#endif
#ifdef TERRAIN_LENT
    albedo = lentAlbedo(albedo, g, kinds);
#endif
    albedo = mix(albedo, terrainSand * (1.0 + 0.5 * g.metres2.z + 0.3 * g.metres28.z), shore);
#ifdef SURFACE_WEATHER
    albedo = wetAlbedo(albedo, dot(kinds.open, kLostOpen) + kLostLitter * kinds.other.y);
#endif
    albedo = mix(albedo, terrainSnow * (1.0 + 0.10 * g.metres2.z + 0.10 * g.metres28.z + 0.16 * g.metres324.w + 0.12 * g.metres4700.w), snow);
#if defined(TERRAIN_LAYERS)
    vec4 imagery = layeredImagery(grid);
#elif defined(TERRAIN_DRAPE)
    vec4 imagery = texture(terrainDrape, grid * terrainDrapeFromGrid.xy + terrainDrapeFromGrid.zw);
#endif
#if defined(TERRAIN_LAYERS) || defined(TERRAIN_DRAPE)
    float fine = 1.0 + 0.5 * g.metres2.z + 0.2 * g.metres28.z;
    albedo = mix(albedo, imagery.rgb * imagery.rgb * fine, imagery.a);
#ifdef SURFACE_WEATHER
    albedo = mix(albedo, wetAlbedo(albedo, kLostAny), imagery.a);
    albedo = mix(albedo, terrainSnow, imagery.a * fallen);
#endif
    float water = (1.0 - imagery.a) * smoothstep(0.47, 0.53, land.b);
#else
    float water = smoothstep(0.47, 0.53, land.b);
#endif
#ifdef TERRAIN_COVER
    water = max(water, smoothstep(0.35, 0.65, cover.water));
#endif
#ifdef TERRAIN_FEATURES
    albedo = pavedAlbedo(albedo, paint, g);
#ifdef SURFACE_WEATHER
    float paved = max(max(paint.beds.y, paint.beds.w), paint.beds.z);
    // Wheels press the snow away.
    float onRoad = depthCm * (1.0 - surfaceWeather.w) * (1.0 - 0.8 * paint.marks.z * (1.0 - paint.beds.w));
    float whitened = snowShare(onRoad, 0.4, g.metres2.w + 0.5 * g.metres28.w);
    float sealed = max(paint.beds.y, paint.beds.w) * (1.0 - whitened);
    albedo = mix(albedo, wetAlbedo(albedo, kLostAsphalt), paved);
    albedo = mix(albedo, terrainSnow, paved * whitened);
#endif
    water = max(water, paint.beds.x) * (1.0 - max(max(paint.beds.y, paint.beds.z), paint.beds.w));
#endif
    // Water lies level: where a map is coarser than the bank of a river, the bank is ground.
    water *= 1.0 - smoothstep(kWaterSteep, 2.0 * kWaterSteep, steep);

    bool isUpright = cliff >= 0.5;
    vec3 toRight = dFdx(fromEye), toTop = dFdy(fromEye);
    vec4 detail = groundDetail(kinds, onGround(place, cliffAlong, isUpright), onGround(toRight, cliffAlong, isUpright),
                               onGround(toTop, cliffAlong, isUpright), fromEye);
    albedo *= max(1.0 + detail.w, 0.15);
    // On cliffs the bumps of the two finest layers and the detail lie on the upright plane.
    vec2 upright = g.metres2.xy * (coarse * bumpiness.x * roughness) + detail.xy;
    Grain level = g;
    level.metres2.xy *= coarse * (1.0 - cliff);
    vec2 bent = tilt - bumps(level, bumpiness, roughness, ground.a * (1.0 - snow)) - detail.xy * (1.0 - cliff);
    vec3 normal = normalize(vec3(bent, sqrt(max(1.0 - dot(tilt, tilt), 0.02))) - cliff * (upright.x * cliffAlong + vec3(0.0, 0.0, upright.y)));

    vec3 normalWorld = terrainWorldFromLocal * normal, levelWorld = terrainWorldFromLocal * vec3(tilt, sqrt(max(1.0 - dot(tilt, tilt), 0.02)));
    float sunlit = max(dot(normalWorld, sunDirection()), 0.0);
    // Where no shadow is known, ground that sees little of the sky sees little of the sun.
    sunlit *= sunShare(directionWorld * length(fromEye), levelWorld, smoothstep(0.15, 0.6, land.a));
    float skyShare = land.a * (1.0 - kCrowns * kinds.other.y);
    // Head lamps graze the ground: bumps that look away from them get the light of those beside them.
    vec3 facingLamps = mix(levelWorld, normalWorld, 0.2);
    vec3 colour = albedo * (lightOn(normalWorld, sunlit, skyShare) + headLight(directionWorld * length(fromEye), facingLamps));
#if defined(SURFACE_WEATHER) && defined(TERRAIN_FEATURES)
    float hollow = 0.5 + g.metres28.z + 0.6 * g.metres2.w;
    colour = filmOfWater(colour, directionWorld, levelWorld,
                         0.8 * sealed * min(4.0 * surfaceWeather.x, 1.0) * smoothstep(0.95 - surfaceWeather.x, 1.30 - surfaceWeather.x, hollow));
#endif
    // No branch: software drawing leaves out a loop that no pixel of a group enters.
    for (int i = water > 0.0 ? 0 : 1; i < 1; ++i)
        colour = mix(colour, waterColour(directionWorld, g), water);
#ifdef TERRAIN_COVER
    colour += townLight(cover, place.xy, dFdx(fromEye.xy), dFdy(fromEye.xy));
#endif
#ifdef TERRAIN_FEATURES
    colour += paintLight(paint);
#endif
    return colour;
}
