// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_frames.h"

#include <array>

#include "models/import/mjcf_pose.h"
#include "models/mjcf/mjcf.h"
#include "models/mjcf/mjcf_message.h"
#include "models/support/config_error.h"
#include "models/urdf_to_mjcf/mjcf_text.h"

namespace sidestep::importer {
namespace {

constexpr std::array<const char*, 6> kPose{"pos", "quat", "axisangle", "xyaxes", "zaxis", "euler"};

/// A body with nothing but the element's pose.
XmlElement PoseOnly(const XmlElement& element) {
  XmlElement body{"body", {}, {}, element.file, element.place};
  for (const char* key : kPose) {
    if (element.Find(key) != nullptr) body.Set(key, element.Text(key));
  }
  return body;
}

/// MuJoCo's reading of poses inside each other. Throws ConfigError if it can't read them.
Eigen::Isometry3d PoseIn(const std::vector<const XmlElement*>& elements,
                         const XmlElement& compiler) {
  XmlElement nested = PoseOnly(*elements.back());
  for (std::size_t i = elements.size() - 1; i > 0; --i) {
    XmlElement outer = PoseOnly(*elements[i - 1]);
    outer.children.push_back(std::move(nested));
    nested = std::move(outer);
  }
  XmlElement settings{"compiler", {}, {}, 0, 0};
  for (const char* key : {"angle", "eulerseq"}) {
    if (compiler.Find(key) != nullptr) settings.Set(key, compiler.Text(key));
  }
  const XmlElement world{"worldbody", {}, {std::move(nested)}, 0, 0};
  const XmlElement root{"mujoco", {}, {std::move(settings), world}, 0, 0};
  const MjModelPtr model = CompileMjcf(XmlText(root, nullptr), "", "");
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  for (int body = 1; body < model->nbody; ++body) {
    X = X * PoseOf(model->body_pos + 3 * body, model->body_quat + 4 * body);
  }
  return X;
}

}  // namespace

std::string PutIntoFrames(const std::vector<const XmlElement*>& frames, const XmlElement& compiler,
                          XmlElement* body) {
  if (frames.empty()) return {};
  for (auto frame = frames.rbegin(); frame != frames.rend(); ++frame) {
    if (body->Find("childclass") == nullptr && (*frame)->Find("childclass") != nullptr) {
      body->Set("childclass", (*frame)->Text("childclass"));
    }
  }
  std::vector<const XmlElement*> elements = frames;
  elements.push_back(body);
  try {
    const Eigen::Isometry3d X = PoseIn(elements, compiler);
    for (const char* key : kPose) body->Erase(key);
    const Eigen::Quaterniond q(X.linear());
    body->Set("pos", Numbers(X.translation()));
    body->Set("quat", Numbers(Eigen::Vector4d(q.w(), q.x(), q.y(), q.z())));
  } catch (const ConfigError& error) {
    return ReadMjcfMessage(error.what()).what;
  }
  return {};
}

}  // namespace sidestep::importer
