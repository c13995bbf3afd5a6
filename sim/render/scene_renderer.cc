// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/scene_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "models/support/config_error.h"
#include "models/support/require.h"
#include "sim/render/caption_layout.h"

namespace sidestep::render {
namespace {

constexpr int kMaxShapes = 2000;
constexpr double kFieldOfView_deg = 40.0;    // narrower than MuJoCo's 45: less distortion
constexpr float kShadowHalfWidth_m = 1.6F;   // a small map over a small square stays sharp
constexpr int kLeastCaptionHeight_px = 240;  // in smaller frames words would hide the robot
constexpr double kDiscHalfHeight_m = 5e-4;
constexpr float kArrowGlow = 0.6F;  // arrows keep their colour on the shaded side

struct QualitySettings {
  int shadow_map_px;  // 0: no shadows
  int samples;
  int slices;  // around a round shape; corners cost more than pixels in software
  int stacks;  // along it
};

QualitySettings SettingsOf(RenderQuality quality) {
  switch (quality) {
    case RenderQuality::kDraft:
      return {0, 0, 10, 5};
    case RenderQuality::kFine:
      return {2048, 4, 28, 16};
    case RenderQuality::kNormal:
      break;
  }
  return {0, 0, 14, 8};
}

void ApplyQuality(const RenderOptions& options, mjModel* model) {
  const QualitySettings settings = SettingsOf(options.quality);
  model->vis.global.offwidth = options.width_px;
  model->vis.global.offheight = options.height_px;
  model->vis.global.fovy = static_cast<float>(kFieldOfView_deg);
  model->vis.quality.offsamples = settings.samples;
  model->vis.quality.shadowsize = std::max(1, settings.shadow_map_px);
  model->vis.quality.numslices = settings.slices;
  model->vis.quality.numstacks = settings.stacks;
  model->vis.map.shadowclip = kShadowHalfWidth_m / static_cast<float>(model->stat.extent);
}

int FontScale(int height_px) {
  constexpr double kPercentAPixel = 100.0 / 480.0;  // MuJoCo's own size in its usual window
  constexpr int kStep = 50;                         // its fonts come in these
  const double percent = kPercentAPixel * height_px;
  const int steps = static_cast<int>(std::lround(percent / kStep));
  return std::clamp(kStep * steps, static_cast<int>(mjFONTSCALE_50),
                    static_cast<int>(mjFONTSCALE_300));
}

}  // namespace

SceneRenderer::SceneRenderer(mjModel* model, const RenderOptions& options)
    : model_(model),
      quality_(options.quality),
      has_captions_(options.has_captions && options.height_px >= kLeastCaptionHeight_px),
      data_(MakeData(*model)),
      viewport_{0, 0, options.width_px, options.height_px},
      pixels_(static_cast<std::size_t>(3) * static_cast<std::size_t>(options.width_px) *
              static_cast<std::size_t>(options.height_px)) {
  ApplyQuality(options, model_);
  mjv_defaultScene(&scene_);
  mjv_makeScene(model_, &scene_, kMaxShapes);
  mjv_defaultOption(&shown_);
  scene_.flags[mjRND_SHADOW] = SettingsOf(quality_).shadow_map_px > 0;
  scene_.flags[mjRND_REFLECTION] = 0;
  mjr_defaultContext(&renderer_);
  mjr_makeContext(model_, &renderer_, FontScale(options.height_px));
  mjr_setBuffer(mjFB_OFFSCREEN, &renderer_);
  const mjrRect largest = mjr_maxViewport(&renderer_);
  const bool fits = renderer_.currentBuffer == mjFB_OFFSCREEN && largest.width >= viewport_.width &&
                    largest.height >= viewport_.height;
  if (!fits) {
    mjr_freeContext(&renderer_);
    mjv_freeScene(&scene_);
    throw ConfigError("Mesa has no off-screen buffer of " + std::to_string(options.width_px) +
                      " x " + std::to_string(options.height_px) + " pixels");
  }
}

SceneRenderer::~SceneRenderer() {
  mjr_freeContext(&renderer_);
  mjv_freeScene(&scene_);
}

const std::vector<std::uint8_t>& SceneRenderer::Draw(const Eigen::VectorXd& qpos,
                                                     const FrameContent& content) {
  SIDESTEP_REQUIRE(qpos.size() == model_->nq, qpos.size());
  mju_copy(data_->qpos, qpos.data(), model_->nq);
  mj_kinematics(model_, data_.get());
  mj_comPos(model_, data_.get());
  mj_camlight(model_, data_.get());
  mj_tendon(model_, data_.get());

  mjvCamera camera;
  mjv_defaultCamera(&camera);
  mju_copy3(camera.lookat, content.camera.look_at_W.data());
  camera.distance = content.camera.distance_m;
  camera.azimuth = content.camera.azimuth_deg;
  camera.elevation = content.camera.elevation_deg;
  mjv_updateScene(model_, data_.get(), &shown_, nullptr, &camera, mjCAT_ALL, &scene_);
  // The sun travels with the view, or the robot would walk out of the shadow map.
  for (int i = 0; i < scene_.nlight; ++i) {
    mjvLight& light = scene_.lights[i];
    if (light.headlight || !light.directional) continue;
    for (int axis = 0; axis < 2; ++axis) {
      light.pos[axis] = static_cast<float>(content.camera.look_at_W[axis]) +
                        light.pos[2] * light.dir[axis] / light.dir[2];
    }
  }
  for (const Decoration& decoration : content.decorations) AddDecoration(decoration);
  mjr_render(viewport_, &scene_, &renderer_);
  if (has_captions_) DrawCaptions(content.captions, viewport_, renderer_);
  mjr_readPixels(pixels_.data(), nullptr, viewport_, &renderer_);
  return pixels_;
}

void SceneRenderer::AddDecoration(const Decoration& decoration) {
  if (scene_.ngeom >= scene_.maxgeom) return;  // a crowded frame loses marks, not the robot
  mjvGeom* geom = scene_.geoms + scene_.ngeom++;
  const double radius_m = decoration.radius_m;
  switch (decoration.shape) {
    case Shape::kArrow:
    case Shape::kLine: {
      const int type = decoration.shape == Shape::kArrow ? mjGEOM_ARROW : mjGEOM_CAPSULE;
      mjv_initGeom(geom, type, nullptr, nullptr, nullptr, decoration.color.data());
      const Eigen::Vector3d& a = decoration.from;
      const Eigen::Vector3d& b = decoration.to;
      mjv_makeConnector(geom, type, radius_m, a.x(), a.y(), a.z(), b.x(), b.y(), b.z());
      // MuJoCo 2.2 draws an arrow from its origin to half its length.
      if (type == mjGEOM_ARROW) geom->size[2] *= 2.0F;
      break;
    }
    case Shape::kDisc: {
      const std::array<double, 3> size{radius_m, kDiscHalfHeight_m, 0.0};
      mjv_initGeom(geom, mjGEOM_CYLINDER, size.data(), decoration.from.data(), nullptr,
                   decoration.color.data());
      break;
    }
    case Shape::kSlab: {
      const double cosine = std::cos(decoration.yaw_rad), sine = std::sin(decoration.yaw_rad);
      const std::array<double, 9> turn{cosine, -sine, 0.0, sine, cosine, 0.0, 0.0, 0.0, 1.0};
      mjv_initGeom(geom, mjGEOM_BOX, decoration.half_m.data(), decoration.from.data(), turn.data(),
                   decoration.color.data());
      break;
    }
    case Shape::kBall: {
      const std::array<double, 3> size{radius_m, radius_m, radius_m};
      mjv_initGeom(geom, mjGEOM_SPHERE, size.data(), decoration.from.data(), nullptr,
                   decoration.color.data());
      break;
    }
  }
  geom->category = mjCAT_DECOR;
  geom->objtype = mjOBJ_UNKNOWN;
  geom->objid = -1;
  geom->emission = decoration.shape == Shape::kSlab ? 0.2F : kArrowGlow;
  geom->specular = 0.0F;
  const std::size_t length = decoration.label.copy(geom->label, sizeof geom->label - 1);
  geom->label[length] = '\0';
}

}  // namespace sidestep::render
