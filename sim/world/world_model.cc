// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/world_model.h"

#include <filesystem>
#include <sstream>
#include <string>

#include "models/mjcf/ground.h"
#include "sim/scenario/scenario.h"

namespace sidestep {
namespace {

constexpr double kFootPlateThickness_m = 0.02;  // of the centroidal plant's drawn feet

// Sky, light and how they look.
std::string Surroundings() {
  return R"(
  <visual>
    <headlight ambient="0.35 0.35 0.35" diffuse="0.35 0.35 0.35" specular="0.1 0.1 0.1"/>
    <map znear="0.02" zfar="60" fogstart="8" fogend="25"/>
    <rgba fog="0.80 0.86 0.92 1" haze="0.80 0.86 0.92 1"/>
  </visual>
  <asset>
    <texture name="sky" type="skybox" builtin="gradient" rgb1="0.80 0.86 0.92"
             rgb2="0.42 0.56 0.74" width="64" height="384"/>
    <texture name="floor" type="2d" builtin="checker" rgb1="0.78 0.80 0.82"
             rgb2="0.68 0.70 0.73" width="256" height="256"/>
    <material name="floor" texture="floor" texrepeat="2 2" texuniform="true" specular="0.1"
              reflectance="0"/>
  </asset>
  <worldbody>
    <light name="sun" directional="true" pos="0 0 6" dir="-0.35 0.45 -1" diffuse="0.6 0.6 0.6"
           castshadow="true"/>
  </worldbody>
)";
}

// The foot's geoms have a higher priority than the ground, so that their own contact parameters
// hold; sliding friction is set on every geom afterwards.
void WriteGround(std::ostream& xml) {
  xml << "<worldbody><geom name=\"" << kGroundGeom << "\" type=\"plane\" size=\"0 0 0.5\""
      << " material=\"floor\" condim=\"3\" contype=\"1\" conaffinity=\"1\" "
         "group=\"0\"/></worldbody>";
}

// Half extents of the rectangle that holds the foot's vertices.
Eigen::Vector3d FootHalfExtent_m(const FootDescription& foot) {
  return 0.5 * (foot.vertices_m.rowwise().maxCoeff() - foot.vertices_m.rowwise().minCoeff());
}

// A ball for the CoM and a plate or a small ball for each foot, moved by hand, touching nothing.
std::string CentroidalStandIn(const RobotDescription& robot) {
  std::ostringstream xml;
  xml << "<default><geom contype=\"0\" conaffinity=\"0\" group=\"1\"/></default><worldbody>"
      << "<body name=\"com\" pos=\"0 0 " << robot.com_height_m << "\"><freejoint/>"
      << "<geom type=\"sphere\" size=\"0.06\" rgba=\"0.10 0.45 0.78 1\" mass=\"" << robot.mass_kg
      << "\"/></body>";
  for (const FootDescription& foot : robot.feet) {
    const Eigen::Vector3d half_m = FootHalfExtent_m(foot);
    xml << "<body name=\"" << foot.name << "\"><freejoint/>";
    if (half_m.head<2>().minCoeff() > 0.0) {
      xml << "<geom type=\"box\" size=\"" << half_m.x() << " " << half_m.y() << " "
          << 0.5 * kFootPlateThickness_m << "\" pos=\"0 0 " << 0.5 * kFootPlateThickness_m << "\"";
    } else {
      xml << "<geom type=\"sphere\" size=\"0.025\" pos=\"0 0 0.025\"";
    }
    xml << " rgba=\"0.16 0.18 0.22 1\" mass=\"0.01\"/></body>";
  }
  xml << "</worldbody>";
  return xml.str();
}

// A URDF's shapes touch only what is listed, so its world names the pairs: MuJoCo's search for
// others (a sweep over all bodies, sorted anew) takes a fifth of the iCub's step and finds none.
std::string ListedContacts(const RobotModel& model) {
  if (model.ground_pairs.empty()) return {};
  return "<option collision=\"predefined\"/><contact>" + model.ground_pairs + "</contact>";
}

// Sliding friction of the ground with everything.
void SetFriction(double friction, mjModel* model) {
  for (int geom = 0; geom < model->ngeom; ++geom) model->geom_friction[3 * geom] = friction;
  const int ground = mj_name2id(model, mjOBJ_GEOM, kGroundGeom);
  for (int pair = 0; pair < model->npair; ++pair) {
    if (model->pair_geom1[pair] != ground && model->pair_geom2[pair] != ground) continue;
    model->pair_friction[5 * pair] = friction;
    model->pair_friction[5 * pair + 1] = friction;
  }
}

// Every body heavier at the same shape. What MuJoCo derives from masses is derived again.
void ScaleMasses(double scale, mjModel* model) {
  if (scale == 1.0) return;
  mju_scl(model->body_mass, model->body_mass, scale, model->nbody);
  mju_scl(model->body_inertia, model->body_inertia, scale, 3 * model->nbody);
  const MjDataPtr data = MakeData(*model);
  mj_setConst(model, data.get());
}

/// What is written into a world's document beside its surroundings.
struct Inhabitant {
  std::string xml;             ///< May include robot.xml.
  std::string robot_xml;       ///< Text of robot.xml; empty: none is included.
  std::filesystem::path file;  ///< Named where it does not compile.
};

MjModelPtr Compile(const std::string& name, const Inhabitant& inhabitant,
                   const WorldParams& params) {
  std::ostringstream xml;
  xml << "<mujoco model=\"" << name << "_world\">"
      << "<option timestep=\"" << params.step_s << "\" integrator=\"Euler\"/>" << Surroundings();
  WriteGround(xml);
  xml << inhabitant.xml << "</mujoco>";
  MjModelPtr model = CompileMjcf(xml.str(), inhabitant.robot_xml, inhabitant.file);
  SetFriction(params.friction, model.get());
  ScaleMasses(params.mass_scale, model.get());
  return model;
}

}  // namespace

MjModelPtr CompileRobotWorld(const RobotDescription& robot, const WorldParams& params,
                             ModelDetail detail) {
  const RobotModel& model = RequireModel(robot);
  return Compile(
      robot.name,
      {"<include file=\"robot.xml\"/>" + ListedContacts(model), model.mjcf(detail), model.file},
      params);
}

MjModelPtr CompileCentroidalStandIn(const RobotDescription& robot, const WorldParams& params) {
  return Compile(robot.name, {CentroidalStandIn(robot), "", robot.file}, params);
}

MjModelPtr CompileDrawnWorld(const Scenario& scenario) {
  const RobotDescription& robot = scenario.robot;
  return scenario.plant == Plant::kCentroidal
             ? CompileCentroidalStandIn(robot, scenario.world)
             : CompileRobotWorld(robot, scenario.world, ModelDetail::kDrawn);
}

}  // namespace sidestep
